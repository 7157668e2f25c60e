#include "roomgraph/base/time_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

constexpr double kFirstTime = -62135596800.0,
                 kEndTime = 253402300800.0;  // of the years 1 and 10000

std::optional<double> plainNumber(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  const bool isWhole = !text.empty() && end == text.c_str() + text.size();
  if (!isWhole || !(value >= kFirstTime && value < kEndTime)) return {};
  return value;
}

}  // namespace

std::string timeText(double seconds) {
  if (!(seconds >= kFirstTime && seconds < kEndTime)) return "";
  const auto time = std::time_t(std::floor(seconds));
  std::tm parts{};
  gmtime_r(&time, &parts);
  return formatted("%04d-%02d-%02dT%02d:%02d:%02dZ", parts.tm_year + 1900, parts.tm_mon + 1,
                   parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

std::string dayText(double seconds) { return timeText(seconds).substr(0, 10); }

std::optional<double> parseTime(const std::string& given) {
  if (const auto number = plainNumber(given)) return number;
  std::string text = given;
  if (!text.empty() && text.back() == 'Z') text.pop_back();
  for (const char* rest : {"", "T00:00:00", ":00"}) {
    std::tm parts{};
    int used = 0;
    const std::string whole = text + rest;
    const int read =
        std::sscanf(whole.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d%n", &parts.tm_year, &parts.tm_mon,
                    &parts.tm_mday, &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &used);
    if (read != 6 || std::size_t(used) != whole.size()) continue;
    parts.tm_year -= 1900, parts.tm_mon -= 1;
    const auto seconds = double(timegm(&parts));
    // A day that there is not, such as 31 February, would be another one.
    if (timeText(seconds) == whole + "Z") return seconds;
  }
  return {};
}

bool isToCome(double seconds) { return seconds > double(std::time(nullptr)) + kDay; }

}  // namespace roomgraph
