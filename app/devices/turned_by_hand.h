#pragma once

#include <memory>
#include <utility>

#include "scanner/hand_table.h"

namespace vantage {

/// A simulated table that a person says they turned: for practice, and for tests.
class TurnedByHand final : public Positioner {
 public:
  TurnedByHand(std::shared_ptr<Positioner> table, std::shared_ptr<HandTable> hand)
      : table_(std::move(table)), hand_(std::move(hand)) {}

  [[nodiscard]] std::string identity() const override { return hand_->identity(); }
  void open(const Progress& progress) override { table_->open(progress); }
  void close() noexcept override { table_->close(); }
  [[nodiscard]] std::optional<std::string> notReady() const override { return table_->notReady(); }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& progress) override {
    const ReachedPose said = hand_->moveTo(position, progress);
    static_cast<void>(table_->moveTo(position, progress));
    return said;
  }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return hand_->where(); }

 private:
  std::shared_ptr<Positioner> table_;
  std::shared_ptr<HandTable> hand_;
};

}  // namespace vantage
