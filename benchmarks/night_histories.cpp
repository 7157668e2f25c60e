// Robots that map one office night after night: whether the archive sees which of them decays, and
// that a door was walled up.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "FloorPlan.h"
#include "Random.h"
#include "drive_office.h"
#include "map_error.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/archive/add_run.h"
#include "roomgraph/archive/watch_site.h"
#include "roomgraph/base/statistics.h"
#include "roomgraph/base/time_text.h"
#include "run_benchmark.h"
#include "sample_office.h"
#include "write_map.h"

namespace roomgraph {
namespace {

constexpr int kDecayBegins = 20, kLimitPassed = 40, kDoorWalledUp = 30;
constexpr double kSound = 0.1;            // map error of a robot that is well [m]
constexpr double kFirstDay = 1767225600;  // 2026-01-01
constexpr double kMetresPerFrame = 2.5;
const char* const kSite = "office";

struct NightsOptions {
  int nights = 60;
  std::size_t most = 6;
  std::string folder = ".";
};

/** A robot, and what the archive says of it. */
struct Robot {
  std::string name;
  bool decays = false;
  int tornEvery = 0;  ///< nights; 0 for never
  std::vector<double> truths{}, told{};
  std::optional<int> firstAlarm{};
  int alarms = 0;
  bool isAlarm = false;
};

/** The second door of the middle room below [m, map frame]. */
constexpr Point kDoorLow{12.4, -1.08}, kDoorHigh{13.5, -0.92};

/** The office without that door. */
SampleOffice withoutDoor(SampleOffice site) {
  GreyMap& office = site.map;
  const Cell low = office.frame.cellAt(kDoorLow), high = office.frame.cellAt(kDoorHigh);
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) office.grey[office.frame.index({x, y})] = grey::kWall;
  // In by the first door, and out by it again.
  for (std::size_t i = 4; i + 2 < site.tour.size(); ++i) {
    const Point at = site.tour[i];
    const bool isInDoor = at.x > kDoorLow.x && at.x < kDoorHigh.x && std::abs(at.y + 1) < 0.2;
    if (!isInDoor) continue;
    site.tour[i] = site.tour[i - 2], site.tour[i + 1] = site.tour[i - 3];
    site.tour.insert(site.tour.begin() + std::ptrdiff_t(i) + 2, site.tour[i - 4]);
    break;
  }
  return site;
}

/** The same round from another corner on, every second time the other way round. */
std::vector<Point> tourOf(const SampleOffice& office, std::uint32_t seed) {
  std::vector<Point> corners(office.tour.begin(), office.tour.end() - 1);
  std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(seed % corners.size()),
              corners.end());
  if (seed / 2 % 2 == 1) std::reverse(corners.begin(), corners.end());
  corners.push_back(corners.front());
  return corners;
}

DriveOfficeOptions driveOf(std::uint32_t seed, double turnNoise) {
  DriveOfficeOptions options;
  options.seed = seed, options.metresPerFrame = kMetresPerFrame;
  options.turn = 0.1 * double(seed % 63);
  options.drift.turnNoise = turnNoise, options.drift.seed = seed;
  return options;
}

/** The map error of a robot whose turns are noisy by 1, in the median over some drives [m]. */
double errorPerNoise(const SampleOffice& office) {
  constexpr double kNoise = 0.001;
  std::vector<double> errors;
  for (std::uint32_t seed = 1; seed <= 25; ++seed) {
    const OfficeDrive drive =
        driveOffice(office.map, tourOf(office, seed), driveOf(5000 + seed, kNoise));
    errors.push_back(mapError(drive.frames, drive.truth) / kNoise);
  }
  return median(errors);
}

/** The error that a robot has in the median of such nights [m]. */
double levelOf(const Robot& robot, int night, double limit) {
  if (!robot.decays || night <= kDecayBegins) return kSound;
  return kSound + (limit - kSound) * (night - kDecayBegins) / (kLimitPassed - kDecayBegins);
}

class Nights {
 public:
  explicit Nights(const NightsOptions& options)
      : options_(options),
        before_(sampleOffice()),
        after_(withoutDoor(before_)),
        archive_(options.folder + "/nights.db", Archive::Access::orNew),
        perNoise_(errorPerNoise(before_)) {}

