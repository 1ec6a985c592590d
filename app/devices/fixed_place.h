#pragma once

#include <memory>
#include <utility>

#include "base/errors.h"
#include "scanner/positioner.h"

namespace vantage {

/// Nothing moves: the scanner stays at position 0.
class FixedPlace final : public Positioner {
 public:
  explicit FixedPlace(std::shared_ptr<const ScannerProfile> profile) : profile_(std::move(profile)) {}

  [[nodiscard]] std::string identity() const override { return "no table"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] ReachedPose moveTo(int position, const Progress& /*progress*/) override {
    if (position != 0)
      throw DeviceError("no table: nothing moves the scanner to position " + std::to_string(position) +
                        "; choose a table, or turn the object by hand");
    return {0, workspacePose(*this, profile_->workspace, 0), PoseSource::Commanded, {}};
  }
  [[nodiscard]] std::optional<ReachedPose> where() const override {
    return ReachedPose{0, profile_->workspace.poses.front(), PoseSource::Commanded, {}};
  }

 private:
  std::shared_ptr<const ScannerProfile> profile_;
};

}  // namespace vantage
