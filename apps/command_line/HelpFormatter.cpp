#include "HelpFormatter.h"

#include <algorithm>
#include <sstream>

namespace roomgraph {
namespace {

constexpr std::size_t kLineWidth = 80, kColumn = 26;  // of a line; where sentences begin

/** The text in lines that fit beside what stands before `column`. A longer word has its own. */
std::string wrapped(const std::string& text, std::size_t column) {
  std::istringstream words(text);
  std::string lines;
  std::size_t used = 0;  // of the last line
  for (std::string word; words >> word;) {
    const bool fits = column + used + 1 + word.size() <= kLineWidth;
    if (!lines.empty()) lines += fits ? ' ' : '\n';
    used = lines.empty() || !fits ? word.size() : used + 1 + word.size();
    lines += word;
  }
  return lines;
}

/** As it would be typed: "1280 860" where CLI11 has "[1280,860]". */
std::string defaultOf(const CLI::Option& option) {
  std::string text = option.get_default_str();
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return text;
  text = text.substr(1, text.size() - 2);
  if (option.get_delimiter() != ',') std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

}  // namespace

HelpFormatter::HelpFormatter() { column_width(kColumn); }

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), 0) + "\n\n";
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return {};  // a flag
  const std::string type = option->get_type_name();
  const std::string name = type.substr(0, type.find(':'));  // the checks follow
  const bool areMany = option->get_expected_max() >= CLI::detail::expected_max_vector_size;
  return (name.empty() ? "" : " " + name) + (areMany ? " ..." : "");
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (const std::string usual = defaultOf(*option); !usual.empty())
    text += " (default: " + usual + ")";
  for (const CLI::Option* other : option->get_excludes())
    text += " Not with " + other->get_name() + ".";
  return wrapped(text, kColumn);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::string text = "  " + command->get_name();
  text.append(text.size() < kColumn ? kColumn - text.size() : 1, ' ');
  for (const char letter : wrapped(command->get_description(), kColumn)) {
    text += letter;
    if (letter == '\n') text.append(kColumn, ' ');
  }
  return text + "\n";
}

}  // namespace roomgraph
