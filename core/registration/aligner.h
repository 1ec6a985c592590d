#pragma once

#include <cstdint>
#include <vector>

#include "registration/icp.h"
#include "registration/pair_finding.h"
#include "registration/pair_term.h"

namespace vantage {

/// A pose found by iterating, and the last round's pairs.
struct Fit {
  Pose T_object_scanner = Pose::Identity();
  std::vector<Pair> pairs;
  double sigma = 0.0;   ///< robust deviation of the pairs' distances [mm]
  int heldByPrior = 0;  ///< number of independent motions that the pairs leave to the prior
  int iterations = 0;
  bool settled = false;
};

/// The iterations of registerView, which runs them with few points, with many, and from rivals of the start pose.
class Aligner {
 public:
  /// Keeps referring to all but the pose and the prior. @pre `options` are resolved
  Aligner(const ViewSurface& surface, const RegistrationTarget& model, const Pose& T_object_scanner,
          const PosePrior& prior, const IcpOptions& options);

  /// Ids of about `count` points of the model, spread evenly; all when there are fewer.
  [[nodiscard]] std::vector<std::uint32_t> pick(std::size_t count) const;

  /// Those among `ids` that the view sees from a pose, or would from one nearby; about `count`, spread evenly.
  [[nodiscard]] std::vector<std::uint32_t> visible(const Pose& T_object_scanner, const std::vector<std::uint32_t>& ids,
                                                   std::size_t count, const Progress& progress) const;

  struct Schedule {
    double firstGate;  ///< [mm]
    double lastGate;   ///< [mm]
    double tolerance;  ///< [mm]
    int maxIterations;
  };
  [[nodiscard]] Fit run(const Pose& T_object_scanner, const std::vector<std::uint32_t>& ids, const Schedule& schedule,
                        const Progress& progress) const;

  /// Motion away from the start pose in sigmas of the prior.
  [[nodiscard]] double motionInSigmas(const Pose& T_object_scanner) const;

 private:
  struct Step;
  [[nodiscard]] PairGates gatesAt(double gate) const;
  [[nodiscard]] Step solve(const Pose& T_object_scanner, std::span<const Pair> pairs, const PairNoise& noise,
                           double share) const;

  const ViewSurface& surface_;
  const RegistrationTarget& model_;
  const IcpOptions& options_;
  Pose T_start_;
  PosePrior prior_;
};

}  // namespace vantage
