#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "acquisition/history.h"

namespace vantage {

namespace testing {
class JournalPen;
}

/// Where an acquisition is kept: its scans, and the commands that were carried out with the states they led to. Read by
/// anybody, written to by Acquisition alone, so that no state is in it that a command did not make.
class Journal {
 public:
  Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  virtual ~Journal() = default;

  [[nodiscard]] virtual const History& history() const = 0;
  /// The state at the cursor of the history.
  [[nodiscard]] virtual std::shared_ptr<const AcquisitionState> state() const = 0;

  /// How many scans were ever kept; their numbers run from 0.
  [[nodiscard]] virtual std::int64_t scanCount() const = 0;
  /// @throws InvalidInput when there is no such scan or it is damaged
  [[nodiscard]] virtual std::shared_ptr<const RangeImage> scan(std::int64_t number) const = 0;
  /// The last scan, when it is whole and no command has used it: a run was interrupted before it could be added.
  [[nodiscard]] virtual std::optional<NumberedScan> unusedScan() const = 0;
  /// Where the scan that was kept last was taken, whatever became of it; nothing before the first one.
  [[nodiscard]] virtual std::optional<Station> lastStation() const = 0;

  /// Keeps a scan for ever, before anything is made of it. @throws InvalidInput for a scan of no position of the
  /// profile; IoError when it cannot be written
  virtual NumberedScan keepScan(RangeImage image) = 0;

 protected:
  Journal(Journal&&) = default;
  Journal& operator=(Journal&&) = default;

 private:
  friend class Acquisition;
  friend class testing::JournalPen;

  /// Appends a command with the state it led to. @throws IoError: nothing has changed
  virtual void record(const Command& command, AcquisitionState state) = 0;
  /// @throws InvalidInput when there is nothing to undo, or to redo
  virtual void undo() = 0;
  virtual void redo() = 0;
};

}  // namespace vantage
