#pragma once
#include <optional>
#include <string>

namespace roomgraph {

/** A text as one cell of a table: in quotes where it must be. One that begins like a formula gets
 *  an apostrophe in front, without which spreadsheets would take it for one. */
std::string csvField(const std::string& text);

/** A number with four places; empty for none. */
std::string csvNumber(std::optional<double> value);

}  // namespace roomgraph
