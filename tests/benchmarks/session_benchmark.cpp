#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "acquisition/automatic_run.h"
#include "acquisition/session.h"
#include "core/acquisition/large_session.h"
#include "io/mesh_reader.h"
#include "scanner/simulated_scanner.h"
#include "support/test_data.h"

// What keeping a session costs beside the acquisition that it records, in one run; and how long a session of 120 views
// and 8 million samples takes to open, beside reading its bytes.

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Seconds that `work` takes are added to `sum`.
template <typename Work>
auto timed(double& sum, const Work& work) {
  struct Adder {
    double& sum;
    Clock::time_point begin = Clock::now();
    ~Adder() { sum += secondsSince(begin); }
  } adder{sum};
  return work();
}

void measureWriting(const std::string& folder) {
  const std::string resources = (testing::sourceFolder() / "resources").string();
  const ProfileSource source = readProfileSource(resources + "/scanners/rotating_stripe.json");
  const Mesh object = loadMesh(resources + "/objects/mug.ply").mesh;
  const Progress progress = Progress().withThreads(2);
  const ScannerImages images = computeScannerImages(parseProfile(source), progress);

  double creating = 0.0;
  double keepingScans = 0.0;
  double recording = 0.0;
  const auto begin = Clock::now();
  Session session = timed(creating, [&] { return Session::create(folder + "/mug.vantage", {source, {}, &object}); });
  SimulatedScanner scanner(object, session.profile(), {});
  const ScanSource scans = [&](int position, const Progress& scanning) {
    const RangeImage image = scanner.scan(position, scanning);
    return timed(keepingScans, [&] {
      const std::int64_t number = session.keepScan(image);
      return NumberedScan{number, session.scan(number)};
    });
  };
  const StepObserver observer = [&](const Command& command, const AcquisitionState& state) {
    timed(recording, [&] { session.record(command, state); });
  };
  const AcquisitionState end = acquire(*session.state(), scans, images, observer, progress);
  const double all = secondsSince(begin);
  const double writing = creating + keepingScans + recording;
  std::printf(
      "mug, %zu views: acquisition %.2f s, of that the session %.3f s (new %.3f, scans %.3f, steps %.3f) = %.2f %%, "
      "file %.1f MB\n",
      end.views.size(), all, writing, creating, keepingScans, recording, 100.0 * writing / (all - writing),
      static_cast<double>(std::filesystem::file_size(session.path())) / 1e6);
}

double secondsToRead(const std::string& path) {
  const auto begin = Clock::now();
  std::ifstream in(path, std::ios::binary);
  std::vector<char> bytes(std::filesystem::file_size(path));
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return secondsSince(begin);
}

void measureOpening(const std::string& folder) {
  const std::string path = folder + "/large.vantage";
  testing::writeLargeSession(path, 120);
  const double reading = secondsToRead(path);
  auto begin = Clock::now();
  const Session session = Session::open(path, SessionAccess::Read);
  const double opening = secondsSince(begin);
  begin = Clock::now();
  static_cast<void>(session.model(session.history().cursor()));
  const double model = secondsSince(begin);
  begin = Clock::now();
  static_cast<void>(session.scan(60));
  const double scan = secondsSince(begin);
  std::printf(
      "120 views of 67600 samples: open %.3f s = %.1f times reading its %.1f MB, model %.3f s, one scan %.3f s\n",
      opening, opening / reading, static_cast<double>(std::filesystem::file_size(path)) / 1e6, model, scan);
}

}  // namespace
}  // namespace vantage

int main() {
  const vantage::testing::TemporaryFolder folder;
  const std::string path = std::filesystem::path(folder.file("x")).parent_path().string();
  vantage::measureWriting(path);
  vantage::measureOpening(path);
  return 0;
}
