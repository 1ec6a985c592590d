#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "acquisition/command.h"

namespace vantage {

/// A scan of a state, without its large parts.
struct OutlinedScan {
  std::int64_t scan = 0;  ///< its number
  ScanStatus status = ScanStatus::In;
  Station station;
  Pose T_object_scanner = Pose::Identity();
  std::shared_ptr<const ScanRecord> record;  ///< without its plan
  std::int64_t recordStep = 0;               ///< the step that made the record
  std::int64_t planStep = 0;                 ///< the step that made the plan after it; 0 without one
};

/// The model of a composite that is not in work, without the model.
struct OutlinedModel {
  int composite = 0;
  std::int64_t step = 0;  ///< that made it

  bool operator==(const OutlinedModel&) const = default;
};

/// A state without its large parts: what a time line, a list of scans or a report of counts needs.
struct StateOutline {
  AcquisitionSettings settings;
  Mode mode = Mode::Automatic;
  std::vector<Stand> stands;
  std::vector<OutlinedScan> scans;
  std::vector<OutlinedModel> aside;
  std::optional<int> chosenPosition;
  Termination termination = Termination::Running;
  std::int64_t modelStep = 0;  ///< the step that made the model; 0 without one
  std::int64_t planStep = 0;   ///< the step that made the plan that holds; 0 without one
};

/// A state without its large parts and without the steps that made them.
[[nodiscard]] StateOutline outlineOf(const AcquisitionState& state);
[[nodiscard]] std::size_t countScans(const StateOutline& outline, ScanStatus status);
/// What was taken off recorded scans that were far from the origin [mm]: p_world = p_object + offset.
[[nodiscard]] Vec3 worldOffset(const StateOutline& outline);

/// One command that was carried out, and what it led to.
struct HistoryEntry {
  std::int64_t step = 0;  ///< number in its session, never given twice
  Command command;
  std::shared_ptr<const StateOutline> outline;  ///< after it
  std::optional<std::uint64_t> hash;            ///< stateHash after it; nothing where it was not made
};

/// The commands of a session in order, with a cursor that undo and redo move. The first entry is the set-up, which
/// cannot be undone. A command after undo cuts off what could have been redone.
///
/// States are immutable snapshots that share what did not change. Without a loader all of them stay in memory; with one
/// only that at the cursor does, and older ones as long as somebody holds them.
class History {
 public:
  /// Brings back the state of a step that is no longer in memory.
  using Loader = std::function<std::shared_ptr<const AcquisitionState>(const HistoryEntry&)>;

  explicit History(Loader loader = {});

  /// Appends a command behind the cursor and moves the cursor to it.
  void add(HistoryEntry entry, const std::shared_ptr<const AcquisitionState>& state);

  /// Takes over commands that were read from a file. @throws InvalidInput when the cursor is not one of them.
  void restore(std::vector<HistoryEntry> entries, std::size_t cursor);

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] const HistoryEntry& entry(std::size_t index) const { return entries_[index].entry; }
  /// Index of the entry that holds now. @pre size() > 0
  [[nodiscard]] std::size_t cursor() const { return cursor_; }
  [[nodiscard]] const HistoryEntry& current() const { return entries_[cursor_].entry; }

  [[nodiscard]] bool canUndo() const { return cursor_ > 0; }
  [[nodiscard]] bool canRedo() const { return cursor_ + 1 < entries_.size(); }
  /// @throws InvalidInput when there is nothing to undo, or to redo.
  void undo();
  void redo();

  /// The state after an entry, brought back when it is not in memory. @throws what the loader throws
  [[nodiscard]] std::shared_ptr<const AcquisitionState> state(std::size_t index) const;

 private:
  struct Kept {
    HistoryEntry entry;
    mutable std::shared_ptr<const AcquisitionState> held;  // of all entries without a loader, else of the cursor's
    mutable std::weak_ptr<const AcquisitionState> shown;
  };
  void moveTo(std::size_t index);

  Loader loader_;
  std::vector<Kept> entries_;
  std::size_t cursor_ = 0;
};

}  // namespace vantage
