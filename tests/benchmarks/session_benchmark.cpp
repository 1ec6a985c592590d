#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "acquisition/acquisition.h"
#include "core/session/large_session.h"
#include "io/mesh_reader.h"
#include "positional_space/scanner_images_cache.h"
#include "session/session.h"
#include "support/scenes/journal_pen.h"
#include "support/simulation.h"
#include "support/test_data.h"

// What keeping a session costs beside the acquisition that it records, in one run; and how long a session of 120 views
// and 8 million samples takes to open, beside reading its bytes.

namespace vantage {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRuns = 7;

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

// Seconds of one acquisition as vantage-cli does it, and of what its session took of them.
struct Writing {
  double preparing = 0.0;
  double creating = 0.0;
  double keepingScans = 0.0;
  double recording = 0.0;
  double closing = 0.0;
  double all = 0.0;
  std::size_t views = 0;

  [[nodiscard]] double session() const { return creating + keepingScans + recording + closing; }
  [[nodiscard]] double share() const { return session() / (all - session()); }
  [[nodiscard]] double shareOfLoop() const { return session() / (all - preparing - session()); }
};

// A session that is looked at with a clock.
class TimedJournal final : public Journal {
 public:
  TimedJournal(Session& session, Writing& times) : session_(session), times_(times) {}

  [[nodiscard]] const History& history() const override { return session_.history(); }
  [[nodiscard]] std::shared_ptr<const AcquisitionState> state() const override { return session_.state(); }
  [[nodiscard]] std::int64_t scanCount() const override { return session_.scanCount(); }
  [[nodiscard]] std::shared_ptr<const RangeImage> scan(std::int64_t number) const override {
    return session_.scan(number);
  }
  [[nodiscard]] std::optional<NumberedScan> unusedScan() const override { return session_.unusedScan(); }
  [[nodiscard]] std::optional<Station> lastStation() const override { return session_.lastStation(); }
  NumberedScan keepScan(RangeImage image) override {
    return timed(times_.keepingScans, [&] { return session_.keepScan(std::move(image)); });
  }

 private:
  void record(const Command& command, AcquisitionState state) override {
    timed(times_.recording, [&] { testing::JournalPen::record(session_, command, std::move(state)); });
  }
  void undo() override {}
  void redo() override {}

  Session& session_;
  Writing& times_;
};

Writing acquireOnce(const std::string& folder) {
  const std::string resources = (testing::sourceFolder() / "resources").string();
  Writing t;
  const Progress progress = Progress().withThreads(2);
  const auto begin = Clock::now();
  const ProfileSource source = readProfileSource(resources + "/scanners/rotating_stripe.json");
  const auto profile = std::make_shared<const ScannerProfile>(parseProfile(source));
  const Mesh object = loadMesh(resources + "/objects/mug.ply").mesh;
  const auto images = std::make_shared<const ScannerImages>(loadScannerImages(*profile, folder, progress));
  t.preparing = secondsSince(begin);
  auto session = std::make_unique<Session>(timed(t.creating, [&] {
    return Session::create(folder + "/mug.vantage", {source, {}, &object, profile});
  }));
  const Rig rig = testing::simulation(object, session->profile());
  TimedJournal journal(*session, t);
  Acquisition(journal, {rig, images}).runUntilTheEnd(progress);
  t.views = countScans(*session->state(), ScanStatus::In);
  timed(t.closing, [&] { session.reset(); });
  t.all = secondsSince(begin);
  return t;
}

// The median run of several. The positional space of the scanner is computed by the first and read by the others.
void measureWriting(const std::string& folder) {
  std::vector<Writing> runs;
  runs.reserve(kRuns);
  for (int run = 0; run < kRuns; ++run) runs.push_back(acquireOnce(folder));
  std::sort(runs.begin(), runs.end(), [](const Writing& a, const Writing& b) { return a.share() < b.share(); });
  const Writing& t = runs[runs.size() / 2];
  std::printf(
      "mug, %zu views, median of %d: acquisition %.2f s (%.2f s of it before the first scan), of that the session %.3f "
      "s (new %.3f, scans %.3f, steps %.3f, closing %.3f) = %.2f %% (%.2f to %.2f) of the rest, %.2f %% of the loop "
      "alone; file %.1f MB\n",
      t.views, kRuns, t.all, t.preparing, t.session(), t.creating, t.keepingScans, t.recording, t.closing,
      100.0 * t.share(), 100.0 * runs.front().share(), 100.0 * runs.back().share(), 100.0 * t.shareOfLoop(),
      static_cast<double>(std::filesystem::file_size(folder + "/mug.vantage")) / 1e6);
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
