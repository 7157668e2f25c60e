#include "roomgraph/base/Json.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace roomgraph {

Json numberOrNull(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return rounded(*value);
}

std::string lineOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

void addNumber(std::string& json, double value) {
  if (!std::isfinite(value)) {
    json += "null";
    return;
  }
  char buffer[40];
  char* const end = buffer + sizeof buffer;
  if (std::abs(value) > 1e10) {  // 0.1 mm may be no whole number of 64 bits
    json.append(buffer, std::to_chars(buffer, end, value).ptr);
    return;
  }
  // Whole numbers of 0.1 mm are written several times faster than floating point ones.
  const std::int64_t all = std::llround(value * 1e4), size = std::abs(all);
  if (all < 0) json += '-';
  char* digit = std::to_chars(buffer, end, size / 10000).ptr;
  std::int64_t fraction = size % 10000;
  if (fraction > 0) *digit++ = '.';
  for (std::int64_t unit = 1000; fraction > 0; fraction %= unit, unit /= 10)
    *digit++ = char('0' + fraction / unit);
  json.append(buffer, digit);
}

}  // namespace roomgraph
