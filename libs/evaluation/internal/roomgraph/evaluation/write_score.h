#pragma once
#include <string>

#include "roomgraph/evaluation/score_rooms.h"

namespace roomgraph {

// In:   RoomScore
// Out:  text for people, and for programs
//
// Shares are in percent, mcc is not; both rounded.

/** One number per line, with its name before it and what it is behind it; "-" where it has no
 *  value. The columns are aligned. */
std::string roomScoreText(const RoomScore& score);

/** The same, with the hashes of the files and the program's version; null where there is no value.
 *  Rounded to 4 decimals, mcc to 6. One member per line. */
std::string roomScoreJson(const RoomScore& score);

}  // namespace roomgraph
