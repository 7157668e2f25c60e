#include "ViewScene.h"

#include <algorithm>
#include <cmath>

#include "read_place.h"
#include "roomgraph/drawing/run_marks.h"
#include "roomgraph/mrpt_plugin/break_files.h"
#include "roomgraph/mrpt_plugin/colors.h"
#include "roomgraph/mrpt_plugin/comparison_scene.h"
#include "roomgraph/mrpt_plugin/draw_graph.h"

namespace roomgraph {
namespace {

constexpr double kPathHeight = 2, kFrameHeight = 2.2;  // above all maps [m]
constexpr double kWorstError = 0.5;                    // drawn red from here on [m]
constexpr std::uint8_t kFaint = 70;                    // of 255
constexpr float kDotRadius = 0.08f;                    // of a key frame [m]
constexpr float kRobotRadius = 0.25f;                  // [m]
constexpr mrpt::img::TColor kScan{200, 30, 30}, kRobot{20, 20, 20}, kText{30, 34, 40};

/** From green over yellow to red; blue where it cannot be told. */
mrpt::img::TColor colourOfError(const std::optional<double>& error) {
  if (!error) return {0, 82, 155};
  const double bad = std::clamp(*error / kWorstError, 0.0, 1.0);
  return {std::uint8_t(230 * std::min(1.0, 2 * bad)),
          std::uint8_t(170 * std::min(1.0, 2 - 2 * bad)), 40};
}

viz::CSetOfObjects::Ptr pathOf(const std::vector<PathPose>& path) {
  auto set = viz::CSetOfObjects::Create();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    auto piece = viz::CSetOfLines::Create();
    piece->setLineWidth(3);
    piece->setColor_u8(colourOfError(path[k + 1].error));
    const Transform2D &a = path[k].pose, &b = path[k + 1].pose;
    piece->appendLine(a.x, a.y, kPathHeight, b.x, b.y, kPathHeight);
    set->insert(piece);
  }
  for (const PathPose& at : path) {
    auto disk = viz::CDisk::Create(kDotRadius, 0.0f);
    disk->setColor_u8(colourOfError(at.error));
    disk->setLocation(at.pose.x, at.pose.y, kPathHeight);
    set->insert(disk);
  }
  return set;
}

viz::CSetOfObjects::Ptr setNamed(const char* name) {
  auto set = viz::CSetOfObjects::Create();
  set->setName(name);
  return set;
}

Box boxOf(const View& view) {
  if (view.graph) return drawnBox(*view.graph);
  std::vector<Point> places;
  for (const ComparedRun& run : view.comparison.runs) {
    const Motion2D move(run.pose);
    if (const Run* map = view.runNamed(run.name))
      for (const WallPoint& wall : map->map.walls) places.push_back(move(wall.place));
    for (const PathPose& at : run.path) places.push_back(at.pose.shift());
  }
  return places.empty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : boundingBox(places);
}

void addScan(const ScanWalls& scan, const Transform2D& pose, viz::CPointCloud& cloud) {
  const Motion2D move(pose);
  for (const WallPoint& wall : scan.walls) {
    const Point p = move(wall.place);
    cloud.insertPoint(float(p.x), float(p.y), float(kFrameHeight));
  }
}

}  // namespace

void clipFor(double away, MrptScene& scene) {
  scene.getViewport()->setViewportClipDistances(float(0.1 * away), float(5 * away + 10));
}

double lookDown(MrptScene& scene, const Box& box, double aspect) {
  const auto view = scene.getViewport();
  view->setCustomBackgroundColor(
      {kBackgroundColor.r / 255.F, kBackgroundColor.g / 255.F, kBackgroundColor.b / 255.F});
  makeEven(view->lightParameters());
  const Point middle = midpoint(box.low, box.high), size = box.high - box.low;
  const double half = std::max(size.y, size.x / aspect) / 2;
  // Without perspective, so that layers lie on each other. MRPT then shows half of this in height.
  const double away = 2 * 2.16 * half;
  auto& camera = view->getCamera();
  camera.setPointingAt(float(middle.x), float(middle.y), 0);
  camera.setAzimuthDegrees(-90);  // y up, as on the map
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
      tear_(setNamed("break")),
      box_(boxOf(view)) {
  if (view.graph)
    drawGraphAgain();
  else
    addComparison();
  addPaths();
  scene_->insert(tear_);
  scene_->insert(frame_);
  lookDown(*scene_, box_, 1.5);
}

void ViewScene::addLayer(const std::string& name, const viz::CSetOfObjects::Ptr& objects) {
  objects->setName(name);
  scene_->insert(objects);
  layers_.push_back(name);
}

void ViewScene::addComparison() {
  MrptScene drawn = comparisonScene(view_.comparison, view_.runs);
  std::vector<std::string> names;
  for (const ComparedRun& run : view_.comparison.runs) names.push_back(run.name);
  names.insert(names.end(), {"rooms", "room names", "breaks"});
  for (const std::string& name : names)
    if (const auto object = drawn.getByName(name)) {
      scene_->insert(object);
      layers_.push_back(name);
    }
}

void ViewScene::drawGraphAgain() {
  const auto graph = drawGraph(*view_.graph);
  if (const auto old = scene_->getByName("room graph")) scene_->removeObject(old);
  scene_->insert(graph);
  for (const char* name :
       {"map", "rooms", "room outlines", "ways in rooms", "corridors", "vertices", "room numbers"})
    if (graph->getByName(name) && std::find(layers_.begin(), layers_.end(), name) == layers_.end())
      layers_.push_back(name);
}

void ViewScene::addPaths() {
  auto paths = viz::CSetOfObjects::Create();
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i) {
    if (view_.path(i).empty()) continue;
    auto path = pathOf(view_.path(i));
    path->setName("path " + std::to_string(i));
    paths->insert(path);
  }
  addLayer("paths", paths);
}

