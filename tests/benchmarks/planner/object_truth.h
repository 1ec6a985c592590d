#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "scanner/profile.h"

namespace vantage {

/// Points of an object with what every position of a workspace sees of them, and what its noise-free scan samples.
/// Knows the object, as no planner does.
class ObjectTruth {
 public:
  using Marks = std::vector<std::uint8_t>;  ///< 1 per point that has it

  /// @param points spread over the object in proportion to area
  ObjectTruth(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile, int points,
              const Progress& progress);

  [[nodiscard]] double areaPerPoint() const { return areaPerPoint_; }  ///< [mm^2]
  /// Points that some position sees clear of the breakdown angle.
  [[nodiscard]] double scannable() const { return scannable_; }
  /// Share of them that noise-free scans from all positions sample: the ceiling that coverage is measured against.
  [[nodiscard]] double ceiling() const;
  /// Points that lie on a model, facing the same way.
  [[nodiscard]] Marks covered(const Mesh& model, const Progress& progress) const;
  /// Share of the scannable points among the marked ones.
  [[nodiscard]] double coverage(const Marks& covered) const;
  /// What each position would add by what it sees [mm^2].
  [[nodiscard]] std::vector<double> gains(const Marks& covered) const;
  /// How many views, of the first position and then of the greatest gain by what is sampled, reach the coverage.
  [[nodiscard]] int greedyViews(double coverage, int first) const;

 private:
  struct Point {
    Vec3 place;
    Vec3 normal;
  };
  void samplePoints(const Mesh& object, int count);

  std::shared_ptr<const ScannerProfile> profile_;
  std::vector<Point> points_;
  std::vector<Marks> seen_;     // per position
  std::vector<Marks> sampled_;  // per position
  Marks scannableMarks_;
  double areaPerPoint_ = 0.0;
  double scannable_ = 0.0;
};

}  // namespace vantage
