#pragma once

#include <span>

#include "registration/view_surface.h"

namespace vantage {

struct IcpOptions;
struct MultiViewOptions;

/// What distances are measured by: nothing about a registration is the same in millimetres for a tooth and a statue.
struct RegistrationScale {
  double spacing = 1.0;  ///< between neighbouring samples [mm]
  double noise = 0.0;    ///< of the samples across the surface, from how they scatter [mm]
  double extent = 1.0;   ///< diagonal of what a view shows [mm]
};

[[nodiscard]] RegistrationScale scaleOf(const ViewSurface& surface);

/// Medians of spacing and noise, largest extent; 1, 0 and 1 mm for none.
[[nodiscard]] RegistrationScale scaleOf(std::span<const RegistrationScale> views);

/// Farthest that noise and the gaps between samples let a partner lie along the normal [mm]: half a spacing and six
/// sigmas of the noise.
[[nodiscard]] double fineGate(const RegistrationScale& scale);

/// How far off a pose is taken to be where nobody says [mm]: a fortieth of the extent.
[[nodiscard]] double looseShift(const RegistrationScale& scale);

/// The options with all that they leave open set by the scale: the final gate is the fine gate; the coarse gate and the
/// depth of what counts as hidden are a twelfth of the extent, at least four fine gates; a pose is sure to 0.08
/// spacings or half a sigma of the noise.
[[nodiscard]] IcpOptions resolved(const IcpOptions& options, const RegistrationScale& scale);

/// The same for a refinement, whose coarse gate is two and a half fine gates.
[[nodiscard]] MultiViewOptions resolved(const MultiViewOptions& options, const RegistrationScale& scale);

}  // namespace vantage
