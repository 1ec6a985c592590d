#include "acquisition/refusal_error.h"

#include <string>

#include "base/errors.h"

namespace vantage {

void throwRefusal(const Refusal& refusal) {
  const std::string number = std::to_string(refusal.number.value_or(0));
  switch (refusal.reason) {
    case RefusalReason::NoProfile:
      throw InvalidInput("the session has no scanner profile, so no positions to scan from");
    case RefusalReason::NoSuchPosition:
      throw InvalidInput("position " + number + " does not exist in the workspace");
    case RefusalReason::NoSuchStand:
      throw InvalidInput("the object has not stood in stand " + number);
    case RefusalReason::StandKnown:
      throw InvalidInput("the pose of stand " + number + " is known already");
    case RefusalReason::NotAView:
      throw InvalidInput("scan " + number + " cannot be left out: it is not a view of the model");
    case RefusalReason::OnlyView:
      throw InvalidInput("scan " + number + " cannot be left out: it is the only view of the model");
    case RefusalReason::NotLeftOut:
      throw InvalidInput("scan " + number + " cannot be taken back: it was not left out");
    case RefusalReason::ScanUsed:
      throw InvalidInput("scan " + number + " cannot be added: it was added before");
    case RefusalReason::ScansBefore:
      throw InvalidInput("recorded scans can only be imported into an empty session");
    case RefusalReason::NoScans:
      throw InvalidInput("nothing to import: expected at least one range image");
    case RefusalReason::AlreadyEnded:
      throw InvalidInput("the acquisition has ended already");
    case RefusalReason::NotEnded:
      throw InvalidInput("the acquisition has not ended");
    case RefusalReason::NothingLeft:
      throw InvalidInput("there is nothing left to scan: no position would show more than is worth a scan");
    case RefusalReason::LimitReached:
      throw InvalidInput("the greatest number of views, " + number + ", was taken");
    case RefusalReason::NothingScanned:
      throw InvalidInput("there is no view of the object yet");
    case RefusalReason::MeshesMade:
      throw InvalidInput("the object and how scans become meshes cannot be changed once there are scans");
    case RefusalReason::Contradiction:
      throw InvalidInput("the settings contradict each other");
    case RefusalReason::NotReplayable:
      throw InvalidInput("views that were taken over from an earlier version cannot be replayed");
    case RefusalReason::NothingToUndo:
      throw InvalidInput("there is nothing to undo");
    case RefusalReason::NothingToRedo:
      throw InvalidInput("there is nothing to redo");
    case RefusalReason::NothingToScanWith:
      throw InvalidInput(
          "there is nothing to scan with: the session has no scanner, or no object that a simulated one could look at");
    case RefusalReason::FitsNoOtherTurn:
      throw InvalidInput("scan " + number +
                         " cannot be taken as from another turn of the table: only a scan that was refused can, and "
                         "only from a turn that it was found to fit");
    case RefusalReason::NothingToAlign:
      throw InvalidInput("stand " + number + " has no view yet, so there is nothing to align");
    case RefusalReason::NotAligned:
      throw InvalidInput("stand " + number + " has not been aligned yet, so there is no pose to choose");
    case RefusalReason::NoSuchPose:
      throw InvalidInput("pose " + number + " is none of those that the alignment found");
    case RefusalReason::PoseContradicted:
      throw InvalidInput("something speaks against pose " + number + ": it can only be used in spite of that");
    case RefusalReason::StandsTogether:
      throw InvalidInput("several stands make the object already: undo what put them together first");
    case RefusalReason::StandNotInWork:
      throw InvalidInput("stand " + number + " is not aligned with the one that is worked on");
    case RefusalReason::NotErased:
      throw InvalidInput("there is no erasure " + number + " to take back");
    case RefusalReason::OtherStand:
      break;
  }
  throw InvalidInput("scan " + number + " is of a stand that is not aligned with the one that is worked on");
}

}  // namespace vantage
