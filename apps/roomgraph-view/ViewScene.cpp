#include "ViewScene.h"

#include <algorithm>

#include "draw_marks.h"
#include "draw_stage.h"
#include "read_place.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/colours.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/mrpt_plugin/draw_comparison.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"
#include "roomgraph/mrpt_plugin/fault_files.h"
#include "roomgraph/mrpt_plugin/shapes.h"

namespace roomgraph {
namespace {

constexpr double kFaint = 0.3;         // share of its colour that a faint wall keeps
constexpr double kRobotRadius = 0.25;  // [m]
constexpr mrpt::img::TColor kScan{200, 30, 30}, kRobot{20, 20, 20}, kText{30, 34, 40};

constexpr const char *kBreaks = "breaks", *kRoomNames = "room names";
constexpr const char* kGraphParts[] = {"map",       "rooms",    "room outlines", "ways in rooms",
                                       "corridors", "vertices", "room numbers"};

/** Points are never transparent, so faint ones have the colour that they would have. */
mrpt::img::TColor wallColour(std::size_t run, bool isFaint) {
  const Colour full = runColour(run);
  if (!isFaint) return mrptColour(full);
  const auto mixed = [](std::uint8_t colour, std::uint8_t paper) {
    return std::uint8_t(kFaint * colour + (1 - kFaint) * paper);
  };
  return {mixed(full.red, kBackgroundColour.red), mixed(full.green, kBackgroundColour.green),
          mixed(full.blue, kBackgroundColour.blue)};
}

/** Of all that is drawn, as the screen has it. */
Box boxOf(const View& view) {
  if (view.graph) return drawnBox(*view.graph);
  Box box;
  for (const ComparedRun& run : view.comparison.runs) {
    const Motion2D move(view.onScreen() * run.pose);
    if (const Run* map = view.runNamed(run.name))
      for (const WallPoint& wall : map->map.walls) box.include(move(wall.place));
    for (const PathPose& at : run.path) box.include(view.onScreen()(at.pose.shift()));
  }
  return box.isEmpty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : box;
}

}  // namespace

std::string nameOfLayer(const std::string& layer) {
  const std::string ofRuns = runLayer("");
  return layer.rfind(ofRuns, 0) == 0 ? layer.substr(ofRuns.size()) : layer;
}

void clipFor(double away, MrptScene& scene) {
  scene.getViewport()->setViewportClipDistances(float(0.1 * away), float(5 * away + 10));
}

double lookDown(MrptScene& scene, const Box& box, double turn, double aspect) {
  lookFromAbove(scene, box, turn);
  const Point size = box.high - box.low;
  const double half = std::max(size.y, size.x / aspect) / 2;
  // Without perspective, so that layers lie on each other. MRPT then shows half of this in height.
  const double away = 2 * 2.16 * half;
  auto& camera = scene.getViewport()->getCamera();
  camera.setElevationDegrees(90);
  camera.setProjectiveModel(false);
  camera.setZoomDistance(float(away));
  clipFor(away, scene);
  return away;
}

ViewScene::ViewScene(const View& view)
    : view_(view),
      scene_(MrptScene::Create()),
      frame_(setNamed("key frame")),
      fault_(setNamed("fault")),
      stage_(setNamed("stage")),
      marks_(setNamed("marks")),
      box_(boxOf(view)) {
  if (view.graph)
    drawGraphAgain();
  else
    addComparison();
  addPaths();
  for (const auto& set : {stage_, fault_, frame_, marks_}) scene_->insert(set);
  lookDown(*scene_, box_, view.turn, 1.5);
}

void ViewScene::addLayer(const std::string& name, const viz::CSetOfObjects::Ptr& objects) {
  objects->setName(name);
  scene_->insert(objects);
  layers_.push_back(name);
}

void ViewScene::addComparison() {
  if (view_.runs.size() > 1) addLayer(kDisagreement, drawDisagreement(view_));
  MrptScene drawn = comparisonScene(view_.comparison, view_.runs);
  std::vector<std::string> names;
  for (const ComparedRun& run : view_.comparison.runs) names.push_back(runLayer(run.name));
  names.insert(names.end(), {"rooms", kRoomNames, kBreaks});
  for (const std::string& name : names)
    if (const auto object = drawn.getByName(name)) {
      scene_->insert(object);
      layers_.push_back(name);
    }
}

void ViewScene::drawGraphAgain() {
  const auto old = std::dynamic_pointer_cast<viz::CSetOfObjects>(scene_->getByName("room graph"));
  const auto graph = drawGraph(*view_.graph, old);
  if (old) scene_->removeObject(old);
  scene_->insert(graph);
  shownStage_.reset();
  for (const char* name : kGraphParts)
    if (graph->getByName(name) && !contains(layers_, name)) layers_.push_back(name);
}

void ViewScene::addPaths() {
  auto paths = viz::CSetOfObjects::Create();
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i) {
    if (view_.path(i).empty()) continue;
    auto path = drawPath(view_.path(i));
    path->setName("path " + std::to_string(i));
    paths->insert(path);
  }
  if (!paths->empty()) addLayer("paths", paths);
}

/** Where the scans at a fault are shown in both poses already. */
bool ViewScene::isAtFault(const ViewState& state) const {
  if (!state.fault) return false;
  const auto& keyFrame = view_.faults[*state.fault].keyFrame;
  return keyFrame && placeInPath(view_, state.run, *keyFrame) == state.frame;
}

