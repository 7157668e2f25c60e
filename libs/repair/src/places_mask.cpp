#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "MaskCells.h"
#include "fitted_repair.h"
#include "roomgraph/base/Error.h"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/checked_file.h"
#include "roomgraph/base/file_name.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/geometry/Polygon.h"
#include "roomgraph/graph_files/ros_map.h"
#include "roomgraph/images/png_bytes.h"
#include "roomgraph/images/read_image.h"
#include "roomgraph/repair/CellVotes.h"
#include "roomgraph/repair/places_formats.h"

namespace roomgraph {
namespace {

class Mask {
 public:
  Mask(const std::string& text, const std::string& file)
      : text_(text), file_(file), yaml_(readRosMapYaml(text, file)), greys_(yaml_) {
    CheckedFile picture(pictureOf(yaml_, file));
    isPgm_ = isPgm(picture.head());
    readImage(picture, picture_);
    picture_.frame.resolution = yaml_.resolution;
    const std::vector<std::uint8_t> isClear = readClearPixels(picture);
    std::vector<bool> isMarked;
    std::map<std::uint8_t, std::size_t> empty;
    for (std::size_t i = 0; i < picture_.grey.size(); ++i) {
      const bool isOpaque = isClear.empty() || !isClear[i];
      isMarked.push_back(isOpaque && greys_.isMarked(picture_.grey[i]));
      if (isOpaque && !isMarked.back()) ++empty[picture_.grey[i]];
    }
    const auto most =
        std::max_element(empty.begin(), empty.end(),
                         [](const auto& l, const auto& r) { return l.second < r.second; });
    background_ = most == empty.end() ? greys_.free() : most->first;
    regions_ = maskRegions(picture_.frame, isMarked);
    block_ = std::max(1, int(std::lround(fitted::kBlock / yaml_.resolution)));
  }

  MarkedFile marked() const {
    MarkedFile result;
    result.kind = "region", result.files = {fileName(file_), pictureName()};
    std::map<std::pair<int, int>, std::size_t> corners;
    for (const MaskRegion& region : regions_) {
      Thing& thing = result.things.emplace_back();
      const Point first = placeOf(middleOf(cellOf(region.front()))).pose.shift();
      thing.name = formatted("%zu, at (%.1f, %.1f)", result.things.size(), first.x, first.y);
      const auto blocks = blocksOf(region);
      for (const auto& [block, middle] : blocks) {
        thing.places.push_back(result.places.size());
        result.places.push_back(placeOf(middleOf(middle)));
        result.places.back().isCorner = blocks.size() > 1;
      }
      for (const auto& corner : cornersOf(region)) {
        const auto [known, isNew] = corners.emplace(corner, result.places.size());
        if (isNew)
          result.places.push_back(
              placeOf({double(corner.first * block_), double(corner.second * block_)}));
        thing.around.push_back(known->second);
      }
    }
    return result;
  }

  std::vector<NamedBytes> written(const std::vector<CarriedThing>& carried,
                                  const GridFrame& to) const {
    std::vector<Bent> bent;
    for (std::size_t i = 0; i < regions_.size(); ++i) bent.push_back(bentBy(i, carried[i]));
    const GridFrame frame = frameAround(to, bent);
    std::vector<std::uint8_t> grey(frame.cellCount(), background_);
    Json regions = Json::array();
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      draw(i, bent[i], frame, grey);
      regions.push_back(regionJson(i, carried[i]));
    }
    const std::string picture = pictureName();
    const Json origin = {rounded(frame.origin.x), rounded(frame.origin.y), 0};
    const std::string yaml = rosMapYamlWith(text_,
                                            {{"image", lineOf(Json(picture))},
                                             {"origin", lineOf(origin)},
                                             {"regions", lineOf(regions)}},
                                            file_);
    return {{fileName(file_), std::string(kRosMapMark) + "\n" + yaml},
            {picture, pictureBytes(grey, frame)}};
  }

 private:
  std::string pictureName() const {
    std::filesystem::path picture = std::filesystem::path(yaml_.image).filename();
    if (!isPgm_) picture.replace_extension(".png");
    return picture.string();
  }

  /** Where the corners of the blocks of a region lie on the new map. */
  using Bent = std::map<std::pair<int, int>, Point>;

  Cell cellOf(std::size_t index) const {
    const std::size_t width = std::size_t(picture_.frame.width);
    return {int(index % width), int(index / width)};
  }

  /** Of a point in cells of the picture. */
  Place placeOf(Point inPicture) const {
    const Transform2D corner{yaml_.origin.x, yaml_.origin.y, yaml_.yaw};
    const Point place = corner(yaml_.resolution * inPicture);
    return {"", {place.x, place.y, 0}};
  }

  std::pair<int, int> blockOf(Cell cell) const { return {cell.x / block_, cell.y / block_}; }

  /** The blocks that a region touches, each with its cell that is nearest to the middle. */
  std::map<std::pair<int, int>, Cell> blocksOf(const MaskRegion& region) const {
    std::map<std::pair<int, int>, Cell> blocks;
    const auto off = [&](const std::pair<int, int>& block, Cell cell) {
      const Point middle = (block_ / 2.0) * Point{2.0 * block.first + 1, 2.0 * block.second + 1};
      return squaredNorm(Point{cell.x + 0.5, cell.y + 0.5} - middle);
    };
    for (const std::size_t index : region) {
      const Cell cell = cellOf(index);
      const auto [known, isNew] = blocks.emplace(blockOf(cell), cell);
      if (!isNew && off(known->first, cell) < off(known->first, known->second))
        known->second = cell;
    }
    return blocks;
  }

