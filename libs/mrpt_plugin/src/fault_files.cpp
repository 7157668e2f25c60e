#include "roomgraph/mrpt_plugin/fault_files.h"

#include <algorithm>
#include <iterator>

#include "object_bytes.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/mrpt_files.h"
#include "roomgraph/mrpt_plugin/shapes.h"
#include "roomgraph/report/upright_turn.h"

namespace roomgraph {
namespace {

constexpr mrpt::img::TColor kOthers{150, 156, 166};
constexpr double kLayerStep = 0.05;    // between layers, so that none hides in another [m]
constexpr double kRobotMark = 0.15;    // [m]
constexpr double kLetterShare = 0.03;  // of the width of what is shown

/** What some key frames saw, and the way of the robot. */
class Piece {
 public:
  Piece(const FaultPart& part, double height) : part_(part), height_(height) {}

  void add(const ScanWalls& scan, const Transform2D& siteFromRun) {
    const Motion2D move(siteFromRun);
    for (const WallPoint& wall : scan.walls) walls_.push_back(move(wall.place));
    way_.push_back(move(scan.robot()));
  }

  void addTo(MrptScene& scene, std::vector<Point>& shown) const {
    if (way_.empty()) return;
    auto set = setNamed(part_.name);
    set->insert(pointsAt(walls_, height_, part_.colour, 4));
    std::vector<Segment> steps;
    for (std::size_t k = 0; k + 1 < way_.size(); ++k) steps.emplace_back(way_[k], way_[k + 1]);
    set->insert(linesAt(steps, height_, part_.colour, 3));
    for (const Point at : way_) set->insert(diskAt(at, height_, part_.colour, kRobotMark));
    scene.insert(set);
    shown.insert(shown.end(), walls_.begin(), walls_.end());
    shown.insert(shown.end(), way_.begin(), way_.end());
  }

 private:
  FaultPart part_;
  double height_;
  std::vector<Point> walls_, way_;
};

/** The names of the parts that the scene has, above the box, which grows by them; the scene is
 *  turned by `turn` [rad]. */
void addNames(MrptScene& scene, Box& box, double turn) {
  const double height = kLetterShare * (box.high.x - box.low.x);
  const Transform2D level{0, 0, -turn};
  for (const FaultPart& part : kFaultParts) {
    if (!scene.getByName(part.name)) continue;
    auto text = viz::CText3D::Create(part.name, "sans", height, viz::FILL);
    text->setColor_u8(part.colour);
    const Point place = level(Point{box.low.x, box.high.y});
    text->setPose(mrpt::poses::CPose3D(place.x, place.y, kLayerStep, level.phi, 0, 0));
    scene.insert(text);
    box.high.y += 1.5 * height;
  }
}

/** The walls of the best run but this one. */
void addOthers(const Comparison& comparison, const Fault& fault, const std::vector<Run>& runs,
               MrptScene& scene) {
  for (const ComparedRun& other : comparison.runs) {
    const Run* run = findRun(runs, other.name);
    if (other.name == fault.run || !run) continue;
    const Motion2D move(other.pose);
    std::vector<Point> walls;
    for (const WallPoint& wall : run->map.walls) walls.push_back(move(wall.place));
    auto cloud = pointsAt(walls, 0, kOthers, 3);
    cloud->setName(runLayer(other.name));
    scene.insert(cloud);
    return;
  }
}

}  // namespace

MrptScene faultScene(const Comparison& comparison, const Fault& fault,
                     const std::vector<Run>& runs) {
  MrptScene scene;
  const double turn = uprightTurn(comparison, runs);
  addOthers(comparison, fault, runs, scene);
  std::vector<Point> shown{fault.place};
  if (const Run* run = findRun(runs, fault.run)) {
    const ComparedRun* compared = findRun(comparison.runs, fault.run);
    const Transform2D pose = compared ? compared->pose : Transform2D();
    Piece before(kFaultParts[0], kLayerStep), drawn(kFaultParts[1], 2 * kLayerStep),
        untorn(kFaultParts[2], 3 * kLayerStep);
    for (const ScanWalls& scan : run->scans) {
      if (fault.earlier.holds(scan.keyFrame)) before.add(scan, pose);
      if (!fault.later.holds(scan.keyFrame)) continue;
      drawn.add(scan, pose);
      if (fault.mend) untorn.add(scan, *fault.mend * pose);
    }
    for (const Piece* piece : {&before, &drawn, &untorn}) piece->addTo(scene, shown);
  }
  for (Point& place : shown) place = Transform2D{0, 0, turn}(place);
  Box box = boundingBox(shown).widened(1);
  addNames(scene, box, turn);
  lookFromAbove(scene, box, turn);
  return scene;
}

std::string faultSceneBytes(const Comparison& comparison, const Fault& fault,
                            const std::vector<Run>& runs) {
  return gzippedObject(faultScene(comparison, fault, runs));
}

std::vector<PlacedScan> scansAtFault(const Fault& fault, const Transform2D& pose,
                                     const std::vector<PlacedScan>& all, bool isUntorn) {
  const auto scansOf = [&](const KeyFrames& range, const Transform2D& motion) {
    std::vector<PlacedScan> scans;
    std::copy_if(all.begin(), all.end(), std::back_inserter(scans),
                 [&](const PlacedScan& scan) { return range.holds(scan.keyFrame); });
    return moved(moved(std::move(scans), pose), motion);
  };
  std::vector<PlacedScan> scans = scansOf(fault.earlier, {}),
                          later = scansOf(fault.later,
                                          isUntorn && fault.mend ? *fault.mend : Transform2D{});
  std::move(later.begin(), later.end(), std::back_inserter(scans));
  return scans;
}

}  // namespace roomgraph
