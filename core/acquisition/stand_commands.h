#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "acquisition/acquisition_state.h"
#include "acquisition/refusal.h"
#include "acquisition/stand_aligner.h"

namespace vantage {

class CommandTools;

// What every command says of itself is told in acquisition/command.h.

/// The object was turned over: from now on scans are of a new stand, and, while nobody knows how the object stands in
/// it, of a composite of their own.
struct TurnObject {
  static constexpr std::string_view kKind = "turn_object";
  std::optional<Pose> T_object_table;  ///< how it stands now; nothing while nobody knows
  std::optional<Vec3> down = {};       ///< the side it was put on, see Stand::down

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("T_object_table", self.T_object_table);
    field("down", self.down);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// The operator says how the object stands in a stand: its views become views of the object.
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

/// The composite of a stand is aligned with the object. With a good verdict its views become views of the object;
/// otherwise what was found is kept, for the operator to choose from.
struct AlignStand {
  static constexpr std::string_view kKind = "align";
  int stand = 0;
  PickedPairs picks = {};  ///< where the search begins; none: everywhere

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("stand", self.stand);
    field("picks", self.picks);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// The operator decides on one of the poses that the last alignment of a stand has found.
struct ChooseStandPose {
  static constexpr std::string_view kKind = "choose_stand_pose";
  int stand = 0;
  int pose = 0;          ///< index among the candidates
  bool despite = false;  ///< also one that something speaks against

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("stand", self.stand);
    field("pose", self.pose);
    field("despite", self.despite);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// The object is known by another stand from here on: what was its only stand so far waits to be aligned with it. Where
/// the first stand shows too little to fit others to, one that shows more takes its place. Once a stand before the
/// reference is aligned, the object is known by that one again.
struct TakeReference {
  static constexpr std::string_view kKind = "take_reference";
  int stand = 0;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("stand", self.stand);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Commands about how the object stands.
using StandCommand = std::variant<TurnObject, PlaceStand, AlignStand, ChooseStandPose, TakeReference>;

}  // namespace vantage
