#pragma once

#include <optional>
#include <vector>

#include "geometry/vectors.h"
#include "scanner/length_unit.h"

namespace vantage {

/// What the numbers of range files say about their unit.
struct UnitEvidence {
  double size = 0.0;               ///< longest side of the box about the samples of one scan [units]
  double pitch = 0.0;              ///< median distance of neighbouring samples [units]
  std::optional<double> distance;  ///< from scanner to surface, where the lines of sight tell [units]
  bool usuallyMetres = false;      ///< files of this format are in metres, as a rule
};

struct UnitGuess {
  LengthUnit unit = LengthUnit::Millimetre;  ///< millimetres or metres
  bool clear = true;                         ///< whether the other one is plainly out of the question
};

/// Millimetres or metres: each of size, pitch and distance is compared with those of scanners of objects (log-normal
/// about 150 mm, 0.6 mm, 500 mm). Clear where one is at least e^2 times as likely as the other. Centimetres and inches
/// look like either and are never guessed.
[[nodiscard]] UnitGuess guessUnit(const UnitEvidence& evidence);

/// Units of the range files per unit of their list of poses: 1 unless the scans then lie farther apart than their size
/// and come together with another ratio of known units. `middles` and `poses` belong to the same scans, in the units
/// that they have.
[[nodiscard]] double poseUnitRatio(const std::vector<Vec3>& middles, const std::vector<Pose>& poses, double size);

}  // namespace vantage
