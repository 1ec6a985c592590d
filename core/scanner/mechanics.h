#pragma once

namespace vantage {

/// Errors of each move of a turntable, in the simulated scanner; the prior of every registration.
struct Mechanics {
  double angleSigma = 0.0;     ///< rotation about z [rad]
  double positionSigma = 0.0;  ///< translation in x and in y [mm]
};

}  // namespace vantage
