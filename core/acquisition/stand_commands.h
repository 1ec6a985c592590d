#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "acquisition/acquisition_state.h"
#include "acquisition/refusal.h"

namespace vantage {

class CommandTools;

// What every command says of itself is told in acquisition/command.h.

/// The object was turned over: from now on scans are of a new stand.
struct TurnObject {
  static constexpr std::string_view kKind = "turn_object";
  std::optional<Pose> T_object_table;  ///< how it stands now; nothing while nobody knows

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("T_object_table", self.T_object_table);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// It became known how the object stands in a stand: scans of it that were waiting become views.
struct PlaceStand {
  static constexpr std::string_view kKind = "place_stand";
  int stand = 0;
  Pose T_object_table = Pose::Identity();

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("stand", self.stand);
    field("T_object_table", self.T_object_table);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Commands about how the object stands.
using StandCommand = std::variant<TurnObject, PlaceStand>;

}  // namespace vantage
