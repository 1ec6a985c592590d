#include "acquisition/memory_journal.h"

#include <string>
#include <utility>

#include "acquisition/apply_command.h"
#include "base/errors.h"

namespace vantage {

MemoryJournal::MemoryJournal(std::shared_ptr<const ScannerProfile> profile, const AcquisitionSettings& settings) {
  AcquisitionState empty;
  empty.profile = std::move(profile);
  record(ChangeSettings{settings}, applyCommand(empty, ChangeSettings{settings}, {}, {}));
}

std::shared_ptr<const AcquisitionState> MemoryJournal::state() const {
  return history_.state(history_.cursor());
}

std::int64_t MemoryJournal::scanCount() const {
  return static_cast<std::int64_t>(scans_.size());
}

std::shared_ptr<const RangeImage> MemoryJournal::scan(std::int64_t number) const {
  if (number < 0 || number >= scanCount()) throw InvalidInput("scan " + std::to_string(number) + " does not exist");
  return scans_[static_cast<std::size_t>(number)];
}

std::optional<NumberedScan> MemoryJournal::unusedScan() const {
  if (scans_.empty() || used_.back()) return std::nullopt;
  return NumberedScan{scanCount() - 1, scans_.back()};
}

std::optional<Station> MemoryJournal::lastStation() const {
  return scans_.empty() ? std::nullopt : std::optional(scans_.back()->station);
}

NumberedScan MemoryJournal::keepScan(RangeImage image) {
  validate(image);
  const std::optional<int> position = image.station.position;
  const std::shared_ptr<const AcquisitionState> now = state();
  if (now->profile && position && (*position < 0 || *position >= static_cast<int>(now->profile->workspace.size())))
    throw InvalidInput("a scan of position " + std::to_string(*position) + ", which does not exist");
  scans_.push_back(std::make_shared<const RangeImage>(std::move(image)));
  used_.push_back(false);
  return {scanCount() - 1, scans_.back()};
}

void MemoryJournal::record(const Command& command, AcquisitionState state) {
  for (const KeptScan& scan : state.scans)
    if (scan.number < scanCount()) used_[static_cast<std::size_t>(scan.number)] = true;
  auto shared = std::make_shared<const AcquisitionState>(std::move(state));
  const std::int64_t step = history_.size() == 0 ? 1 : history_.entry(history_.size() - 1).step + 1;
  history_.add({step, command, std::make_shared<const StateOutline>(outlineOf(*shared)), {}}, shared);
}

}  // namespace vantage
