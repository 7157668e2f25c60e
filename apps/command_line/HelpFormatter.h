#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace roomgraph {

/** Help that fits a terminal of 80 columns: sentences are wrapped, and end with the default and the
 *  options that this one excludes. Checks of values are left out: what they ask for stands in the
 *  sentences. It is the same with any CLI11, whose own layout differs between 2.1, 2.4 and 2.6. */
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_group(std::string group, bool isPositional,
                         std::vector<const CLI::Option*> options) const override;
  std::string make_option(const CLI::Option* option, bool isPositional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  std::string groupsOf(const CLI::App& app) const;
};

}  // namespace roomgraph
