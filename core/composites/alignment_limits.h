#pragma once

#include "registration/registration_scale.h"

namespace vantage {

/// The distances of an alignment, by spacing and noise of the samples and by the size of the object: for one of 160 mm
/// that is sampled every 1.2 mm with a noise of 0.1 mm they are about those in brackets.
struct AlignmentLimits {
  RegistrationScale scale;  ///< of both composites together
  double size = 1.0;        ///< across the larger composite [mm]
  double residual = 0.0;    ///< how far views of one composite lie off each other, the larger of both [mm]

  [[nodiscard]] double voxel() const;       ///< side of the cubes of a field (2.5) [mm]
  [[nodiscard]] double margin() const;      ///< of a field (32) [mm]
  [[nodiscard]] double coarseGate() const;  ///< largest distance of a pair, at first (20) [mm]
  [[nodiscard]] double nearGate() const;    ///< once every start has moved (8) [mm]
  [[nodiscard]] double closeGate() const;   ///< at the end of the coarse search (3) [mm]
  [[nodiscard]] double mediumGate() const;  ///< (4) [mm]
  [[nodiscard]] double sampleGate() const;  ///< about a spacing (1.2) [mm]
  [[nodiscard]] double fineGate() const;    ///< at the end (0.8) [mm]
  [[nodiscard]] double conflict()
      const;  ///< surface that rays went through lies this far before what they met (1.5) [mm]
  [[nodiscard]] double reliefStep() const;     ///< poses nearer to each other in shift are the same start (5) [mm]
  [[nodiscard]] double distinctShift() const;  ///< poses farther apart in shift are two (2) [mm]
};

/// Of two composites.
[[nodiscard]] AlignmentLimits limitsOf(const RegistrationScale& a, const RegistrationScale& b);

}  // namespace vantage
