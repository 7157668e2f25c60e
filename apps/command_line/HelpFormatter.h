#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace roomgraph {

/** Help that fits a terminal of 80 columns: sentences are wrapped, and end with the default and the
 *  options that this one excludes. Checks of values are left out: what they ask for stands in the
 *  sentences. */
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();

  std::string make_description(const CLI::App* app) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

}  // namespace roomgraph
