#include "roomgraph/graph_files/OsmOrigin.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace roomgraph {
namespace {

constexpr double kEquator = 6378137.0, kSquaredEccentricity = 0.00669437999014;  // of WGS84
constexpr double kDegree = M_PI / 180;

std::string degreesText(double degrees) {
  constexpr std::int64_t kUnit = 1000000000;
  const std::int64_t all = std::llround(degrees * double(kUnit));
  const std::string fraction = std::to_string(std::abs(all) % kUnit);
  return (all < 0 ? "-" : "") + std::to_string(std::abs(all) / kUnit) + "." +
         std::string(9 - fraction.size(), '0') + fraction;
}

}  // namespace

OsmOrigin::OsmOrigin(double latitude, double longitude, Point root)
    : latitude_(latitude), longitude_(longitude), root_(root) {
  const double sine = std::sin(latitude * kDegree), flat = 1 - kSquaredEccentricity * sine * sine;
  eastRadius_ = kEquator / std::sqrt(flat) * std::cos(latitude * kDegree);
  northRadius_ = kEquator * (1 - kSquaredEccentricity) / (flat * std::sqrt(flat));
}

Point OsmOrigin::placeAt(double latitude, double longitude) const {
  return {root_.x + (longitude - longitude_) * kDegree * eastRadius_,
          root_.y + (latitude - latitude_) * kDegree * northRadius_};
}

std::string OsmOrigin::latitudeText(Point place) const {
  return degreesText(latitude_ + (place.y - root_.y) / northRadius_ * 180 / M_PI);
}

std::string OsmOrigin::longitudeText(Point place) const {
  return degreesText(longitude_ + (place.x - root_.x) / eastRadius_ * 180 / M_PI);
}

}  // namespace roomgraph
