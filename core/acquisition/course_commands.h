#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "acquisition/acquisition_state.h"
#include "acquisition/refusal.h"

namespace vantage {

class CommandTools;

// What every command says of itself is told in acquisition/command.h.

/// The set-up of a session is changed. Also the first command of every session.
struct ChangeSettings {
  static constexpr std::string_view kKind = "change_settings";
  AcquisitionSettings settings;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("", self.settings);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// The operator wants another position than the proposed one next; nothing goes back to the proposal.
struct ChoosePosition {
  static constexpr std::string_view kKind = "choose_position";
  std::optional<int> position;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("position", self.position);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// The acquisition is ended, or, with Running, opened again.
struct Finish {
  static constexpr std::string_view kKind = "finish";
  Termination termination = Termination::EndedByOperator;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("termination", self.termination);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// From now on the next step is taken by the program, or by a person.
struct ChangeMode {
  static constexpr std::string_view kKind = "change_mode";
  Mode mode = Mode::Automatic;

  template <typename Self, typename Field>
  static void fields(Self& self, Field&& field) {
    field("mode", self.mode);
  }
  [[nodiscard]] std::optional<Refusal> mayDo(const AcquisitionState& state) const;
  [[nodiscard]] AcquisitionState carriedOut(const AcquisitionState& state, const CommandTools& tools) const;
};

/// Commands that say how the acquisition goes on.
using CourseCommand = std::variant<ChangeSettings, ChoosePosition, Finish, ChangeMode>;

}  // namespace vantage
