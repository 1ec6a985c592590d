#pragma once

#include <cstdint>

namespace vantage {

/// What the model's surface is coloured by.
enum class ModelColouring : std::uint8_t { Plain, Confidence, View, Age };

/// What void patches are coloured by.
enum class VoidColouring : std::uint8_t { EdgeClass, State };

/// What of a session the model view shows.
struct ModelViewOptions {
  ModelColouring colouring = ModelColouring::Plain;
  VoidColouring voidColouring = VoidColouring::EdgeClass;
  bool surface = true;
  bool boundary = true;
  bool voidPatches = true;
  bool currentRays = false;   ///< ranging rays and receivers of the last view
  bool proposedRays = false;  ///< of the proposed view, or of the examined position
  bool turntable = true;
  bool legends = true;

  bool operator==(const ModelViewOptions&) const = default;
};

}  // namespace vantage
