#include "report/loss_wording.h"

namespace vantage {

Phrase phraseOf(const Loss& loss, const std::string& path) {
  const Phrase session = asIs(path);
  const Phrase number = asIs(std::to_string(loss.number.value_or(0)));
  const Phrase name = asIs(loss.name);
  Phrase error = asIs(loss.error);
  switch (loss.kind) {
    case LossKind::Copied:
      return words("%1: is damaged; before anything was written to it, it was copied to %2", {session, name});
    case LossKind::TableDamaged:
      return words("%1: the table %2 is damaged, %3 rows of it were read", {session, name, number});
    case LossKind::RowsUnread:
      return words("%1: not all rows of %2 could be read", {error, name});
    case LossKind::LastStepLost:
      return words("%1: step %2, the last one, is lost", {session, number});
    case LossKind::StepLost:
      return words("%1: step %2 is lost", {session, number});
    case LossKind::StepIncomplete:
      return words("%1: step %2 is lost: not all of its views are there", {session, number});
    case LossKind::StepImpossible:
      return words("%1: step %2 is lost: it names no position", {session, number});
    case LossKind::ModelDamaged:
      return words("%1; it is made again", {error});
    case LossKind::ModelOfOtherViews:
      return words("%1: model %2 is of other views; it is made again", {session, number});
    case LossKind::ModelOfOtherSamples:
      return words("%1: model %2 is of other samples; it is made again", {session, number});
    case LossKind::PlanOfOtherPositions:
      return words("%1: plan %2 is of other positions", {session, number});
    case LossKind::StateMadeAgain:
      return words("%1: step %2 was not as it was written; it was carried out again from its scans", {session, number});
    case LossKind::StateUntrue:
      return words(
          "%1: step %2 is not as it was written: do not trust its model. Go back to a step before it, or begin "
          "anew with its scans",
          {session, number});
    case LossKind::FilesLost:
      return words("%1: %2 files of the scanner's profile are lost", {session, number});
    case LossKind::ObjectChanged:
      return words("%1: the object of the simulated scanner is not the one that was kept", {session});
    case LossKind::MoreDamaged:
      if (loss.name.empty()) return words("%1: %2 more damages of this kind", {session, number});
      return words("%1: %2 more of %3 are damaged", {session, number, name});
    case LossKind::StepsUnread:
      return words("%1: has very many steps; those before step %2 were not read, and stay in the file",
                   {session, number});
    case LossKind::RowDamaged:
    case LossKind::ScanDamaged:
    case LossKind::PlanDamaged:
      break;
  }
  return error;
}

}  // namespace vantage
