#include "roomgraph/rooms/reason_names.h"

#include <gtest/gtest.h>

namespace roomgraph {
namespace {

TEST(ReasonNames, eachNameGivesItsReasonBack) {
  for (const PassageReason reason :
       {PassageReason::wallOnBothSides, PassageReason::wallOnOneSide, PassageReason::narrowing,
        PassageReason::mouth, PassageReason::unseenSide})
    EXPECT_EQ(valueOfName<PassageReason>(nameOf(reason)), reason) << nameOf(reason);
}

TEST(ReasonNames, anyOtherTextIsNone) {
  for (const char* text : {"", "door", "Mouth", "mouth "})
    EXPECT_FALSE(valueOfName<PassageReason>(text)) << text;
}

}  // namespace
}  // namespace roomgraph
