#pragma once
#include <optional>
#include <string>

namespace roomgraph {

constexpr double kDay = 86400;  ///< [s]

/** "2026-11-22T03:00:00Z", in UTC, of seconds since 1970; empty outside of the years 1 to 9999. */
[[nodiscard]] std::string timeText(double seconds);

/** The first ten letters of it, the day. */
[[nodiscard]] std::string dayText(double seconds);

/** Seconds since 1970 of "2026-11-22", "2026-11-22T03:00", "2026-11-22T03:00:00" or the same with a
 *  Z behind: all are UTC. A plain number stands for itself. Nothing for any other text. */
[[nodiscard]] std::optional<double> parseTime(const std::string& text);

/** Whether a time is more than a day ahead of now: clocks in other time zones are not. */
[[nodiscard]] bool isToCome(double seconds);

}  // namespace roomgraph
