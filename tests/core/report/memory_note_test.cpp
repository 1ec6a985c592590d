#include "report/memory_note.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(MemoryNote, OfAScannerOfFewRaysNothingIsSaid) {
  EXPECT_FALSE(memoryNote(300'000, {}));
}

TEST(MemoryNote, CountsTheScansThatAreThere) {
  const auto first = memoryNote(5'000'000, {});
  const auto later = memoryNote(5'000'000, {}, 9);
  ASSERT_TRUE(first && later);
  EXPECT_NE(english(*first), english(*later));
  EXPECT_NE(
      english(*first).find("the scanner has 5.0 million rays: this takes about 0.5 GB of memory, about 56 MB more"),
      std::string::npos)
      << english(*first);
}

TEST(MemoryNote, SaysHowMuchOfAScanIsWorkedOn) {
  const std::string thinned = english(*memoryNote(5'000'000, {}));
  EXPECT_NE(thinned.find("about 0.6 million samples are worked on"), std::string::npos) << thinned;
  EXPECT_EQ(english(*memoryNote(5'000'000, {0.0})).find("worked on"), std::string::npos);
}

}  // namespace
}  // namespace vantage
