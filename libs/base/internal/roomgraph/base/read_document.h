#pragma once
#include <string>

#include "roomgraph/base/Json.h"

namespace roomgraph {

/** The first letter of a text behind blanks and a byte order mark, which tells JSON and XML from
 *  what is neither; 0 where there is none. */
char firstLetter(const std::string& text);

/** The text of a file as JSON. @throws DataError, see readDocument. */
nlohmann::ordered_json parseDocument(const std::string& text, const std::string& name,
                                     const std::string& format, const std::string& remedy);

/** @throws DataError that says what is broken. */
[[noreturn]] void refuseDocument(const std::string& name, const Broken& broken,
                                 const std::string& remedy);

/** What a file of JSON holds: `read` makes it from the top of the file, and throws Broken where
 *  something is wrong. `format` is that of the file, such as "roomgraph/graph"; empty where
 *  files of this kind name none.
 *  @throws DataError with one line: `name` of the file, place, problem, remedy. */
template <class Read>
auto readDocument(const std::string& text, const std::string& name, const std::string& format,
                  const std::string& remedy, const Read& read) {
  const nlohmann::ordered_json json = parseDocument(text, name, format, remedy);
  try {
    return read(JsonNode{json, ""});
  } catch (const Broken& broken) {
    refuseDocument(name, broken, remedy);
  }
}

/** Why the text cannot be a whole JSON object of this format, such as "roomgraph/graph" (of any, if
 *  it is empty); empty where it can. Looks at ends, nesting and the format's name only, so that a
 *  foreign or damaged file is refused before a parser takes twenty times its size in memory.
 *  O(bytes). */
std::string jsonFault(const std::string& text, const std::string& format);

}  // namespace roomgraph