  void pass(int night) {
    for (std::size_t i = 0; i < robots_.size(); ++i) drive(robots_[i], night, i);
    const SiteWatch watch = watchSite(archive_.history(kSite), watched_);
    for (const RobotWatch& of : watch.robots)
      for (Robot& robot : robots_) {
        if (robot.name != of.robot) continue;
        const bool isAlarm = of.errors.isAlarm();
        if (isAlarm && !robot.isAlarm) ++robot.alarms;
        if (isAlarm && !robot.firstAlarm) robot.firstAlarm = night;
        robot.isAlarm = isAlarm;
      }
  }

  void tell() const {
    std::printf(
        "| robot | nights | error told within 1.5 or 3 cm | alarms | first alarm in night |\n"
        "|---|---|---|---|---|\n");
    for (const Robot& robot : robots_) {
      std::size_t near = 0;
      for (std::size_t i = 0; i < robot.told.size(); ++i) {
        const double told = robot.told[i], truth = robot.truths[i];
        near += std::abs(told - truth) <= 0.03 || (told <= 1.5 * truth && truth <= 1.5 * told);
      }
      std::printf("| %s | %zu | %.0f %% | %d | %s |\n", robot.name.c_str(), robot.told.size(),
                  100.0 * double(near) / double(std::max<std::size_t>(1, robot.told.size())),
                  robot.alarms,
                  robot.firstAlarm ? std::to_string(*robot.firstAlarm).c_str() : "none");
    }
    const SiteHistory history = archive_.history(kSite);
    for (const RoomChange& change : watchSite(history, watched_).changes)
      std::printf("%s (night %.0f)\n", changeText(change, history).c_str(),
                  (history.runs[change.run].time - kFirstDay) / kDay);
  }

 private:
  void drive(Robot& robot, int night, std::size_t hour) {
    const auto seed = std::uint32_t(10 * night + int(hour) + 1);
    DriveOfficeOptions options = driveOf(seed, levelOf(robot, night, watched_.limit) / perNoise_);
    if (robot.tornEvery > 0 && night % robot.tornEvery == robot.tornEvery - 1)
      options.drift.breakAt = 40, options.drift.breakTurn = 0.15;
    const SampleOffice& office = night < kDoorWalledUp ? before_ : after_;
    const OfficeDrive driven = driveOffice(office.map, tourOf(office, seed), options);
    const std::string file =
        options_.folder + "/" + robot.name + std::to_string(night) + ".simplemap.gz";
    writeSimplemap(driven.frames, file);
    AddRunOptions add;
    add.site = kSite, add.robot = robot.name, add.most = options_.most;
    add.time = kFirstDay + kDay * night + 3600.0 * double(hour);
    const AddedRun added = addRun(archive_, file, add);
    if (!added.score || !added.score->isMeaningful) return;
    robot.truths.push_back(mapError(driven.frames, driven.truth));
    robot.told.push_back(added.score->mapError);
  }

  NightsOptions options_;
  SampleOffice before_, after_;
  Archive archive_;
  double perNoise_;
  WatchOptions watched_;
  std::vector<Robot> robots_{{"sound"}, {"decaying", true}, {"torn", false, 15}};
};

}  // namespace
}  // namespace roomgraph

int main(int argc, char** argv) {
  CLI::App app(
      "Lets three robots map an office night after night and keeps their runs in an archive. One "
      "of them decays from the 20th night on, so that it passes the limit in the 40th; one is torn "
      "in each 15th night; in the 30th a door is walled up.");
  roomgraph::NightsOptions options;
  app.add_option("--nights", options.nights, "nights")->capture_default_str();
  app.add_option("--compare-with", options.most, "runs that each is compared with")
      ->capture_default_str();
  app.add_option("-o,--output", options.folder,
                 "folder for the maps and nights.db, which must exist and be empty")
      ->capture_default_str();
  return roomgraph::runBenchmark(app, argc, argv, [&] {
    roomgraph::Nights nights(options);
    for (int night = 0; night < options.nights; ++night) nights.pass(night);
    nights.tell();
  });
}
