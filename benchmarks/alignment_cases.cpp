#include "alignment_cases.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "CsvTable.h"

namespace roomgraph {
namespace {

constexpr double kHalmstadPixels = 40;  // how far off a pose may be

using Places = std::map<std::string, std::map<std::string, Point>>;  // by map, then by index

Places keypoints(const std::string& file) {
  const CsvTable table(file);
  Places places;
  for (std::size_t i = 0; i < table.size(); ++i)
    places[table.text(i, "map")][table.text(i, "index")] =
        kHalmstadResolution * Point{table.number(i, "x_px"), table.number(i, "y_px_up")};
  return places;
}

std::vector<Point> associated(const CsvTable& table, const Places& places, const std::string& a,
                              const std::string& b) {
  std::vector<Point> found;
  for (std::size_t i = 0; i < table.size(); ++i)
    if (table.text(i, "map_a") == a && table.text(i, "map_b") == b)
      found.push_back(places.at(b).at(table.text(i, "index_b")));
  return found;
}

void addHalmstadSite(const std::string& folder, const std::string& site, AlignmentCases& cases) {
  const CsvTable poses(folder + "/alignments.csv"), pairs(folder + "/associations.csv");
  const Places places = keypoints(folder + "/keypoints.csv");
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::string a = poses.text(i, "map_a"), b = poses.text(i, "map_b");
    if (poses.number(i, "n_inliers_25px") < 8 || b.find("layout") != std::string::npos) continue;
    const Transform2D bFromA{kHalmstadResolution * poses.number(i, "tx_px"),
                             kHalmstadResolution * poses.number(i, "ty_px"),
                             poses.number(i, "rotation_deg") * M_PI / 180};
    AlignmentCase pair;
    pair.group = "halmstad", pair.name = a + " " + b;
    pair.a = cases.add({folder + "/" + a + ".png", kHalmstadResolution, site});
    pair.b = cases.add({folder + "/" + b + ".png", kHalmstadResolution, site});
    pair.truth = bFromA.inverse();
    pair.places = associated(pairs, places, a, b);
    pair.within = kHalmstadPixels * kHalmstadResolution;
    cases.cases.push_back(pair);
  }
}

const std::vector<std::string>& simulatedSites() {
  static const std::vector<std::string> sites = {"freiburg79", "lab_intel", "office_h",
                                                 "synth_ring"};
  return sites;
}

void addSimulatedSite(const std::string& folder, const std::string& site, AlignmentCases& cases) {
  const CsvTable truth(folder + "/truth.csv");
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t k = i + 1; k < truth.size(); ++k) {
      AlignmentCase pair;
      pair.group = "sim";
      pair.name = site + " " + truth.text(i, "run") + " " + truth.text(k, "run");
      pair.a = cases.add({folder + "/" + truth.text(i, "run") + ".gridmap.gz", 0.05, site});
      pair.b = cases.add({folder + "/" + truth.text(k, "run") + ".gridmap.gz", 0.05, site});
      pair.truth = truth.pose(i, "A").inverse() * truth.pose(k, "A");
      // A bent map has no one right pose: the better of its parts may be off by its own error.
      const double bent = std::hypot(truth.number(i, "map_rms_m"), truth.number(k, "map_rms_m"));
      pair.within = std::max(0.8, 1.5 * bent);
      if (bent > 0.8) pair.withinAngle = 8;
      cases.cases.push_back(pair);
    }
}

