#include "support/scenes/small_scene.h"

#include "positional_space/scanner_images.h"
#include "session/kept_scans.h"
#include "support/meshes.h"

namespace vantage::testing {

ProfileSource smallProfileSource() {
  return {"small.json",
          R"({
    "name": "Small scanner",
    "scanner": { "type": "rotating_stripe", "position": [250, 0, 60], "stripe_height_mm": 120, "samples_per_stripe": 61,
      "stripes": 81, "sweep_deg": 50, "receivers": [[50, 0, 0]], "breakdown_angle_deg": 65, "range_mm": [100, 400],
      "noise": { "range_sigma_mm": 0.05, "dropout": 0.0 } },
    "workspace": { "type": "turntable", "steps": 24 },
    "viewing_volume": { "radius_mm": 90, "height_mm": 120 },
    "positional_space": { "surface": "cylinder", "rows": 10, "columns": 48 },
    "mechanics": { "angle_sigma_deg": 0.2, "position_sigma_mm": 0.2 } })",
          {}};
}

std::shared_ptr<const ScannerProfile> smallProfile() {
  return std::make_shared<const ScannerProfile>(parseProfile(smallProfileSource()));
}

Mesh smallObject() {
  return joined(joined(makeSphere(32, 24, {5, -8, 40}), makeSphere(20, 20, {-30, 12, 55})),
                makeSphere(14, 16, {30, 25, 30}));
}

AcquisitionState acquireSmallObject(const AcquisitionSettings& settings, int threads, const StepObserver& observer) {
  const auto profile = smallProfile();
  const ScannerImages images = computeScannerImages(*profile);
  SimulatedScanner scanner(smallObject(), profile, {settings.seed, settings.ideal});
  AcquisitionState state;
  state.profile = profile;
  state.settings = settings;
  return acquire(state, countedScans(scanner), images, observer, Progress().withThreads(threads));
}

Session createSmallSession(const std::string& path, const AcquisitionSettings& settings) {
  const Mesh object = smallObject();
  return Session::create(path, {smallProfileSource(), settings, &object});
}

StepObserver recordIn(Session& session) {
  return [&session](const Command& command, const AcquisitionState& state) { session.record(command, state); };
}

AcquisitionState runSmallSession(Session& session, const StepObserver& observer, const Progress& progress) {
  const AcquisitionSettings settings = session.state()->settings;
  SimulatedScanner scanner(session.object(), session.profile(), {settings.seed, settings.ideal},
                           static_cast<int>(session.scanCount()));
  const ScannerImages images = computeScannerImages(*session.profile());
  return acquire(*session.state(), keptScans(scanner, session), images, observer, progress);
}

}  // namespace vantage::testing
