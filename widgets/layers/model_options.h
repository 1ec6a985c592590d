#pragma once

#include <cstdint>
#include <optional>

#include "layers/section.h"

namespace vantage {

/// What the model's surface is coloured by: by Stand that in which it was seen first, by Colours what its scans saw.
enum class ModelColouring : std::uint8_t { Plain, Confidence, View, Age, Colours, Stand };

/// What void patches are coloured by.
enum class VoidColouring : std::uint8_t { EdgeClass, State };

/// What of its triangles a surface is drawn by.
enum class SurfaceStyle : std::uint8_t { Filled, Wireframe, Points };

/// What of a session the model view shows.
struct ModelViewOptions {
  /// Unset: in its colours where the model has some, else plain.
  std::optional<ModelColouring> colouring = std::nullopt;
  VoidColouring voidColouring = VoidColouring::EdgeClass;
  bool surface = true;
  bool boundary = true;
  bool voidPatches = true;
  bool currentRays = false;   ///< ranging rays and receivers of the last view
  bool proposedRays = false;  ///< of the proposed view, or of the examined position
  bool turntable = true;
  bool legends = true;
  SurfaceStyle style = SurfaceStyle::Filled;
  bool backFaces = false;                         ///< the inside of the surface stands out
  std::optional<Section> section = std::nullopt;  ///< what is before it is not shown

  bool operator==(const ModelViewOptions&) const = default;
};

}  // namespace vantage
