#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planning/plan.h"
#include "void_space/void_patch.h"

namespace vantage {

/// A colour as red, green, blue, 0..255.
using Rgb = std::array<std::uint8_t, 3>;

/// Perceptual scales whose lightness rises all the way, so that they also read in grey and with any colour vision.
enum class ColourMap : std::uint8_t {
  Viridis,  ///< values of the void: dark violet to yellow
  Cividis,  ///< values of the model: dark blue to yellow
};

/// The colour of a value on a scale from 0 to 1. Values outside take the colour of the nearer end; NaN that of 0.
[[nodiscard]] Rgb colourAt(ColourMap map, double value);

/// One of eight colours that stay apart with any colour vision (Okabe and Ito), repeated in lighter shades from the
/// ninth on.
[[nodiscard]] Rgb categoryColour(std::size_t index);

/// The colour of a void patch by the class of its edge.
[[nodiscard]] Rgb edgeClassColour(EdgeClass edgeClass);

/// What is known of a void patch, as the views tell it.
enum class PatchState : std::uint8_t {
  Open,
  LookedAt,
  Answered,
  OutOfReach,
  TooSteep,
  LightBlocked,
  ReceiverBlocked,
  TooLittle,
  Erased
};
inline constexpr std::size_t kPatchStates = 9;

/// The state of a patch. Reasons count once the plan proposes no view any more.
[[nodiscard]] PatchState patchState(const PatchOutlook& outlook, PlanOutcome outcome);
[[nodiscard]] Rgb patchStateColour(PatchState state);

/// Lightness L* of a colour (CIE 1976), 0 for black to 100 for white.
[[nodiscard]] double lightness(const Rgb& colour);

}  // namespace vantage
