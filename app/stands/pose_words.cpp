#include "stands/pose_words.h"

#include <QCoreApplication>

#include "look/figures.h"
#include "report/wording.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(StandPoses)
};

QString percent(double share) {
  return figureText(100.0 * share, 1);
}

QString whoDecided(PoseChoice choice) {
  switch (choice) {
    case PoseChoice::Evidence:
      return Text::tr("the evidence decided");
    case PoseChoice::Operator:
      return Text::tr("you chose the pose");
    case PoseChoice::Despite:
      break;
  }
  return Text::tr("you use the pose although something speaks against it; the report says so");
}

// What to do about a verdict.
QString wayOn(const StandAlignment& alignment) {
  if (alignment.verdict == AlignmentVerdict::Failed)
    return alignment.candidates.empty()
               ? Text::tr("Pick the same points on both, or scan more of this stand.")
               : Text::tr("Look at the poses, pick the same points on both, or scan more of this stand.");
  if (alignment.sameSurface) return Text::tr("It makes no difference which of them you use.");
  return alignment.reason == AlignmentReason::Slides
             ? Text::tr("Use the pose if the motion does not matter, or scan a stand that shows more.")
             : Text::tr("Look at them and use the right one, or scan more.");
}

}  // namespace

QString verdictText(int stand, const StandAlignment* alignment, bool known) {
  if (alignment == nullptr)
    return known ? Text::tr("Stand %1 is in place.").arg(stand)
                 : Text::tr("Stand %1 has not been aligned yet: look for poses, or pick the same points on both.")
                       .arg(stand);
  const QString why = translated(phraseOf(*alignment));
  if (known) return Text::tr("Stand %1 is in place: %2, %3.").arg(stand).arg(why, whoDecided(alignment->choice));
  return Text::tr("Stand %1 is not in place: %2. %3").arg(stand).arg(why, wayOn(*alignment));
}

QString poseTitle(int index, const StandPose& pose) {
  return (pose.possible ? Text::tr("Pose %1, possible") : Text::tr("Pose %1, unlikely")).arg(index + 1);
}

QString poseFigures(const StandPose& pose) {
  return Text::tr("%1 % in common, %2 mm apart\n%3 % contradicted\n%4 % expected, not seen")
      .arg(percent(pose.overlap), figureText(pose.rms, 2), percent(pose.conflict + pose.table), percent(pose.missing));
}

}  // namespace vantage