/** One map of each building, and which building it is. */
std::vector<MapSource> buildings(const std::string& data) {
  const std::string ipa = data + "/room_seg/ipa/", carmen = data + "/carmen_logs/";
  std::vector<MapSource> maps = {
      {data + "/multi_run/halmstad_E5/E5_01.png", kHalmstadResolution, "E5"},
      {data + "/multi_run/halmstad_E5/E5_09.png", kHalmstadResolution, "E5"},
      {data + "/multi_run/halmstad_HIH/HIH_01.png", kHalmstadResolution, "HIH"},
      {data + "/multi_run/strands_tsc/tsc_2016-05.yaml", 0.05, "tsc"},
      {data + "/multi_run/fr079_incremental/map15.yaml", 0.05, "freiburg79"},
      {data + "/sim_runs/freiburg79/run10.gridmap.gz", 0.05, "freiburg79"},
      {data + "/sim_runs/lab_intel/run08.gridmap.gz", 0.05, "lab_intel"},
      {data + "/sim_runs/office_h/run09.gridmap.gz", 0.05, "office_h"},
      {data + "/sim_runs/synth_ring/run07.gridmap.gz", 0.05, "synth_ring"},
      {carmen + "aces_render.yaml", 0.05, "aces"},
      {carmen + "fhw_render.yaml", 0.05, "fhw"},
      {carmen + "intel_render.yaml", 0.05, "lab_intel"},
      {carmen + "orebro_render.yaml", 0.05, "orebro"},
      {data + "/paper_maps/belgioioso/belgioioso_render.yaml", 0.05, "belgioioso"},
      {data + "/paper_maps/edmonton/edmonton_render.yaml", 0.05, "edmonton"},
      {data + "/single_maps/UMA_236_237.yaml", 0.05, "UMA"},
      {data + "/single_maps/g4s_y2.yaml", 0.05, "g4s"},
      {data + "/single_maps/carmen_nsh_level_3.png", 0.1, "nsh"}};
  for (const std::string name : {"Freiburg52_scan", "lab_a_scan", "lab_b_scan", "lab_d_scan",
                                 "lab_ipa", "NLB", "office_a", "office_c", "office_e"})
    maps.push_back({ipa + name + "_furnitures.png", 0.05, name});
  return maps;
}

}  // namespace

std::size_t AlignmentCases::add(const MapSource& source) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (sources[i].file == source.file) return i;
  sources.push_back(source);
  return sources.size() - 1;
}

void addHalmstad(const std::string& data, AlignmentCases& cases) {
  addHalmstadSite(data + "/multi_run/halmstad_E5", "E5", cases);
  addHalmstadSite(data + "/multi_run/halmstad_HIH", "HIH", cases);
}

void addStrands(const std::string& data, AlignmentCases& cases) {
  const std::string folder = data + "/multi_run/strands_tsc/tsc_";
  AlignmentCase pair;
  pair.group = "strands", pair.name = "tsc 2016-05 2017-01";
  pair.a = cases.add({folder + "2016-05.yaml", 0.05, "tsc"});
  pair.b = cases.add({folder + "2017-01.yaml", 0.05, "tsc"});
  pair.truth = Transform2D{};
  pair.within = 0.3, pair.withinAngle = 0.5;
  cases.cases.push_back(pair);
}

void addSimulated(const std::string& data, AlignmentCases& cases) {
  for (const std::string& site : simulatedSites())
    addSimulatedSite(data + "/sim_runs/" + site, site, cases);
}

void addStrips(AlignmentCases& cases) {
  const std::size_t count = cases.cases.size();
  for (const double share : {0.40, 0.25, 0.15})
    for (std::size_t i = 0; i < 2 * count; ++i) {
      AlignmentCase pair = cases.cases[i / 2];
      const bool isE5 = pair.name.rfind("E5", 0) == 0;
      if (!isE5 && (pair.group != "sim" || pair.within > 0.8)) continue;
      pair.group = (isE5 ? "strip E5 " : "strip sim ") + std::to_string(int(100 * share + 0.5));
      pair.places.clear();
      pair.cut = StripCut{share, i % 2 == 1};
      // The true pose fits the whole maps: where they are bent, a strip is turned against it.
      pair.withinAngle = 10;
      cases.cases.push_back(pair);
    }
}

void addDifferent(const std::string& data, AlignmentCases& cases) {
  const std::vector<MapSource> maps = buildings(data);
  for (std::size_t i = 0; i < maps.size(); ++i)
    for (std::size_t k = i + 1; k < maps.size(); ++k) {
      if (maps[i].site == maps[k].site) continue;
      AlignmentCase pair;
      pair.group = "different", pair.name = maps[i].site + " " + maps[k].site;
      pair.a = cases.add(maps[i]), pair.b = cases.add(maps[k]);
      cases.cases.push_back(pair);
    }
}

}  // namespace roomgraph
