#include "roomgraph/base/csv_text.h"

#include <cmath>
#include <cstdio>

#include "roomgraph/base/rounded.h"

namespace roomgraph {

std::string csvField(const std::string& given) {
  const bool isFormula = given.find_first_of("=+-@\t\r") == 0;
  std::string text = isFormula ? "'" + given : given;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csvNumber(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, "%.4f", rounded(*value));
  return text;
}

}  // namespace roomgraph
