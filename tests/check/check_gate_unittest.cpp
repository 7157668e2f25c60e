#include <gtest/gtest.h>

#include "roomgraph/check/check_run.h"

namespace roomgraph {
namespace {

/** A check of a run that has scans. */
RunCheck checkOfScans() {
  RunCheck check;
  check.path.resize(2);
  return check;
}

TEST(CheckGate, whatIsNotAskedIsNoComplaint) {
  RunCheck check;
  check.selfError = 3, check.breaks.resize(2);
  EXPECT_TRUE(complaintsOf(check, {}).empty());
}

TEST(CheckGate, errorsAndBreaksAreComplaints) {
  RunCheck check = checkOfScans();
  check.selfError = 0.5, check.breaks.resize(2);
  const auto complaints = complaintsOf(check, {0.3, true});
  ASSERT_EQ(complaints.size(), 2u);
  EXPECT_EQ(complaints[0], "its self error of 0.500 m is above 0.3 m");
  EXPECT_EQ(complaints[1], "it breaks in 2 places");
  EXPECT_TRUE(complaintsOf(check, {0.5, false}).empty());
}

TEST(CheckGate, placesDrawnTwiceAreAComplaintWhereAsked) {
  RunCheck check = checkOfScans();
  check.doubled.resize(1);
  EXPECT_EQ(complaintsOf(check, {{}, false, true}),
            std::vector<std::string>{"it has drawn 1 place twice"});
  check.welded.resize(2);
  EXPECT_EQ(complaintsOf(check, {{}, false, true}).back(), "it has laid 2 places over another");
  EXPECT_TRUE(complaintsOf(check, {{}, true, false}).empty());
}

TEST(CheckGate, whatCannotBeToldIsNotGoodEnough) {
  RunCheck check;
  check.sentence = "cannot tell: it has no scans";
  for (const CheckGateOptions& asked :
       {CheckGateOptions{0.3}, CheckGateOptions{{}, true}, CheckGateOptions{{}, false, true}})
    EXPECT_EQ(complaintsOf(check, asked), std::vector<std::string>{check.sentence});
  check.path.resize(2);
  EXPECT_TRUE(complaintsOf(check, {{}, true, true}).empty());
}

}  // namespace
}  // namespace roomgraph
