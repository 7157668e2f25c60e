#pragma once
#include <cstddef>
#include <string>

#include "roomgraph/compare/Comparison.h"

namespace roomgraph {

// In:   Comparison
// Out:  sentences for people
// Next: comparisonReport, a terminal

/** Of more names, a sentence tells how many more there are. */
constexpr std::size_t kMostNames = 4;

/** Which maps break, and where most; empty where none does. */
[[nodiscard]] std::string breaksSentence(const Comparison& comparison);

/** Which runs their own beams refute, so that they have no score; empty for none. */
[[nodiscard]] std::string refutedSentence(const Comparison& comparison);

/** Which pairs of the site are aligned with a confidence below kSureConfidence; empty for none. */
[[nodiscard]] std::string doubtSentence(const Comparison& comparison);

/** What the gate says, what was asked, and by how much it passes or why it fails. */
[[nodiscard]] std::string gateSentence(const GateVerdict& gate);

/** The same for a terminal and for programs: "PASS" or "FAIL", then by how much or why. */
[[nodiscard]] std::string gateLine(const GateVerdict& gate);

}  // namespace roomgraph