  std::vector<std::pair<int, int>> cornersOf(const MaskRegion& region) const {
    std::vector<std::pair<int, int>> corners;
    for (const auto& [block, middle] : blocksOf(region))
      for (const int x : {0, 1})
        for (const int y : {0, 1}) corners.emplace_back(block.first + x, block.second + y);
    sortUnique(corners);
    return corners;
  }

  Bent bentBy(std::size_t i, const CarriedThing& carried) const {
    Bent bent;
    const auto corners = cornersOf(regions_[i]);
    const std::size_t first = carried.poses.size() - corners.size();
    for (std::size_t k = 0; k < corners.size(); ++k)
      bent[corners[k]] = carried.poses[first + k].shift();
    return bent;
  }

  /** Where a point of a cell lies, in cells of the picture: between the corners of its block. */
  Point bentPoint(const Bent& bent, std::pair<int, int> block, Point inPicture) const {
    const double x = inPicture.x / block_ - block.first, y = inPicture.y / block_ - block.second;
    const auto corner = [&](int right, int up) {
      return bent.at({block.first + right, block.second + up});
    };
    return (1 - y) * ((1 - x) * corner(0, 0) + x * corner(1, 0)) +
           y * ((1 - x) * corner(0, 1) + x * corner(1, 1));
  }

  GridFrame frameAround(const GridFrame& to, const std::vector<Bent>& bent) const {
    const double side = yaml_.resolution;
    Box box{to.origin, to.origin + to.resolution * Point{double(to.width), double(to.height)}};
    for (const Bent& region : bent)
      for (const auto& [corner, at] : region) box.include(at);
    GridFrame frame;
    frame.resolution = side;
    frame.origin = {side * std::floor(box.low.x / side), side * std::floor(box.low.y / side)};
    const double width = (box.high.x - frame.origin.x) / side + 1,
                 height = (box.high.y - frame.origin.y) / side + 1;
    if (!(width * height <= double(kMostCells)))
      refuse(file_,
             formatted("on the new map it would have %.0f x %.0f pixels, more than 400 million, to "
                       "hold what lies outside of that",
                       std::floor(width), std::floor(height)),
             "take out the zones that lie far off, or draw it with larger cells");
    frame.width = int(width), frame.height = int(height);
    return frame;
  }

  void draw(std::size_t i, const Bent& bent, const GridFrame& frame,
            std::vector<std::uint8_t>& grey) const {
    const auto mark = [&](std::size_t index, std::uint8_t level) {
      std::uint8_t& there = grey[index];
      if (!greys_.isMarked(there) || greys_.mark(level) > greys_.mark(there)) there = level;
    };
    for (const std::size_t index : regions_[i]) {
      const Cell cell = cellOf(index);
      const std::uint8_t level = picture_.grey[index];
      std::array<Point, 4> corners;
      const Point steps[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (std::size_t k = 0; k < 4; ++k)
        corners[k] =
            bentPoint(bent, blockOf(cell), Point{double(cell.x), double(cell.y)} + steps[k]);
      for (const Cell there : cellsIn(frame, corners))
        if (frame.contains(there)) mark(frame.index(there), level);
      for (const int side : {-1, 1}) {  // what touches at a corner alone goes on touching
        const Cell other{cell.x + side, cell.y + 1};
        if (!std::binary_search(regions_[i].begin(), regions_[i].end(), indexOf(other))) continue;
        passBeam(frame, middleOf(bent, cell), middleOf(bent, other),
                 [&](std::size_t passed) { mark(passed, level); });
      }
    }
  }

  static Point middleOf(Cell cell) { return {cell.x + 0.5, cell.y + 0.5}; }

  Point middleOf(const Bent& bent, Cell cell) const {
    return bentPoint(bent, blockOf(cell), middleOf(cell));
  }

  /** One that is in no region for a cell beside the picture. */
  std::size_t indexOf(Cell cell) const {
    return picture_.frame.contains(cell) ? picture_.frame.index(cell) : picture_.grey.size();
  }

  Json regionJson(std::size_t i, const CarriedThing& carried) const {
    const Point place =
        carried.poses[(carried.poses.size() - cornersOf(regions_[i]).size()) / 2].shift();
    Json json = {
        {"x", rounded(place.x)},
        {"y", rounded(place.y)},
        {"area_m2", rounded(double(regions_[i].size()) * yaml_.resolution * yaml_.resolution)},
        {"state", nameOf(carried.state)}};
    if (carried.error) json["error_m"] = rounded(*carried.error);
    if (!carried.reason.empty()) json["reason"] = carried.reason;
    return json;
  }

  std::string pictureBytes(const std::vector<std::uint8_t>& grey, const GridFrame& frame) const {
    return isPgm_ ? pgmBytes(grey, frame.width, frame.height)
                  : pngBytes(grey, frame.width, frame.height);
  }

  std::string text_, file_;
  RosMapYaml yaml_;
  MaskGreys greys_;
  GreyMap picture_;
  bool isPgm_ = false;
  std::uint8_t background_ = 255;
  std::vector<MaskRegion> regions_;
  int block_ = 1;
};

}  // namespace

bool looksLikeMask(const std::string& text) {
  return text.rfind("image:", 0) == 0 || text.find("\nimage:") != std::string::npos;
}

MarkedFile maskPlaces(const std::string& text, const std::string& file) {
  const auto mask = std::make_shared<const Mask>(text, file);
  MarkedFile marked = mask->marked();
  marked.write = [mask](const std::vector<CarriedThing>& carried, const GridFrame& frame) {
    return mask->written(carried, frame);
  };
  return marked;
}

}  // namespace roomgraph
