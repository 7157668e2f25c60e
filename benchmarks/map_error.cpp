#include "map_error.h"

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose2D.h>

#include <cmath>

#include "roomgraph/geometry/MotionFit.h"

namespace roomgraph {
namespace {

/** Places as they are, and as the map has them. */
struct Places {
  std::vector<Point> are, has;
};

Places placesOf(const mrpt::maps::CSimpleMap& frames, const std::vector<WalkPose>& truth) {
  Places places;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    mrpt::poses::CPose3DPDF::ConstPtr pdf;
    mrpt::obs::CSensoryFrame::ConstPtr frame;
    frames.get(i, pdf, frame);
    const mrpt::poses::CPose2D mean(pdf->getMeanVal());
    const Transform2D has{mean.x(), mean.y(), mean.phi()};
    const Transform2D is{truth[i].place.x, truth[i].place.y, truth[i].heading};
    const auto scan = frame->getObservationByClass<mrpt::obs::CObservation2DRangeScan>();
    const double step = scan->aperture / double(scan->getScanSize() - 1);
    for (std::size_t k = 0; k < scan->getScanSize(); ++k) {
      if (!scan->getScanRangeValidity(k)) continue;
      const double angle = step * double(k) - scan->aperture / 2;
      const Point end = turned({scan->getScanRange(k), 0}, angle);
      places.are.push_back(is(end));
      places.has.push_back(has(end));
    }
  }
  return places;
}

}  // namespace

double mapError(const mrpt::maps::CSimpleMap& frames, const std::vector<WalkPose>& truth) {
  const Places places = placesOf(frames, truth);
  if (places.are.empty()) return 0;
  MotionFit fit;
  for (std::size_t i = 0; i < places.are.size(); ++i) fit.add(places.has[i], places.are[i]);
  const Transform2D isFromHas = fit.motion();
  double sum = 0;
  for (std::size_t i = 0; i < places.are.size(); ++i)
    sum += squaredNorm(isFromHas(places.has[i]) - places.are[i]);
  return std::sqrt(sum / double(places.are.size()));
}

}  // namespace roomgraph
