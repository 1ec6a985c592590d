#include "session/loss_list.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(LossList, NamesEachLossOnceAndCountsWhatIsBeyondTheLimit) {
  LossList list;
  for (int repeat = 0; repeat < 2; ++repeat) list.add({LossKind::FilesLost, 2, {}, {}});
  for (std::int64_t i = 0; i < kMostNamed + 7; ++i) list.add({LossKind::RowDamaged, i, "view", {}});
  list.add({LossKind::RowDamaged, 1, "plan", {}});
  const std::vector<Loss> all = list.all();
  ASSERT_EQ(all.size(), static_cast<std::size_t>(kMostNamed) + 3);
  EXPECT_EQ(all[0].kind, LossKind::FilesLost);
  EXPECT_EQ(all[static_cast<std::size_t>(kMostNamed)].number, kMostNamed - 1);
  EXPECT_EQ(all[static_cast<std::size_t>(kMostNamed) + 1].name, "plan");
  EXPECT_EQ(all.back(), (Loss{LossKind::MoreDamaged, 7, "view", {}}));
}

}  // namespace
}  // namespace vantage
