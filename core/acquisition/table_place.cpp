#include "acquisition/table_place.h"

#include <cmath>

#include "acquisition/stand_composites.h"

namespace vantage {
namespace {

// Less is what registration and a good table differ by [rad].
constexpr double kSlip = radians(1.0);

// A turn that can be told from none and from half a turn [rad].
constexpr double kLeastTurn = radians(5.0);
constexpr double kMostTurn = radians(170.0);
// How well a turn the other way is met [rad].
constexpr double kTurnedBack = radians(1.5);

bool turnedBack(const View& before, const View& view) {
  const double said = turnAboutAxis(view.image->T_table_scanner * before.image->T_table_scanner.inverse());
  const double found = turnAboutAxis(view.T_object_scanner * before.T_object_scanner.inverse());
  return std::abs(said) > kLeastTurn && std::abs(said) < kMostTurn && std::abs(found + said) < kTurnedBack;
}

// How much farther than the table says the last view of the stand of now was found.
double knownSlip(const AcquisitionState& state) {
  const KeptScan* view = lastView(state, state.stand());
  if (view == nullptr) return 0.0;
  const double farther = turnAboutAxis(tableOf(state, state.stand()).inverse() * view->view.T_object_scanner *
                                       view->view.image->T_table_scanner.inverse());
  return std::abs(farther) < kSlip ? 0.0 : farther;
}

// The scan that was taken last, of the stand of now; null without one.
std::shared_ptr<const RangeImage> lastImage(const Journal& journal, const AcquisitionState& state) {
  if (const auto unused = journal.unusedScan()) return unused->image;
  if (state.scans.empty()) return nullptr;
  return state.scans.back().view.image;
}

}  // namespace

double turnAboutAxis(const Pose& turn) {
  return std::atan2(turn.linear()(1, 0) - turn.linear()(0, 1), turn.linear()(0, 0) + turn.linear()(1, 1));
}

std::optional<double> slipOfLastScan(const AcquisitionState& state) {
  if (state.scans.empty() || state.scans.back().status != ScanStatus::In) return std::nullopt;
  const Finding& finding = state.scans.back().record.registration.finding;
  if (finding.reason != VerdictReason::TableSlipped || !finding.value) return std::nullopt;
  // The scanner goes round the object the other way than the table turns.
  return -radians(*finding.value);
}

std::vector<std::int64_t> scansTurnedBack(const AcquisitionState& state) {
  std::vector<std::int64_t> scans;
  const KeptScan* before = nullptr;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    const bool slipped = scan->record.registration.finding.reason == VerdictReason::TableSlipped;
    if (slipped && before != nullptr && before->view.image && scan->view.image &&
        before->station().stand == scan->station().stand && turnedBack(before->view, scan->view))
      scans.push_back(scan->number);
    before = scan;
  }
  return scans;
}

std::optional<TableStand> tableStand(const Journal& journal) {
  const auto position = tablePosition(journal);
  if (!position) return std::nullopt;
  const auto state = journal.state();
  TableStand stand{*position, 0.0, knownSlip(*state)};
  const auto image = lastImage(journal, *state);
  if (image && image->station == Station{state->stand(), *position})
    stand.counted = turnAboutAxis(image->T_table_scanner *
                                  state->profile->workspace.poses[static_cast<std::size_t>(*position)].inverse());
  return stand;
}

std::optional<int> tablePosition(const Journal& journal) {
  const auto state = journal.state();
  if (!state->profile || state->profile->workspace.size() == 0) return std::nullopt;
  const auto last = journal.lastStation();
  if (last && last->stand == state->stand() && last->position) return last->position;
  return 0;
}

}  // namespace vantage
