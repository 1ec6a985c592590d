#include "wording.h"

#include <gtest/gtest.h>

#include "report/loss_wording.h"
#include "report/wording.h"

namespace vantage {
namespace {

// Without a translation the window speaks as the command line does.
TEST(WindowWording, FindingsReadAsOnTheCommandLine) {
  const WeakMotions motions{{WeakMotion::Kind::Slide, Vec3(0.7, 0.7, 0.0)}, {WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  for (int i = 0; i <= static_cast<int>(kLastVerdictReason); ++i) {
    const Finding finding{static_cast<VerdictReason>(i), 0.87, motions};
    EXPECT_EQ(translated(phraseOf(finding)).toStdString(), describe(finding));
  }
  EXPECT_EQ(translated(phraseOf(WeakMotions{WeakMotion{}})), "moves freely");
  EXPECT_EQ(translated(phraseOf(WeakMotions{})), "");
}

TEST(WindowWording, CommandsReadAsOnTheCommandLine) {
  for (const Command& command :
       std::vector<Command>{ChangeSettings{}, AddScan{3, {}}, ImportScans{{1, 2}}, ChoosePosition{5}, LeaveOutView{4},
                            TakeBackView{4}, TakeAsFrom{4, 131.0}, Finish{Termination::Running}, TakeOver{},
                            TurnObject{}, PlaceStand{1, Pose::Identity()}, AlignStand{1}, ChooseStandPose{1, 2}, TakeReference{1},
                            ChangeMode{Mode::Assisted}})
    EXPECT_EQ(commandText(command).toStdString(), describe(command));
}

TEST(WindowWording, LossesReadAsOnTheCommandLineWhateverFilesAreCalled) {
  for (int i = 0; i <= static_cast<int>(kLastLossKind); ++i) {
    const Loss loss{static_cast<LossKind>(i), 4, "/data/%2.vantage", "/data/%1.vantage: it is %3 damaged"};
    const Phrase phrase = phraseOf(loss, "/data/%2.vantage");
    EXPECT_EQ(translated(phrase).toStdString(), english(phrase)) << i;
  }
}

TEST(WindowWording, EveryCodeHasWords) {
  for (int i = 0; i < kEdgeReasons; ++i)
    EXPECT_FALSE(edgeReasonText(static_cast<EdgeReason>(i), PlanOutcome::Found).isEmpty());
  for (std::size_t i = 0; i < kEdgeClasses; ++i) EXPECT_FALSE(edgeClassText(static_cast<EdgeClass>(i)).isEmpty());
  for (int i = 0; i <= static_cast<int>(kLastTermination); ++i)
    EXPECT_FALSE(terminationText(static_cast<Termination>(i)).isEmpty());
}

}  // namespace
}  // namespace vantage
