#include "roomgraph/consensus/StepWitness.h"

#include <gtest/gtest.h>

#include "sample_drives.h"

namespace roomgraph {
namespace {

struct Witnessed {
  explicit Witnessed(const std::vector<Keyframe>& frames)
      : scans(localScans(test::runOf(frames).scans)), drawn(test::posesOf(frames)) {}

  Transform2D step() const { return drawn[17].inverse() * drawn[18]; }

  std::vector<LocalScan> scans;
  std::vector<Transform2D> drawn;
  StepWitness of{scans, drawn};
};

TEST(StepWitness, refutesOthersThanAStepThatTheScansAgreeWith) {
  Witnessed witness(test::driveOnce());
  EXPECT_FALSE(witness.of.refutes(18, witness.step()));
  EXPECT_FALSE(witness.of.refutes(18, witness.step() * Transform2D{0.05, 0, 0.01}));
  EXPECT_TRUE(witness.of.refutes(18, witness.step() * Transform2D{3, -2, 0}));
  EXPECT_TRUE(witness.of.refutes(18, witness.step() * Transform2D{0, 0, 0.8}));
  EXPECT_FALSE(witness.of.prefers(18, witness.step() * Transform2D{0, 0, 0.8}));
}

TEST(StepWitness, refutesNothingAtATearAndPrefersWhatIsRight) {
  const Transform2D right = Witnessed(test::driveOnce()).step();
  Witnessed torn(test::broken(test::driveOnce(), 18, 0.8, {2, -1}));
  EXPECT_FALSE(torn.of.refutes(18, right));
  EXPECT_TRUE(torn.of.prefers(18, right));
}

}  // namespace
}  // namespace roomgraph
