// Writes what the fuzz targets start from, one small file of each kind that roomgraph reads:
//   write_seeds FOLDER
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "MapText.h"
#include "as_file.h"
#include "map_files.h"
#include "roomgraph/archive/Archive.h"
#include "roomgraph/graph_files/area_pictures.h"
#include "roomgraph/graph_files/graph_json.h"
#include "roomgraph/mrpt_plugin/room_graph_file.h"
#include "roomgraph/pipeline/extract.h"
#include "roomgraph/report/comparison_json.h"
#include "roomgraph/report/site_json.h"
#include "rtabmap_database.h"
#include "sample_comparison.h"

namespace {

using namespace roomgraph;

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << bytes;
}

std::string rtabmap() {
  const std::string cells(20, '\x64');
  return test::rtabmapDatabase(test::sqlBlob(test::packedMatrix(cells, 4, 5)));
}

void writeMaps(const fs::path& folder, const Stages& stages) {
  const std::string raw(1, '\0'), packed(1, '\1'), png(1, '\2');
  const std::string gridmap = test::streamed(test::smallGrid());
  const std::string simplemap = test::streamed(test::smallSimplemap());
  write(folder / "gridmap", raw + gridmap);
  write(folder / "gridmap_gz", packed + gridmap);
  write(folder / "simplemap", raw + simplemap);
  write(folder / "simplemap_gz", packed + simplemap);
  write(folder / "rtabmap", raw + rtabmap());
  write(folder / "pgm", raw + "P5 # a comment\n5 4\n255\n" + std::string(20, '\xfe'));
  write(folder / "png", png + areaLabelsPng(stages.areas, stages.grid.frame));
  write(folder / "yaml", raw +
                             "image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0.1]\nnegate: 0\n"
                             "mode: scale\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

void writeTexts(const fs::path& folder, const Stages& stages) {
  SiteFile site;
  site.rooms.push_back({"R1", "Kitchen", false, {1, 1}, {{{0, 0}, {2, 0}, {2, 2}}, {}}, 4, {}, {}});
  site.rooms[0].doors.push_back({{2, 1}, 0.9, ""});
  ExtractOptions options;
  write(folder / "graph", std::string(1, '\0') + graphJson(stages));
  write(folder / "site", std::string(1, '\1') + siteJson(site));
  write(folder / "ini", std::string(1, '\2') + toIni(describe(options)));
  write(folder / "comparison",
        std::string(1, '\3') + comparisonJson(test::sampleComparison().comparison));
}

/** As people mark places: a table, GeoJSON, OpenStreetMap's XML, and rooms with their names. */
void writeMarked(const fs::path& folder) {
  write(folder / "csv", "name,x,y,yaw\ndock,1.5,-2,0.3\n\"a, b\",3,4,0\n");
  write(folder / "geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"id":1},)"
        R"("geometry":{"type":"LineString","coordinates":[[1,2],[3,4.5]]}},)"
        R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon",)"
        R"("coordinates":[[[0,0],[2,0],[2,2],[0,0]]]}}]})");
  write(folder / "osm",
        "<osm version='0.6'><node id='1' lat='0' lon='0'><tag k='name' v='root'/></node>"
        "<node id='2' lat='0.00001' lon='0.00002'/><node id='3' lat='0.00003' lon='0'/>"
        "<way id='4'><nd ref='2'/><nd ref='3'/><tag k='name' v='A &amp; B'/></way></osm>");
  write(folder / "site", R"({"format":"roomgraph/site","rooms":[{"id":"R1","name":"Kitchen",)"
                         R"("center":[1,1],"area":4,"polygon":[[[0,0],[2,0],[2,2]]]}]})");
  write(folder / "yaml", "image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0.1]\nnegate: 0\n");
}

void writeArchive(const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path file = folder / "nights";
  fs::remove(file);
  Addition addition;
  addition.site = "office";
  addition.comparison = test::sampleComparison().comparison;
  for (ComparedRun& run : addition.comparison.runs) {
    run.sha256 = run.name;
    addition.runs.push_back({run.sha256, "anna", run.file, 1e9});
  }
  Archive(file.string(), Archive::Access::orNew).record(addition);
}

}  // namespace

int main(int, char** arguments) {
  const fs::path folder = arguments[1];
  const Stages stages = extract(test::greyMap(test::readMapText("door_in_thick_wall")), {});
  writeMaps(folder / "load_grid", stages);
  writeTexts(folder / "text", stages);
  writeMarked(folder / "marked");
  writeArchive(folder / "archive");
  const std::string packed = roomGraphBytes(CRoomGraph(stages));
  write(folder / "extract" / "zeros", std::string(40, '\0'));
  write(folder / "compare" / "zeros", std::string(40, '\0'));
  // Unpacked, as the target packs it.
  const std::string& file = test::asFile(packed);
  std::string bytes(1 << 20, '\0');
  const gzFile in = gzopen(file.c_str(), "rb");
  bytes.resize(std::size_t(gzread(in, bytes.data(), unsigned(bytes.size()))));
  gzclose(in);
  write(folder / "room_graph" / "small", bytes);
  return 0;
}
