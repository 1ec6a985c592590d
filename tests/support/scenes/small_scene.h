#pragma once

#include <memory>

#include "acquisition/automatic_run.h"
#include "scanner/simulated_scanner.h"
#include "session/session.h"

namespace vantage::testing {

/// A coarse rotating stripe scanner with a turntable of 24 steps: about 3 mm between samples.
[[nodiscard]] ProfileSource smallProfileSource();
[[nodiscard]] std::shared_ptr<const ScannerProfile> smallProfile();

/// Three spheres of different size grown together: nothing about it is symmetric.
[[nodiscard]] Mesh smallObject();

/// An automatic acquisition of the small object.
[[nodiscard]] AcquisitionState acquireSmallObject(const AcquisitionSettings& settings, int threads,
                                                  const StepObserver& observer = {});

/// A new session before the small object.
[[nodiscard]] Session createSmallSession(const std::string& path, const AcquisitionSettings& settings);

/// Goes on with a session before the simulated scanner until it ends.
AcquisitionState runSmallSession(Session& session, const StepObserver& observer, const Progress& progress = {});

/// Records every step in the session.
[[nodiscard]] StepObserver recordIn(Session& session);

}  // namespace vantage::testing
