#include "floor_plans.h"

#include <algorithm>
#include <filesystem>

#include "roomgraph/base/Error.h"
#include "roomgraph/images/read_labels.h"
#include "roomgraph/map_files/load_grid.h"

namespace roomgraph {
namespace {

constexpr double kResolution = 0.05;  // of all plans and truths [m]
const char* const kTruthEnd = "_labels.png";

std::filesystem::path folder(const std::string& data) {
  return std::filesystem::path(data) / "room_seg" / "ipa";
}

std::string picture(const std::string& data, const std::string& name, const std::string& variant) {
  return (folder(data) / (name + variant + ".png")).string();
}

}  // namespace

std::vector<std::string> floorPlanNames(const std::string& data) {
  const std::filesystem::path labels = folder(data) / "labels";
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(labels, error)) {
    const std::string file = entry.path().filename().string(), end = kTruthEnd;
    if (file.size() > end.size() && file.compare(file.size() - end.size(), end.size(), end) == 0)
      names.push_back(file.substr(0, file.size() - end.size()));
  }
  if (names.empty())
    throw DataError(labels.string() + ": has no *" + kTruthEnd +
                    "; --data must name the folder that holds room_seg");
  std::sort(names.begin(), names.end());
  return names;
}

LabelMap floorPlanTruth(const std::string& data, const std::string& name) {
  return readLabels((folder(data) / "labels" / (name + kTruthEnd)).string());
}

bool hasFloorPlan(const std::string& data, const std::string& name, const std::string& variant) {
  return std::filesystem::exists(picture(data, name, variant));
}

GreyMap floorPlan(const std::string& data, const std::string& name, const std::string& variant,
                  int truthWidth) {
  LoadGridOptions options;
  options.resolution = kResolution;
  GreyMap map = loadGrid(picture(data, name, variant), options);
  map.frame.resolution = kResolution * truthWidth / map.frame.width;
  return map;
}

}  // namespace roomgraph
