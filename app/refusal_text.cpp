#include "refusal_text.h"

#include <QCoreApplication>

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Refusal)
};

}  // namespace

QString refusalText(const Refusal& refusal) {
  const QString number = QString::number(refusal.number.value_or(0));
  switch (refusal.reason) {
    case RefusalReason::NoProfile:
      return Text::tr("These are recorded scans without a scanner: there are no positions to scan from.");
    case RefusalReason::NoSuchPosition:
      return Text::tr("The scanner has no position %1.").arg(number);
    case RefusalReason::NoSuchStand:
      return Text::tr("The object has not stood in stand %1.").arg(number);
    case RefusalReason::StandKnown:
      return Text::tr("How the object stands in stand %1 is known already.").arg(number);
    case RefusalReason::NotAView:
      return Text::tr("Scan %1 is not part of the model.").arg(number);
    case RefusalReason::OnlyView:
      return Text::tr("Scan %1 is the only view of the model.").arg(number);
    case RefusalReason::NotLeftOut:
      return Text::tr("Scan %1 was not left out.").arg(number);
    case RefusalReason::ScanUsed:
      return Text::tr("Scan %1 was added before.").arg(number);
    case RefusalReason::ScansBefore:
      return Text::tr("Recorded scans are imported into an empty session only.");
    case RefusalReason::NoScans:
      return Text::tr("There is nothing to import.");
    case RefusalReason::AlreadyEnded:
      return Text::tr("The acquisition has ended.");
    case RefusalReason::NotEnded:
      return Text::tr("The acquisition has not ended.");
    case RefusalReason::NothingLeft:
      return Text::tr("Nothing is proposed any more. Choose a position yourself to go on.");
    case RefusalReason::LimitReached:
      return Text::tr("The greatest number of views, %1, is taken. Allow more to go on.").arg(number);
    case RefusalReason::NothingScanned:
      return Text::tr("Nothing has been scanned yet.");
    case RefusalReason::MeshesMade:
      return Text::tr("The object and how scans become surfaces can only be changed before the first scan.");
    case RefusalReason::Contradiction:
      return Text::tr("The settings contradict each other.");
    case RefusalReason::NotReplayable:
      return Text::tr("What an earlier version did cannot be done again.");
    case RefusalReason::NothingToUndo:
      return Text::tr("There is nothing to undo.");
    case RefusalReason::NothingToRedo:
      return Text::tr("There is nothing to redo.");
    case RefusalReason::NothingToScanWith:
      return Text::tr("There is nothing to scan with: no scanner, or no object for the simulated one.");
    case RefusalReason::FitsNoOtherTurn:
      return Text::tr("Scan %1 was not found to fit another turn of the table.").arg(number);
    case RefusalReason::NothingToAlign:
      return Text::tr("Stand %1 has no view yet: there is nothing to align.").arg(number);
    case RefusalReason::NotAligned:
      return Text::tr("Stand %1 has not been aligned yet.").arg(number);
    case RefusalReason::NoSuchPose:
      return Text::tr("Pose %1 is none of those that were found.").arg(number);
    case RefusalReason::PoseContradicted:
      return Text::tr("Something speaks against pose %1.").arg(number);
    case RefusalReason::StandsTogether:
      return Text::tr("Several stands make the object already. Undo what put them together first.");
    case RefusalReason::StandNotInWork:
      return Text::tr("Stand %1 is not aligned with the one that is worked on.").arg(number);
    case RefusalReason::NotErased:
      return Text::tr("There is no erasure %1 to take back.").arg(number);
    case RefusalReason::OtherStand:
      break;
  }
  return Text::tr("Scan %1 is of a stand that is not the one that is worked on.").arg(number);
}

}  // namespace vantage
