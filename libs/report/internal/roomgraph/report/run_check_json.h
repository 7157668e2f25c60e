#pragma once
#include <string>

#include "roomgraph/check/RunCheck.h"

namespace roomgraph {

// In:   RunCheck
// Out:  text of a file, and a line for people
// Next: a file

/** JSON of format "roomgraph/check", version 1; see the schema in share/roomgraph/schema. What
 *  cannot be told is null. Numbers are rounded to 0.0001; metres, degrees, frame of the run. File
 *  names without their folder. */
std::string runCheckJson(const RunCheck& check);

/** "what it tells of itself; its breaks; what it has drawn twice or laid over each other". */
std::string toldText(const RunCheck& check);

/** "name: " and the same, a line. */
std::string runCheckText(const RunCheck& check);

/** Where a run breaks by itself, and by how much, if that is known. */
std::string selfBreakText(const MapBreak& tear);

/** By which key frames a place was drawn, where, and how far apart. */
std::string doubledText(const DoubledPlace& place);

/** Which key frames lie over each other, and where. */
std::string weldedText(const WeldedPlace& place);

}  // namespace roomgraph
