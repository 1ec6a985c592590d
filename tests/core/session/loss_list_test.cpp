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

TEST(LossList, NamesTheFirstOfManyNumbersAndCountsTheOthersAtOnce) {
  LossList list;
  std::int64_t asked = 0;
  list.addEach(5, std::int64_t{1} << 40, [&](std::int64_t number) {
    ++asked;
    return Loss{LossKind::ScanDamaged, number, {}, {}};
  });
  const std::vector<Loss> all = list.all();
  ASSERT_EQ(all.size(), static_cast<std::size_t>(kMostNamed) + 1);
  EXPECT_EQ(all.front().number, 5);
  EXPECT_EQ(all.back(), (Loss{LossKind::MoreDamaged, (std::int64_t{1} << 40) - 5 - kMostNamed, {}, {}}));
  EXPECT_LE(asked, kMostNamed + 1);
}

}  // namespace
}  // namespace vantage
