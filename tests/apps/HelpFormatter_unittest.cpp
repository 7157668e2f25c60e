#include "HelpFormatter.h"

#include <gtest/gtest.h>

#include <sstream>

namespace roomgraph {
namespace {

struct App : testing::Test {
  App() { app.formatter(std::make_shared<HelpFormatter>()); }

  CLI::App app{"What it does.", "program"};
};

TEST_F(App, sentencesFitATerminal) {
  std::string sentence = "One";
  for (int i = 0; i < 40; ++i) sentence += " and another word";
  app.add_flag("--flag")->description(sentence);
  app.add_subcommand("command", sentence);
  std::istringstream help(app.help());
  std::size_t longest = 0;
  for (std::string line; std::getline(help, line);) longest = std::max(longest, line.size());
  EXPECT_LE(longest, 80u);
  EXPECT_GE(longest, 70u);
}

TEST_F(App, aLongWordHasALineOfItsOwn) {
  const std::string word(90, 'x');
  app.add_flag("--flag")->description("Writes " + word + " and more.");
  const std::string column(26, ' ');
  EXPECT_NE(app.help().find("Writes\n" + column + word + "\n" + column + "and more.\n"),
            std::string::npos)
      << app.help();
}

TEST_F(App, optionsTellDefaultsAndWhatTheyDoNotGoWith) {
  double number = 8;
  std::vector<int> numbers{3, 4};
  CLI::Option* flag = app.add_flag("--flag", "A flag.");
  app.add_option("--number", number, "A number.")
      ->type_name("N")
      ->check(CLI::Range(2.0, 9.0))
      ->excludes(flag)
      ->capture_default_str();
  std::string list = "a,b";
  app.add_option("--list", list, "A list.")->type_name("LIST")->capture_default_str();
  app.add_option("--size", numbers, "A size.")
      ->type_name("W H")
      ->expected(2)
      ->capture_default_str();
  const std::string help = app.help();
  EXPECT_NE(help.find("  --number N              A number. (default: 8) Not with --flag.\n"),
            std::string::npos)
      << help;
  EXPECT_NE(help.find("  --size W H              A size. (default: 3 4)\n"), std::string::npos)
      << help;
  EXPECT_NE(help.find("  --list LIST             A list. (default: a,b)\n"), std::string::npos)
      << help;
  EXPECT_NE(help.find("  --flag                  A flag. Not with --number.\n"), std::string::npos)
      << help;
}

}  // namespace
}  // namespace roomgraph
