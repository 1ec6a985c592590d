#pragma once

#include <memory>

#include "acquisition/acquisition.h"
#include "session/session.h"
#include "support/simulation.h"

namespace vantage::testing {

/// A coarse rotating stripe scanner with a turntable of 24 steps: about 3 mm between samples.
[[nodiscard]] ProfileSource smallProfileSource();
[[nodiscard]] std::shared_ptr<const ScannerProfile> smallProfile();

/// Three spheres of different size grown together: nothing about it is symmetric.
[[nodiscard]] Mesh smallObject();

/// The simulated scanner before the small object, and the images of the profile.
[[nodiscard]] AcquisitionTools smallTools(const std::shared_ptr<const ScannerProfile>& profile,
                                          const AcquisitionSettings& settings = {}, int scansBefore = 0);

/// An automatic acquisition of the small object, kept in memory.
[[nodiscard]] AcquisitionState acquireSmallObject(const AcquisitionSettings& settings, int threads,
                                                  const Acquisition::StepObserver& observer = {});

/// A new session before the small object.
[[nodiscard]] Session createSmallSession(const std::string& path, const AcquisitionSettings& settings);

/// Goes on with a session before the simulated scanner until it ends.
AcquisitionState runSmallSession(Session& session, const Acquisition::StepObserver& observer = {},
                                 const Progress& progress = {});

/// A new session of recorded scans of the small object, without a scanner.
[[nodiscard]] Session importSmallScans(const std::string& path);

}  // namespace vantage::testing
