#include "roomgraph/graph_files/ros_map.h"

#include <charconv>
#include <cmath>

#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/images/png_bytes.h"

namespace roomgraph {
namespace {

/** The text in quotes as YAML and TOML read it, whatever it holds. */
std::string quotedText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += formatted("\\u%04x", unsigned(c));
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/** "key = value"; TOML has no integers where a float is asked for. */
std::string line(const char* key, double value) {
  const std::string number = numberText(value);
  const bool isWhole = number.find_first_of(".e") == std::string::npos;
  return key + (" = " + number) + (isWhole ? ".0\n" : "\n");
}

std::string quotedLine(const char* key, const std::string& text) {
  return key + (" = " + quotedText(text)) + "\n";
}

std::string mapText(const SessionMap& map) {
  const std::string table = "maps." + quotedText(map.yaml);
  const Point origin = map.pose(map.frame.origin);
  const auto header = [&](const char* name) { return "\n[" + table + name + "]\n"; };
  // Grey at half strength, multiplied with its own transparency as the viewer keeps colours.
  return header("") + "visible = true\ntint = [128, 128, 128, 128]\n" + header(".meta") +
         quotedLine("image_path", map.picture) + quotedLine("yaml_path", map.yaml) +
         line("resolution", map.frame.resolution) + header(".meta.origin_xy") +
         line("x", origin.x) + line("y", origin.y) + header(".meta.origin_theta") +
         line("s", std::sin(map.pose.phi)) + line("c", std::cos(map.pose.phi)) + header(".pose") +
         quotedLine("root_frame", "site") + quotedLine("map_frame", "site") +
         header(".pose.translation") + "x = 0.0\ny = 0.0\nz = 0.0\n" + header(".pose.rotation") +
         "roll = 0.0\npitch = 0.0\nyaw = 0.0\n";
}

/** Of what is unknown, free and occupied, by State. */
constexpr std::uint8_t kGreys[] = {205, 254, 0};

/** The shortest text within half a micrometre of a length; the same in every locale. */
std::string metresText(double metres) {
  constexpr double close = 0.5e-6;
  char text[64];
  for (int digits = 0;; ++digits) {
    const auto end =
        std::to_chars(text, text + sizeof text, metres, std::chars_format::fixed, digits).ptr;
    double again = 0;
    std::from_chars(text, end, again);
    if (std::abs(again - metres) <= close || digits == 6)
      return again == 0 ? "0" : std::string(text, end);
  }
}

}  // namespace

std::string mapsPoseYaml(const Transform2D& pose, const std::string& name) {
  return "translation:\n  x: " + numberText(pose.x) + "\n  y: " + numberText(pose.y) +
         "\n  z: 0\nrotation:\n  roll: 0\n  pitch: 0\n  yaw: " + numberText(pose.phi) +
         "\nroot_frame: site\nmap_frame: " + quotedText(name) + "\n";
}

std::string mapsSession(const std::vector<SessionMap>& maps) {
  std::string text = "version = \"1.7.0\"\n";
  for (const SessionMap& map : maps) text += mapText(map);
  return text + "\n[grid_lenses]\n";
}

std::string mapPgm(const Grid& grid) {
  const auto greys = mapped(grid.cells, [](State state) { return kGreys[std::size_t(state)]; });
  return pgmBytes(greys, grid.frame.width, grid.frame.height);
}

std::string mapPng(const Grid& grid) {
  PaletteImage image;
  image.width = grid.frame.width, image.height = grid.frame.height;
  for (const std::uint8_t grey : kGreys) image.palette.push_back({grey, grey, grey});
  image.indices.reserve(grid.cells.size());
  for (const State state : grid.cells) image.indices.push_back(std::uint8_t(state));
  return pngBytes(image);
}

std::string rosMapYaml(const GridFrame& frame, const std::string& picture, const Transform2D& pose,
                       RosMapMode mode) {
  const Point origin = pose(frame.origin);
  const bool isScale = mode == RosMapMode::scale;
  return kRosMapMark + ("\nimage: " + quotedText(picture)) +
         "\nmode: " + (isScale ? "scale" : "trinary") +
         "\nresolution: " + numberText(frame.resolution) + "\norigin: [" + metresText(origin.x) +
         ", " + metresText(origin.y) + ", " + numberText(pose.phi) + "]\nnegate: 0\n" +
         (isScale ? "occupied_thresh: 1.0\nfree_thresh: 0.0\n"
                  : "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

}  // namespace roomgraph
