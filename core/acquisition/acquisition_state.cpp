#include "acquisition/acquisition_state.h"

#include <algorithm>

namespace vantage {

std::string_view name(Termination termination) {
  switch (termination) {
    case Termination::Running:
      return "running";
    case Termination::Finished:
      return "finished";
    case Termination::NoOverlap:
      return "no_overlap";
    case Termination::MaxViews:
      return "max_views";
    case Termination::RegistrationFailed:
      return "registration_failed";
    case Termination::Cancelled:
      return "cancelled";
    case Termination::EndedByOperator:
      return "ended_by_operator";
    case Termination::Imported:
      break;
  }
  return "imported";
}

std::string_view name(Mode mode) {
  return mode == Mode::Automatic ? "automatic" : "assisted";
}

std::vector<View> viewsOf(const AcquisitionState& state) {
  std::vector<View> views;
  for (const KeptScan& scan : state.scans)
    if (scan.status == ScanStatus::In) views.push_back(scan.view);
  return views;
}

std::vector<const KeptScan*> scansOf(const AcquisitionState& state, ScanStatus status) {
  std::vector<const KeptScan*> scans;
  for (const KeptScan& scan : state.scans)
    if (scan.status == status) scans.push_back(&scan);
  return scans;
}

std::size_t countScans(const AcquisitionState& state, ScanStatus status) {
  return static_cast<std::size_t>(std::count_if(state.scans.begin(), state.scans.end(),
                                                [&](const KeptScan& scan) { return scan.status == status; }));
}

const KeptScan* lastView(const AcquisitionState& state, std::optional<int> stand) {
  const auto last = std::find_if(state.scans.rbegin(), state.scans.rend(), [&](const KeptScan& scan) {
    return scan.status == ScanStatus::In && (!stand || scan.station().stand == *stand);
  });
  return last == state.scans.rend() ? nullptr : &*last;
}

const KeptScan* findScan(const AcquisitionState& state, std::int64_t number) {
  const auto scan =
      std::find_if(state.scans.begin(), state.scans.end(), [&](const KeptScan& kept) { return kept.number == number; });
  return scan == state.scans.end() ? nullptr : &*scan;
}

Pose poseOf(const AcquisitionState& state, int position) {
  return state.stands.back().T_object_table.value_or(Pose::Identity()) *
         state.profile->workspace.poses[static_cast<std::size_t>(position)];
}

}  // namespace vantage
