#include "report/loss_wording.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

TEST(LossWording, NamesTheFileTheThingAndItsNumber) {
  const std::string path = "s.vantage";
  EXPECT_EQ(english(phraseOf({LossKind::Copied, {}, "s.vantage.damaged-1", {}}, path)),
            "s.vantage: is damaged; before anything was written to it, it was copied to s.vantage.damaged-1");
  EXPECT_EQ(english(phraseOf({LossKind::TableDamaged, 12, "model", {}}, path)),
            "s.vantage: the table model is damaged, 12 rows of it were read");
  EXPECT_EQ(english(phraseOf({LossKind::LastStepLost, 3, {}, {}}, path)), "s.vantage: step 3, the last one, is lost");
  EXPECT_EQ(english(phraseOf({LossKind::StepIncomplete, 5, {}, {}}, path)),
            "s.vantage: step 5 is lost: not all of its views are there");
  EXPECT_EQ(english(phraseOf({LossKind::ModelOfOtherSamples, 7, {}, {}}, path)),
            "s.vantage: model 7 is of other samples; it is made again");
}

TEST(LossWording, KeepsTheWordsOfWhoeverReadIt) {
  const std::string error = "s.vantage: model 4 is damaged: it ends early";
  EXPECT_EQ(english(phraseOf({LossKind::ScanDamaged, 4, {}, error}, "s.vantage")), error);
  EXPECT_EQ(english(phraseOf({LossKind::ModelDamaged, 4, {}, error}, "s.vantage")), error + "; it is made again");
  EXPECT_EQ(english(phraseOf({LossKind::RowsUnread, {}, "step", "s.vantage: disk I/O error"}, "s.vantage")),
            "s.vantage: disk I/O error: not all rows of step could be read");
}

TEST(LossWording, NoKindIsWithoutWords) {
  for (int i = 0; i <= static_cast<int>(kLastLossKind); ++i)
    EXPECT_TRUE(english(phraseOf({static_cast<LossKind>(i), 1, "name", "s.vantage: error"}, "s.vantage"))
                    .starts_with("s.vantage: "))
        << i;
}

}  // namespace
}  // namespace vantage
