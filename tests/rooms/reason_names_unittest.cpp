#include "roomgraph/rooms/reason_names.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(ReasonNames, eachNameGivesItsReasonBack) {
  for (const PassageReason reason :
       {PassageReason::wallOnBothSides, PassageReason::wallOnOneSide, PassageReason::narrowing,
        PassageReason::mouth, PassageReason::unseenSide})
    EXPECT_EQ(reasonOfName(reasonName(reason)), reason) << reasonName(reason);
}

TEST(ReasonNames, anyOtherTextIsNone) {
  for (const char* text : {"", "door", "Mouth", "mouth "}) EXPECT_FALSE(reasonOfName(text)) << text;
}

}  // namespace
}  // namespace roomgraph
