#include "calibration/table_calibrator.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "base/random.h"
#include "turning_scene.h"

namespace vantage::testing {
namespace {

TEST(Scratch, Measure) {
  const std::vector<double> angles{0, 20, 45, 75, 110, 150};
  const int seeds = std::getenv("SEEDS") ? std::atoi(std::getenv("SEEDS")) : 3;
  for (int object = 0; object < 2; ++object) {
    for (int scanner = 0; scanner < 2; ++scanner) {
      for (int seed = 1; seed <= seeds; ++seed) {
        TurningScene scene;
        scene.object = object == 0 ? makeLump() : makeCup();
        scene.profile = scanner == 0 ? cameraOverTable() : stripeScanner();
        scene.seed = static_cast<std::uint64_t>(seed);
        scene.wall = true;
        Random random(static_cast<std::uint64_t>(seed), 77);
        auto u = [&] { return 2.0 * random.uniform() - 1.0; };
        scene.T_table_scanner = offBy(8.0 * Vec3(u(), u(), u()), 3.0 * Vec3(u(), u(), u()), Vec3(300, 0, 75));
        const double ratios[] = {1.0, -1.0, 0.97, -1.1};
        scene.turnsPerCount = ratios[seed % 4];
        scene.angleSigma = radians(0.2);
        const auto scans = scene.scans(angles);
        const auto begin = std::chrono::steady_clock::now();
        const auto result = calibrateTable(scans, *scene.profile, {}, Progress({}, {}, 2));
        const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const auto e = errorOf(result.calibration, scene.T_table_scanner, 50.0);
        std::printf(
            "object %d scanner %d seed %d: dir %.4f deg (s %.4f) place %.4f mm (s %.4f) plane %.3f (s %.3f) ratio "
            "%+.5f (%+.3f) rms %.3f %s %.1fs |",
            object, scanner, seed, e.direction, degrees(result.calibration.angleSigma), e.place,
            result.calibration.sigma, e.plane, result.planeSigma,
            result.calibration.sense * result.calibration.degreesPerCommandedDegree, scene.turnsPerCount,
            result.calibration.residual, std::string(name(result.calibration.verdict)).c_str(), s);
        for (const auto& f : result.findings)
          std::printf(" %s(%.3f)", std::string(name(f.reason)).c_str(), f.value.value_or(0));
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
}

}  // namespace
}  // namespace vantage::testing
