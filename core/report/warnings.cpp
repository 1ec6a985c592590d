#include "report/warnings.h"

#include <algorithm>
#include <array>
#include <string>

#include "acquisition/hand_placing.h"
#include "acquisition/stand_composites.h"
#include "acquisition/table_place.h"
#include "geometry/measures.h"
#include "report/wording.h"

namespace vantage {
namespace {

// What is left for sure to be seen, as a share of the model, before it is said that little is covered.
constexpr double kLittleLeft = 0.05;

std::optional<WarningCode> codeOf(const KeptScan& scan) {
  switch (scan.status) {
    case ScanStatus::Rejected:
      return WarningCode::ScanRejected;
    case ScanStatus::Waiting:
      return WarningCode::ScanWaiting;
    case ScanStatus::In:
      if (scan.record.registration.verdict == Verdict::Doubtful) return WarningCode::ScanDoubtful;
      break;
    case ScanStatus::LeftOut:
    case ScanStatus::Aside:
      break;
  }
  return std::nullopt;
}

Warning warningOf(WarningCode code, const KeptScan& scan) {
  const RegistrationResult& registration = scan.record.registration;
  Warning warning{code, scan.number, registration.finding, {}, {}};
  if (isLoose(scan)) warning.value = registration.poseSigma;
  return warning;
}

// What is not well about the stands.
void addStands(const AcquisitionState& state, std::vector<Warning>& warnings) {
  for (int stand = 0; stand <= state.stand(); ++stand) {
    const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment;
    const bool known = isOfObject(state, stand);
    const bool isWell = known ? !alignment || alignment->choice != PoseChoice::Despite
                              : std::none_of(state.scans.begin(), state.scans.end(),
                                             [&](const KeptScan& scan) { return scan.station().stand == stand; });
    if (isWell) continue;
    warnings.push_back(
        {known ? WarningCode::StandDoubtful : WarningCode::StandNotAligned, {}, {}, {}, {}, stand, alignment});
  }
}

bool endedEarly(Termination termination) {
  return termination != Termination::Running && termination != Termination::Finished &&
         termination != Termination::Imported;
}

}  // namespace

std::string_view name(WarningCode code) {
  constexpr std::array<std::string_view, static_cast<std::size_t>(kLastWarningCode) + 1> kNames{
      "scan_rejected", "scan_doubtful",    "scan_waiting",      "nothing_covered", "little_covered",
      "ended_early",   "table_turns_back", "stand_not_aligned", "stand_doubtful"};
  return kNames[static_cast<std::size_t>(code)];
}

bool isSerious(const Warning& warning) {
  return warning.code != WarningCode::ScanDoubtful || !warning.finding ||
         warning.finding->reason != VerdictReason::HeldByMechanics || warning.value.has_value();
}

std::vector<Warning> warningsOf(const AcquisitionState& state, std::size_t firstScan) {
  std::vector<Warning> warnings;
  for (std::size_t i = firstScan; i < state.scans.size(); ++i)
    if (const auto code = codeOf(state.scans[i])) warnings.push_back(warningOf(*code, state.scans[i]));
  for (const std::int64_t scan : scansTurnedBack(state)) {
    const bool asked = firstScan < state.scans.size() && scan >= state.scans[firstScan].number;
    if (asked) warnings.push_back({WarningCode::TableTurnsBack, scan, {}, {}, {}});
  }
  const double covered = state.model ? area(state.model->mesh) : 0.0;
  const bool ended = state.termination != Termination::Running;
  if (!(covered > 0.0)) {
    warnings.push_back({WarningCode::NothingCovered, {}, {}, {}, {}});
  } else if (ended && state.plan && state.plan->voidLeft > kLittleLeft * covered) {
    warnings.push_back({WarningCode::LittleCovered, {}, {}, state.plan->voidLeft / covered, {}});
  }
  addStands(state, warnings);
  if (endedEarly(state.termination)) warnings.push_back({WarningCode::EndedEarly, {}, {}, {}, state.termination});
  return warnings;
}

Phrase phraseOf(const Warning& warning) {
  const Phrase scan = asIs(std::to_string(warning.scan.value_or(0)));
  const Phrase stand = asIs(std::to_string(warning.stand.value_or(0)));
  const Phrase finding = phraseOf(warning.finding.value_or(Finding{}));
  switch (warning.code) {
    case WarningCode::ScanRejected:
      return words("scan %1 was rejected and is not in the model: %2", {scan, finding});
    case WarningCode::ScanDoubtful:
      if (warning.value)
        return words("scan %1, whose table was turned by hand, is doubtful and may be off by %2 mm: %3",
                     {scan, figure(*warning.value, 1), finding});
      return words("scan %1 is doubtful: %2", {scan, finding});
    case WarningCode::ScanWaiting:
      return words("scan %1 waits until it is known how the object stood", {scan});
    case WarningCode::NothingCovered:
      return words("the model has no surface: nothing of the object was covered");
    case WarningCode::LittleCovered:
      return words("little is covered: there are positions that would still show %1 % of what the model has",
                   {figure(100.0 * warning.value.value_or(0.0))});
    case WarningCode::TableTurnsBack:
      return words(
          "scan %1 fits where the table would have turned the other way: if it always does, calibrate it, or say that "
          "its sense is -1",
          {scan});
    case WarningCode::StandNotAligned:
      if (!warning.alignment)
        return words("stand %1 is not aligned with the others yet and is not in the model", {stand});
      return words("stand %1 is not in the model: %2", {stand, phraseOf(*warning.alignment)});
    case WarningCode::StandDoubtful:
      return words("stand %1 is in the model although something speaks against it: %2",
                   {stand, phraseOf(*warning.alignment)});
    case WarningCode::EndedEarly:
      return words("the acquisition is not finished. %1",
                   {asIs(std::string(sentenceOf(warning.termination.value_or(Termination::Running))))});
  }
  return words("");
}

}  // namespace vantage
