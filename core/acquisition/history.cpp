#include "acquisition/history.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"

namespace vantage {

StateOutline outlineOf(const AcquisitionState& state) {
  StateOutline outline{state.settings, state.mode, state.stands, {}, {}, state.chosenPosition, state.termination, 0, 0};
  for (const ModelAside& model : state.aside) outline.aside.push_back({model.composite, 0});
  for (const KeptScan& scan : state.scans) {
    auto record = std::make_shared<ScanRecord>(scan.record);
    record->planAfter = nullptr;
    outline.scans.push_back(
        {scan.number, scan.status, scan.station(), scan.view.T_object_scanner, std::move(record), 0, 0});
  }
  return outline;
}

Vec3 worldOffset(const StateOutline& outline) {
  for (const OutlinedScan& scan : outline.scans)
    if (scan.record && scan.record->reading) return scan.record->reading->offset;
  return Vec3::Zero();
}

std::size_t countScans(const StateOutline& outline, ScanStatus status) {
  return static_cast<std::size_t>(std::count_if(outline.scans.begin(), outline.scans.end(),
                                                [&](const OutlinedScan& scan) { return scan.status == status; }));
}

History::History(Loader loader) : loader_(std::move(loader)) {}

void History::add(HistoryEntry entry, const std::shared_ptr<const AcquisitionState>& state) {
  Kept kept{std::move(entry), state, state};
  if (!entries_.empty()) entries_.resize(cursor_ + 1);
  entries_.push_back(std::move(kept));
  if (loader_ && entries_.size() > 1) entries_[cursor_].held.reset();
  cursor_ = entries_.size() - 1;
}

void History::restore(std::vector<HistoryEntry> entries, std::size_t cursor) {
  if (cursor >= entries.size())
    throw InvalidInput("history: the cursor is at " + std::to_string(cursor) + " of " + std::to_string(entries.size()) +
                       " commands");
  entries_.clear();
  for (HistoryEntry& entry : entries) entries_.push_back({std::move(entry), nullptr, {}});
  cursor_ = cursor;
}

// The new state is brought back before the old one goes: what they share stays in memory.
void History::moveTo(std::size_t index) {
  std::shared_ptr<const AcquisitionState> next = entries_[cursor_].held ? state(index) : nullptr;
  if (loader_) entries_[cursor_].held.reset();
  entries_[index].held = std::move(next);
  cursor_ = index;
}

void History::undo() {
  if (!canUndo()) throw InvalidInput("there is nothing to undo");
  moveTo(cursor_ - 1);
}

void History::redo() {
  if (!canRedo()) throw InvalidInput("there is nothing to redo");
  moveTo(cursor_ + 1);
}

std::shared_ptr<const AcquisitionState> History::state(std::size_t index) const {
  const Kept& kept = entries_[index];
  if (std::shared_ptr<const AcquisitionState> state = kept.shown.lock()) return state;
  if (!loader_) throw InvalidInput("history: the state of step " + std::to_string(kept.entry.step) + " is not kept");
  std::shared_ptr<const AcquisitionState> state = loader_(kept.entry);
  kept.shown = state;
  if (index == cursor_) kept.held = state;
  return state;
}

}  // namespace vantage
