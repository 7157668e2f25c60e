#include "Pose.h"

#include <utility>

namespace roomgraph::test {
namespace {

/** The cell of `text` that lies at (x, y) of the turned, unscaled, unpadded drawing. */
char cellAt(const MapText& text, const Pose& pose, int x, int y) {
  const int width = pose.isTransposed ? text.height : text.width;
  const int height = pose.isTransposed ? text.width : text.height;
  if (x < 0 || y < 0 || x >= width || y >= height) return '?';
  if (pose.isFlippedX) x = width - 1 - x;
  if (pose.isFlippedY) y = height - 1 - y;
  if (pose.isTransposed) std::swap(x, y);
  return text.cells[std::size_t(y) * std::size_t(text.width) + std::size_t(x)];
}

}  // namespace

std::string nameOf(const Pose& pose) {
  return std::string(pose.isTransposed ? "transposed " : "") +
         (pose.isFlippedX ? "flipped in x " : "") + (pose.isFlippedY ? "flipped in y " : "") +
         "padded by " + std::to_string(pose.padding) + " scaled by " + std::to_string(pose.scale) +
         (pose.shift == Point{} ? "" : " shifted");
}

std::vector<Pose> symmetries() {
  std::vector<Pose> poses;
  for (int i = 0; i < 8; ++i) {
    Pose pose;
    pose.isTransposed = (i & 4) != 0;
    pose.isFlippedX = (i & 2) != 0;
    pose.isFlippedY = (i & 1) != 0;
    poses.push_back(pose);
  }
  return poses;
}

std::vector<Pose> allPoses(const MapText& text) {
  std::vector<Pose> poses;
  for (const Pose& plain : symmetries()) {
    poses.push_back(plain);
    poses.push_back(plain);
    poses.back().shift = {-17.31, 1234.567};
    for (const int scale : {2, 4}) {
      if (text.preset == "paper" || !text.notResampled.empty()) break;  // it counts in cells
      poses.push_back(plain);
      poses.back().scale = scale;
    }
    if (!hasUnknown(text)) continue;
    poses.push_back(plain);
    poses.back().padding = 7;
  }
  return poses;
}

MapText posed(const MapText& text, const Pose& pose) {
  MapText result = text;
  const int width = (pose.isTransposed ? text.height : text.width) + 2 * pose.padding;
  const int height = (pose.isTransposed ? text.width : text.height) + 2 * pose.padding;
  result.width = width * pose.scale;
  result.height = height * pose.scale;
  result.resolution = text.resolution / pose.scale;
  result.origin = text.origin + pose.shift;
  result.cells.clear();
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      result.cells.push_back(
          cellAt(text, pose, x / pose.scale - pose.padding, y / pose.scale - pose.padding));
  for (auto& [name, at] : result.names) at = posed(at, text, pose);
  return result;
}

Point posed(Point p, const MapText& text, const Pose& pose) {
  p = p - text.origin;
  double width = text.width * text.resolution, height = text.height * text.resolution;
  if (pose.isTransposed) {
    std::swap(p.x, p.y);
    std::swap(width, height);
  }
  if (pose.isFlippedX) p.x = width - p.x;
  if (pose.isFlippedY) p.y = height - p.y;
  const double padding = pose.padding * text.resolution;
  return p + Point{padding, padding} + text.origin + pose.shift;
}

}  // namespace roomgraph::test
