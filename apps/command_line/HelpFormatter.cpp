#include "HelpFormatter.h"

#include <algorithm>
#include <sstream>

#include "roomgraph/base/sequences.h"

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

/** What is explained, and the sentences beside it. */
std::string explained(std::string what, const std::string& sentences) {
  what.insert(0, "  ");
  what += what.size() < kColumn ? std::string(kColumn - what.size(), ' ')
                                : '\n' + std::string(kColumn, ' ');
  for (const char letter : wrapped(sentences, kColumn)) {
    what += letter;
    if (letter == '\n') what.append(kColumn, ' ');
  }
  return what + "\n";
}

/** CLI11's own headings are POSITIONALS and OPTIONS since its version 2.6. */
std::string headingOf(const std::string& group) {
  const bool isCapital = !anyOf(group, [](char c) { return c >= 'a' && c <= 'z'; });
  return isCapital ? group.substr(0, 1) + CLI::detail::to_lower(group.substr(1)) : group;
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

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  return make_description(app) + make_usage(app, name) + make_positionals(app) + groupsOf(*app) +
         make_subcommands(app, mode) + "\n";
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  return wrapped(app->get_description(), 0) + "\n\n";
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  std::string text = "Usage: " + name + " [OPTIONS]";
  for (const CLI::Option* option : app->get_options({}))
    if (option->get_positional()) text += ' ' + make_option_usage(option);
  if (!app->get_subcommands({}).empty()) text += " SUBCOMMAND";
  return text + "\n";
}

std::string HelpFormatter::groupsOf(const CLI::App& app) const {
  std::string text;
  for (const std::string& group : app.get_groups()) {
    const std::vector<const CLI::Option*> options = app.get_options([&](const CLI::Option* option) {
      return option->get_group() == group && option->nonpositional();
    });
    if (options.empty() || group.empty()) continue;  // CLI11 hides those of no group
    text += text.empty() ? "" : "\n";
    text += make_group(group, false, options);
  }
  return text;
}

std::string HelpFormatter::make_group(std::string group, bool isPositional,
                                      std::vector<const CLI::Option*> options) const {
  std::string text = "\n" + headingOf(group) + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, isPositional);
  return text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool isPositional) const {
  return explained(make_option_name(option, isPositional) + make_option_opts(option),
                   make_option_desc(option));
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
  return text;
}

std::string HelpFormatter::make_subcommands(const CLI::App* app, CLI::AppFormatMode) const {
  std::string text;
  for (const CLI::App* command : app->get_subcommands({})) text += make_subcommand(command);
  return text.empty() ? "" : "\nSubcommands:\n" + text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return explained(command->get_name(), command->get_description());
}

}  // namespace roomgraph
