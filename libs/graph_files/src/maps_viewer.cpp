#include "roomgraph/graph_files/maps_viewer.h"

#include <cmath>

#include "text.h"

namespace roomgraph {
namespace {

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

}  // namespace roomgraph
