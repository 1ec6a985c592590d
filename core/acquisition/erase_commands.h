#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "acquisition/acquisition_state.h"
#include "acquisition/refusal.h"
#include "geometry/region.h"

namespace vantage {

class CommandTools;

// What every command says of itself is told in acquisition/command.h.

/// What is in a region is not the object: putty, a clamp, the table, a loose piece. It goes out of the model, and of
/// later scans it does not come in. Scans stay whole.
struct EraseRegion {
  static constexpr std::string_view kKind = "erase";
  int stand = 0;  ///< the region is in the frame of its table
  Region region = {};
  bool alone = false;  ///< only what was seen in this stand; else in all stands that make the model

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("stand", self.stand);
    field("region", self.region);
    field("alone", self.alone);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  /// @throws InvalidInput also for a region that is none, and when nothing of the model would be left
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// An erasure is taken back, also one that other steps came after: the model is made anew with what was erased.
struct TakeBackErasure {
  static constexpr std::string_view kKind = "take_back_erasure";
  int number = 0;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("number", self.number);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Commands about what is not the object.
using EraseCommand = std::variant<EraseRegion, TakeBackErasure>;

}  // namespace vantage
