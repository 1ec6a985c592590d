#include "acquisition/agreement_check.h"

#include "acquisition/hand_placing.h"
#include "registration/scan_set.h"

namespace vantage {

std::vector<PreparedView> checkAgainstOthers(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                                             const Progress& progress) {
  const bool isDoubtful = scan.record.registration.verdict == Verdict::Doubtful;
  // What is good fears no views of which nobody knows where they are.
  std::vector<View> views = isDoubtful ? viewsOf(state) : firmViews(state);
  views.push_back(scan.view);
  views.back().T_object_scanner = scan.record.registration.T_object_scanner;
  if (views.size() < 2) return {};
  std::vector<PreparedView> prepared = prepareViews(views, progress.part(0.0, 0.7));
  const auto contradiction =
      contradictionOfLast(views, prepared, isDoubtful, options.registration, progress.part(0.7, 1.0));
  if (!contradiction) return prepared;
  scan.record.registration.verdict = Verdict::Failed;
  scan.record.registration.finding = {VerdictReason::ContradictsOthers, *contradiction, {}};
  return prepared;
}

}  // namespace vantage
