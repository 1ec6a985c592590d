#include "support/scenes/small_scene.h"

#include "acquisition/memory_journal.h"
#include "positional_space/scanner_images.h"
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

AcquisitionTools smallTools(const std::shared_ptr<const ScannerProfile>& profile, const AcquisitionSettings& settings,
                            int scansBefore) {
  const SimulationOptions options{settings.simulation.seed, settings.simulation.ideal};
  return {simulation(smallObject(), profile, options, scansBefore),
          std::make_shared<const ScannerImages>(computeScannerImages(*profile))};
}

AcquisitionState acquireSmallObject(const AcquisitionSettings& settings, int threads,
                                    const Acquisition::StepObserver& observer) {
  const auto profile = smallProfile();
  MemoryJournal journal(profile, settings);
  Acquisition acquisition(journal, smallTools(profile, settings), observer);
  acquisition.runUntilTheEnd(Progress().withThreads(threads));
  return *journal.state();
}

Session createSmallSession(const std::string& path, const AcquisitionSettings& settings) {
  const Mesh object = smallObject();
  return Session::create(path, {smallProfileSource(), settings, &object});
}

AcquisitionState runSmallSession(Session& session, const Acquisition::StepObserver& observer,
                                 const Progress& progress) {
  const AcquisitionSettings settings = session.state()->settings;
  const auto scans = static_cast<int>(session.scanCount());
  Acquisition acquisition(session, smallTools(session.profile(), settings, scans), observer);
  acquisition.runUntilTheEnd(progress);
  return *session.state();
}

Session importSmallScans(const std::string& path) {
  const Rig rig = simulation(smallObject(), smallProfile(), {1, true});
  std::vector<RangeImage> images;
  for (const int position : {0, 2, 4}) {
    images.push_back(scanFrom(rig, position, {}));
    images.back().station.position.reset();
    images.back().poseKnownBy = PoseSource::Reported;
  }
  Session session = Session::create(path, {{}, {}, nullptr, nullptr});
  Acquisition(session).importScans(std::move(images));
  return session;
}

}  // namespace vantage::testing
