#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "acquisition/acquisition_state.h"

namespace vantage {

/// What a stand is to the object.
enum class StandRole : std::uint8_t {
  Reference,   ///< the first one: the object's frame
  Aligned,     ///< it is part of the object
  Doubtful,    ///< it is, by one of several possible poses that the operator chose
  Despite,     ///< it is, although something speaks against it
  NotAligned,  ///< it is a model of its own
};
[[nodiscard]] StandRole standRoleOf(const std::vector<Stand>& stands, int stand);

/// "reference", "aligned", ...: a few words for a strip or a table.
[[nodiscard]] QString standRoleText(StandRole role);

/// What came of aligning a stand, or what it waits for, as a sentence.
[[nodiscard]] QString standSentence(const std::vector<Stand>& stands, int stand);

/// The same of an alignment that is not recorded.
[[nodiscard]] QString trialSentence(int stand, const StandAlignment& alignment);

/// Which model a state shows, where it is not the object: "Stand 1, not put together with the object yet". Empty where
/// it is.
[[nodiscard]] QString ownModelText(const AcquisitionState& state);

/// How a report calls a picture of what a state shows.
[[nodiscard]] QString pictureCaption(const AcquisitionState& state, const QString& caption);

/// Which stands have views that are no part of the object, as a sentence; empty where none has.
[[nodiscard]] QString missingStandsText(const AcquisitionState& state);

/// The stands of an object where it has several, one sentence each, a line for each; else empty.
[[nodiscard]] QString standsText(const AcquisitionState& state);

}  // namespace vantage
