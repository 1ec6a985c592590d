#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "registration/motion_information.h"

namespace vantage {

enum class Verdict {
  Good,
  Doubtful,  ///< usable, but something speaks against trusting it
  Failed,    ///< not to be integrated
};

[[nodiscard]] std::string_view name(Verdict verdict);

/// When a registration is doubtful and when it has failed.
struct VerdictLimits {
  std::size_t minPairs = 100;       ///< fewer: failed
  std::size_t fewPairs = 400;       ///< fewer: doubtful
  double minInlierShare = 0.4;      ///< of the expected overlap; less: failed
  double lowInlierShare = 0.75;     ///< less: doubtful
  double doubtfulConflicts = 0.04;  ///< share of points the scanner looked through
  double maxConflicts = 0.15;       ///< more: failed
  double doubtfulResidual = 2.0;    ///< robust residual, in multiples of what noise and spacing explain
  double maxResidual = 4.0;         ///< more: failed
  double doubtfulMotion = 4.0;      ///< distance from the start pose in sigmas of the prior
  double maxMotion = 7.0;           ///< more: failed
  double maxPoseSigma = 0.1;        ///< of the pairs alone [mm]; more: doubtful
};

/// What a registration has to show for itself.
struct Evidence {
  std::size_t pairs = 0;
  double inlierShare = 0.0;
  double conflictShare = 0.0;
  double residual = 0.0;       ///< in multiples of what noise and spacing explain
  double motion = 0.0;         ///< in sigmas of the prior
  int heldByPrior = 0;         ///< number of independent motions that the pairs leave to the prior
  bool settled = false;        ///< the iterations came to rest
  double rivalDistance = 0.0;  ///< how far off another pose fits as well [mm]; 0: none
  Stability stability;         ///< of the pairs alone
};

struct Judgement {
  Verdict verdict = Verdict::Failed;
  std::string reason;  ///< the gravest finding as a sentence
};

[[nodiscard]] Judgement judge(const Evidence& evidence, const VerdictLimits& limits);

}  // namespace vantage
