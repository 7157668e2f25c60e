#include "usage_fault.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

/** What is said of a wrong call. The program has a command with commands of its own, as
 *  'roomgraph archive' does. */
std::string faultOf(const std::vector<std::string>& arguments) {
  CLI::App app("", "program");
  app.require_subcommand(1);
  std::string file, run;
  double number = 0;
  CLI::App* extract = app.add_subcommand("extract");
  extract->add_option("MAP", file)->required();
  extract->add_option("--width", number)->check(CLI::Range(0.0, 2.5));
  CLI::App* archive = app.add_subcommand("archive");
  archive->add_option("ARCHIVE", file)->required();
  archive->require_subcommand(1);
  CLI::App* add = archive->add_subcommand("add");
  add->add_option("RUN", run)->required();
  add->add_option("--robot", run);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return usageFault(app, arguments, error);
  }
  return "";
}

TEST(UsageFault, namesTheCommandThatWasMeant) {
  EXPECT_EQ(faultOf({"extrct", "a"}), "there is no command 'extrct': did you mean 'extract'?");
  EXPECT_EQ(faultOf({"archive", "a.db", "ad", "b"}),
            "there is no command 'ad': did you mean 'add'?");
}

TEST(UsageFault, namesTheOptionThatWasMeant) {
  EXPECT_EQ(faultOf({"extract", "--widht=2", "a"}),
            "there is no option '--widht': did you mean '--width'?");
  EXPECT_EQ(faultOf({"archive", "a.db", "add", "--robbot", "anna", "b"}),
            "there is no option '--robbot': did you mean '--robot'?");
  EXPECT_EQ(faultOf({"--hlp"}), "there is no option '--hlp': did you mean '--help'?");
}

TEST(UsageFault, doesNotBlameAnOptionThatThereIs) {
  EXPECT_EQ(faultOf({"archive", "a.db", "add", "--robot", "anna"}), "RUN is required");
}

TEST(UsageFault, tellsUnitsFromNumbersOutOfRange) {
  EXPECT_EQ(faultOf({"extract", "a", "--width", "2m"}), "--width: '2m' is not a number");
}

TEST(UsageFault, writesRangesWithoutUselessZeros) {
  EXPECT_NE(faultOf({"extract", "a", "--width", "3"}).find("0 to 2.5"), std::string::npos)
      << faultOf({"extract", "a", "--width", "3"});
}

TEST(UsageFault, writesRangesAlikeWithEveryCli11) {
  const CLI::App app;
  for (const char* range : {"0.000000 to 2.500000", "[0.000000 - 2.500000]", "[0 - 2.5]"})
    EXPECT_EQ(
        usageFault(app, {},
                   CLI::ValidationError("--width", std::string("Value 3 not in range ") + range)),
        "--width: Value 3 not in range 0 to 2.5");
}

}  // namespace
}  // namespace roomgraph
