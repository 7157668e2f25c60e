#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "roomgraph/base/enum_names.h"
#include "roomgraph/geometry/Transform2D.h"
#include "roomgraph/relate/turn_lever.h"

namespace roomgraph {

/** A shift from which on a map is broken, if it hardly turns [m]. */
constexpr double kBreakShift = 0.4;
/** The same for a jump that turns it [rad]. */
constexpr double kBreakRotation = 0.035;

/** A break that turns less, and shifts less than kBreakShift, is slight: what it moves in the sight
 *  of a robot stays within what its localisation puts up with, and where maps bend it is hard to
 *  tell from bends [rad]. */
constexpr double kClearRotation = 0.087;
/** One of more tears a map apart: no door fits any more, and no noise does it [m, rad]. */
constexpr double kApartShift = 1.2, kApartRotation = 0.2094;

/** What a robot that drives across a break feels of it. */
enum class BreakClass {
  slight,  ///< hardly anything
  clear,   ///< its scan no longer fits the map
  apart    ///< it is in another place
};

[[nodiscard]] constexpr std::array<const char*, 3> enumNames(BreakClass) {
  return {"slight", "clear", "apart"};
}

/** Where the first key frame behind a break lies, site <- robot. What `drawn` says is wrong from
 *  there on by the motion mend(). */
struct TornPose {
  Transform2D drawn;   ///< as the run's map has it
  Transform2D untorn;  ///< as it would lie there if the run had not been torn

  [[nodiscard]] Transform2D mend() const { return untorn * drawn.inverse(); }
};

/** A place where a map is torn: what lies on one side of it is turned and shifted as a whole. */
struct MapBreak {
  std::string run;  ///< name
  Point place;      ///< where the robot was, by the run's map before it [m, site frame]
  /** Of the far side against the near one; without scans, of the smaller one against the larger
   *  [rad]. */
  double rotation = 0;
  double shift = 0;  ///< of the far side at the break [m]
  /** The first key frame behind the break that has a scan, by its number in the file of the run,
   *  and the time of that scan [s since 1970]; none of a run without scans. */
  std::optional<std::size_t> keyFrame;
  std::optional<double> time;
  std::optional<TornPose> torn{};  ///< none of a run without scans

  /** By how much it moves what lies kTurnLever behind it, at most [m]. */
  [[nodiscard]] double size() const { return std::abs(shift) + kTurnLever * std::abs(rotation); }
  [[nodiscard]] BreakClass kind() const {
    const double turn = std::abs(rotation), far = std::abs(shift);
    if (turn >= kApartRotation || far >= kApartShift) return BreakClass::apart;
    return turn >= kClearRotation || far >= kBreakShift ? BreakClass::clear : BreakClass::slight;
  }
};

}  // namespace roomgraph
