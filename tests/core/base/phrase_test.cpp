#include "base/phrase.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(Phrase, ValuesGoToTheirPlaces) {
  EXPECT_EQ(english(words("nothing scanned")), "nothing scanned");
  EXPECT_EQ(english(words("%2 of %1", {asIs("mug"), figure(2.46, 1)})), "2.5 of mug");
  EXPECT_EQ(english(figure(45.4)), "45");
}

TEST(Phrase, AValueMayBeWordsAgain) {
  const Phrase both = words("%1 and %2", {words("slides along %1", {asIs("z")}), words("moves freely")});
  EXPECT_EQ(english(words("the surface %1", {both})), "the surface slides along z and moves freely");
}

TEST(Phrase, SignsWithoutAValueStayAsTheyAre) {
  EXPECT_EQ(english(words("only %1 % of it, %2", {figure(45)})), "only 45 % of it, %2");
  EXPECT_EQ(english(words("%1", {asIs("100 %1")})), "100 %1");
}

}  // namespace
}  // namespace vantage