void ViewScene::updateFrame(const ViewState& state) {
  frame_->clear();
  const ComparedRun& compared = view_.comparison.runs[state.run];
  if (state.frame >= compared.path.size()) return;
  const Transform2D at = compared.path[state.frame].pose;
  frame_->insert(diskAt(at.shift(), kFrameHeight, kRobot, kRobotRadius, 0.6 * kRobotRadius));
  const Point front = at(Point{2 * kRobotRadius, 0});
  frame_->insert(linesAt({{at.shift(), front}}, kFrameHeight, kRobot, 3));
  const Run* run = view_.runNamed(compared.name);
  if (!run || state.frame >= run->scans.size() || isAtFault(state)) return;
  const Motion2D move(compared.pose);
  std::vector<Point> walls;
  for (std::size_t k = state.growsMap ? 0 : state.frame; k <= state.frame; ++k)
    for (const WallPoint& wall : run->scans[k].walls) walls.push_back(move(wall.place));
  frame_->insert(pointsAt(walls, kFrameHeight, kScan, 4));
}

void ViewScene::updateFault(const ViewState& state) {
  if (state.fault == shownFault_) return;
  shownFault_ = state.fault;
  fault_->clear();
  if (!state.fault) return;
  MrptScene drawn = faultScene(view_.comparison, view_.faults[*state.fault], view_.runs);
  for (const FaultPart& part : kFaultParts)
    if (const auto object = drawn.getByName(part.name)) {
      object->setLocation(0, 0, kPathHeight);
      fault_->insert(object);
    }
}

void ViewScene::updateStage(const ViewState& state) {
  if (state.stage == shownStage_) return;
  shownStage_ = state.stage;
  stage_->clear();
  if (state.stage && view_.stages) stage_->insert(drawStage(*view_.stages, *state.stage));
}

void ViewScene::updateMarks(const ViewState& state) {
  marks_->clear();
  if (!state.corners.empty()) marks_->insert(drawRuler(state.corners));
  if (state.mode == Mode::look) marks_->insert(drawRead(view_, state));
  if (state.mode == Mode::swipe) marks_->insert(drawSwipe(view_, state, box_, *scene_));
}

void ViewScene::hideLayers(const ViewState& state) {
  for (const std::string& name : layers_)
    if (const auto object = scene_->getByName(name))
      object->setVisibility(state.hidden.count(name) == 0);
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i)
    if (const auto path = scene_->getByName("path " + std::to_string(i)))
      path->setVisibility(i == state.run && !state.fault);
  // The two poses tell more of the fault that is looked at; other words would hide them.
  for (const char* name : {kBreaks, kRoomNames})
    if (const auto words = scene_->getByName(name); words && state.fault)
      words->setVisibility(false);
  hideGraph(state);
  hideRuns(state);
}

/** A stage takes the place of the graph, as do the scans of a fault; a map that grows is the only
 *  one. */
void ViewScene::hideGraph(const ViewState& state) {
  if (!view_.graph) return;
  for (const char* name : kGraphParts) {
    const bool isMap = name == kGraphParts[0];
    const auto part = scene_->getByName(name);
    if (part && (((state.stage || state.fault) && !isMap) || (state.growsMap && !state.stage)))
      part->setVisibility(false);
  }
}

/** Which runs are seen, and how clearly. */
void ViewScene::hideRuns(const ViewState& state) {
  const auto other = otherRun(view_, state);
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i) {
    const auto walls = scene_->getByName(runLayer(view_.comparison.runs[i].name));
    if (!walls) continue;
    const Transform2D pose = shownPose(view_, state, i);
    walls->setPose(mrpt::poses::CPose3D(pose.x, pose.y, walls->getPose().z, pose.phi, 0, 0));
    // What was seen at a fault is to stand out from the maps.
    const bool isShownThere = state.fault && state.other == i;
    walls->setColor_u8(wallColour(i, state.fault && !isShownThere));
    if (state.mode == Mode::swipe) walls->setVisibility(false);
    if (state.mode == Mode::nudge) walls->setVisibility(i == state.run || i == other);
    if (state.isFlickering) walls->setVisibility(i == (state.isFlicked ? *other : state.run));
    if (state.fault && state.other) walls->setVisibility(isShownThere);
    if (state.growsMap && i == state.run) walls->setVisibility(false);
  }
}

void ViewScene::write(const ViewState& state) {
  const auto viewport = scene_->getViewport();
  viewport->clearTextMessages();
  viz::TFontParams font;
  font.vfont_name = "sans", font.vfont_scale = 12;
  font.color = mrpt::img::TColorf(kText);
  font.draw_shadow = true, font.shadow_color = {1, 1, 1, 1};
  constexpr double lineHeight = 18, fromTop = 24;  // [px]
  std::size_t count = 0;
  const auto addLine = [&](const std::string& line) {
    viewport->addTextMessage(10, -fromTop - lineHeight * double(count), line, count, font);
    ++count;
  };
  for (const std::string& line : readState(view_, state)) addLine(line);
  if (!state.fault) return;
  for (const FaultPart& part : kFaultParts) {
    font.color = mrpt::img::TColorf(part.colour);
    addLine(part.name);
  }
}

void ViewScene::update(const ViewState& state) {
  updateFrame(state);
  updateFault(state);
  updateStage(state);
  updateMarks(state);
  hideLayers(state);
}

Box ViewScene::boxAt(const Fault& fault) const {
  std::vector<Point> places{fault.place};
  for (std::size_t r = 0; r < view_.comparison.runs.size(); ++r)
    if (view_.comparison.runs[r].name == fault.run && fault.keyFrame && !view_.path(r).empty()) {
      const Point drawn = view_.path(r)[placeInPath(view_, r, *fault.keyFrame)].pose.shift();
      places.push_back(drawn);
      if (fault.mend) places.push_back((*fault.mend)(drawn));
    }
  for (Point& place : places) place = view_.onScreen()(place);
  return boundingBox(places).widened(8);  // what a scan shows round the robot [m]
}

}  // namespace roomgraph
