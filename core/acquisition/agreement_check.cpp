#include "acquisition/agreement_check.h"

#include <vector>

#include "acquisition/erased_regions.h"
#include "acquisition/hand_placing.h"
#include "acquisition/prepared_scans.h"
#include "registration/scan_set.h"

namespace vantage {

void checkAgainstOthers(const AcquisitionState& state, KeptScan& scan, const StepOptions& options,
                        const Progress& progress) {
  const bool isDoubtful = scan.record.registration.verdict == Verdict::Doubtful;
  const bool isLooseToo =
      turnedByGuess(*scan.view.image) && isUnknown(scan.record.registration, scan.view.mesh->spacing);
  std::vector<const KeptScan*> scans;
  // What is known fears no views of which nobody knows where they are.
  for (const KeptScan* other : scansOf(state, ScanStatus::In))
    if (isLooseToo || !isLoose(*other)) scans.push_back(other);
  if (scans.empty()) return;
  scans.push_back(&scan);
  std::vector<View> views;
  for (const KeptScan* each : scans) views.push_back(each->view);
  views.back().T_object_scanner = scan.record.registration.T_object_scanner;
  const auto contradiction =
      contradictionOfLast(views, preparedViews(scans, progress.part(0.0, 0.5)), isDoubtful,
                          surfaceInStand(state, scan.station().stand), options.registration, progress.part(0.5, 1.0));
  if (!contradiction) return;
  scan.record.registration.verdict = Verdict::Failed;
  scan.record.registration.finding = {VerdictReason::ContradictsOthers, *contradiction, {}};
}

}  // namespace vantage
