#include "roomgraph/base/read_document.h"

#include <algorithm>

#include "roomgraph/base/Error.h"

namespace roomgraph {
namespace {

const char* const kBlank = " \t\r\n\xef\xbb\xbf";  // or a byte order mark

/** The format of ours that the text names first; empty for none. */
std::string ourFormat(const std::string& text) {
  const auto start = text.find("\"roomgraph/");
  if (start == std::string::npos) return {};
  const auto end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_/", start + 1);
  return end != std::string::npos && text[end] == '"' ? text.substr(start + 1, end - start - 1)
                                                      : std::string();
}

/** How deep lists and objects are nested in each other. */
int nesting(const std::string& text) {
  int depth = 0, most = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') isInString = !isInString;
    if (isInString && c == '\\') ++i;  // what follows ends no string
    if (isInString) continue;
    if (c == '{' || c == '[') most = std::max(most, ++depth);
    if (c == '}' || c == ']') --depth;
  }
  return most;
}

}  // namespace

char firstLetter(const std::string& text) {
  const auto first = text.find_first_not_of(kBlank);
  return first == std::string::npos ? '\0' : text[first];
}

nlohmann::ordered_json parseDocument(const std::string& text, const std::string& name,
                                     const std::string& format, const std::string& remedy) {
  const std::string fault = jsonFault(text, format), other = ourFormat(text);
  if (!fault.empty() && !other.empty() && other != format)
    throw DataError(name + ": is of format " + other + ", and not " + format +
                    "; give a file of that format");
  if (!fault.empty()) throw DataError(name + ": " + fault + "; " + remedy);
  auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) throw DataError(name + ": is not JSON, or only a part of it; " + remedy);
  return json;
}

void refuseDocument(const std::string& name, const Broken& broken, const std::string& remedy) {
  const std::string where = broken.where.empty() ? "the file" : broken.where;
  throw DataError(name + ": " + where + " " + broken.problem + "; " + remedy);
}

std::string jsonFault(const std::string& text, const std::string& format) {
  const auto last = text.find_last_not_of(kBlank);
  if (last == std::string::npos) return "is empty";
  if (firstLetter(text) != '{' || text[last] != '}') return "is not JSON, or only a part of it";
  if (!format.empty() && text.find('"' + format + '"') == std::string::npos)
    return "is not of format " + format;
  if (nesting(text) > 20) return "is nested too deeply";
  return {};
}

}  // namespace roomgraph