/** Where the scans at a break are shown in both poses already. */
bool ViewScene::isAtBreak(const ViewState& state) const {
  return state.tear && view_.comparison.breaks[*state.tear].keyFrame == state.frame;
}

void ViewScene::updateFrame(const ViewState& state) {
  frame_->clear();
  const ComparedRun& compared = view_.comparison.runs[state.run];
  if (state.frame >= compared.path.size()) return;
  const Transform2D at = compared.path[state.frame].pose;
  auto robot = viz::CDisk::Create(kRobotRadius, 0.6f * kRobotRadius);
  robot->setColor_u8(kRobot);
  robot->setLocation(at.x, at.y, kFrameHeight);
  frame_->insert(robot);
  auto nose = viz::CSetOfLines::Create();
  nose->setColor_u8(kRobot);
  nose->setLineWidth(3);
  const Point front = at(Point{2 * double(kRobotRadius), 0});
  nose->appendLine(at.x, at.y, kFrameHeight, front.x, front.y, kFrameHeight);
  frame_->insert(nose);
  const Run* run = view_.runNamed(compared.name);
  if (!run || state.frame >= run->scans.size() || isAtBreak(state)) return;
  auto cloud = viz::CPointCloud::Create();
  cloud->setColor_u8(kScan);
  cloud->setPointSize(4);
  for (std::size_t k = state.growsMap ? 0 : state.frame; k <= state.frame; ++k)
    addScan(run->scans[k], compared.pose, *cloud);
  frame_->insert(cloud);
}

void ViewScene::updateBreak(const ViewState& state) {
  if (state.tear == shownBreak_) return;
  shownBreak_ = state.tear;
  tear_->clear();
  if (!state.tear) return;
  MrptScene drawn = breakScene(view_.comparison, view_.comparison.breaks[*state.tear], view_.runs);
  for (const char* name : {"before", "drawn", "untorn"})
    if (const auto object = drawn.getByName(name)) {
      object->setLocation(0, 0, kPathHeight);
      tear_->insert(object);
    }
}

void ViewScene::hideLayers(const ViewState& state) {
  for (const std::string& name : layers_)
    if (const auto object = scene_->getByName(name))
      object->setVisibility(state.hidden.count(name) == 0);
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i)
    if (const auto path = scene_->getByName("path " + std::to_string(i)))
      path->setVisibility(i == state.run && !state.tear);
  // What was seen at a break is to stand out from the maps.
  for (const ComparedRun& run : view_.comparison.runs)
    if (const auto walls = scene_->getByName(run.name))
      walls->setColorA_u8(state.tear ? kFaint : 255);
  if (!state.isFlickering) return;
  const std::size_t other = state.run == 0 ? 1 : 0;
  for (std::size_t i = 0; i < view_.comparison.runs.size(); ++i)
    if (const auto walls = scene_->getByName(view_.comparison.runs[i].name))
      walls->setVisibility(i == (state.isFlicked ? other : state.run));
}

void ViewScene::write(const std::vector<std::string>& above,
                      const std::vector<std::string>& below) {
  const auto viewport = scene_->getViewport();
  viewport->clearTextMessages();
  mrpt::opengl::TFontParams font;
  font.vfont_name = "sans", font.vfont_scale = 12;
  font.color = mrpt::img::TColorf(kText);
  font.draw_shadow = true, font.shadow_color = {1, 1, 1, 1};
  constexpr double lineHeight = 18, fromTop = 24, fromBottom = 8;  // [px]
  for (std::size_t i = 0; i < above.size(); ++i)
    viewport->addTextMessage(10, -fromTop - lineHeight * double(i), above[i], i, font);
  for (std::size_t i = 0; i < below.size(); ++i)
    viewport->addTextMessage(10, fromBottom + lineHeight * double(below.size() - 1 - i), below[i],
                             above.size() + i, font);
}

void ViewScene::update(const ViewState& state, const std::vector<std::string>& below) {
  updateFrame(state);
  updateBreak(state);
  hideLayers(state);
  write(readState(view_, state), below);
}

Box ViewScene::boxAt(const MapBreak& tear) const {
  std::vector<Point> places{tear.place};
  if (tear.torn) places = {tear.torn->drawn.shift(), tear.torn->untorn.shift(), tear.place};
  Box box = boundingBox(places);
  constexpr double margin = 8;  // what a scan shows round the robot [m]
  return {box.low - Point{margin, margin}, box.high + Point{margin, margin}};
}

}  // namespace roomgraph
