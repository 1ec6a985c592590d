#pragma once

#include <vector>

#include "acquisition/journal.h"

namespace vantage {

/// An acquisition that is not kept: gone with the object.
class MemoryJournal final : public Journal {
 public:
  /// @param profile null for recorded scans without one
  MemoryJournal(std::shared_ptr<const ScannerProfile> profile, const AcquisitionSettings& settings);

  [[nodiscard]] const History& history() const override { return history_; }
  [[nodiscard]] std::shared_ptr<const AcquisitionState> state() const override;
  [[nodiscard]] std::int64_t scanCount() const override;
  [[nodiscard]] std::shared_ptr<const RangeImage> scan(std::int64_t number) const override;
  [[nodiscard]] std::optional<NumberedScan> unusedScan() const override;
  [[nodiscard]] std::optional<Station> lastStation() const override;
  NumberedScan keepScan(RangeImage image) override;

 private:
  void record(const Command& command, AcquisitionState state) override;
  void undo() override { history_.undo(); }
  void redo() override { history_.redo(); }

  History history_;
  std::vector<std::shared_ptr<const RangeImage>> scans_;
  std::vector<bool> used_;
};

}  // namespace vantage
