// A head of 2448 x 2048 rays about a turntable, scans of which come as files, into a session: work of all threads from
// file to next view, memory, the longest silence and the latest answer to a stop. Arguments: number of views, spacing
// that is worked on ("auto", or mm, 0: all rays), object, folder with files scan_00.ply, scan_01.ply... (none: they are
// simulated), how often the last scan is stopped.

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "io/mesh_reader.h"
#include "io/scan_reader.h"
#include "report/evaluation.h"
#include "scanner/simulated_sensor.h"
#include "session/session.h"

namespace vantage {
namespace {

constexpr const char* kProfile = R"({
  "name": "Large head",
  "scanner": { "type": "pinhole", "position": [400, 0, 50], "look_at": [0, 0, 50], "rows": 2048, "columns": 2448,
    "horizontal_fov_deg": 20, "vertical_fov_deg": 16.7, "receivers": [[150, 0, 0]], "breakdown_angle_deg": 65,
    "range_mm": [200, 900], "noise": { "range_sigma_mm": 0.02, "dropout": 0.002 } },
  "workspace": { "type": "turntable", "steps": 40 },
  "viewing_volume": { "radius_mm": 75, "height_mm": 110 },
  "positional_space": { "surface": "cylinder", "rows": 20, "columns": 80 },
  "mechanics": { "angle_sigma_deg": 0.1, "position_sigma_mm": 0.1 } })";

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Seconds of all threads, so that who else is at work on the machine counts for little.
double secondsOfWork() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// [MB]
double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// The longest time without a report, of the clock and of work.
class Silence {
 public:
  void heard(double fraction, std::string_view step) {
    const std::lock_guard lock(mutex_);
    const double work = secondsOfWork() - work_;
    char part[64];
    std::snprintf(part, sizeof(part), "%.2f ", fraction_);
    works_[part + name_] += work;
    if (work > longest_) {
      longest_ = work;
      wall_ = secondsSince(last_);
      before_ = std::to_string(fraction_) + " " + name_;
      after_ = std::to_string(fraction) + " " + std::string(step);
    }
    if (const double peak = peakMemory(); peak > peak_ + 1.0) {
      peak_ = peak;
      peakIn_ = name_ + " " + std::to_string(fraction_);
    }
    fraction_ = fraction;
    name_ = step;
    last_ = Clock::now();
    work_ = secondsOfWork();
  }
  void print() const {
    std::printf("  longest silence %.2f s of work (%.2f s): %s -> %s\n", longest_, wall_, before_.c_str(),
                after_.c_str());
    std::printf("  work:");
    for (const auto& [part, work] : works_)
      if (work > 0.15) std::printf(" %s %.1f,", part.c_str(), work);
    std::printf("\n  the most memory, %.0f MB, was reached in %s\n", peakMemory(), peakIn_.c_str());
  }

 private:
  std::mutex mutex_;
  Clock::time_point last_ = Clock::now();
  double work_ = secondsOfWork();
  double longest_ = 0.0;
  double wall_ = 0.0;
  double fraction_ = 0.0;
  std::string name_ = "begin";
  std::string before_;
  std::string after_;
  std::map<std::string, double> works_;  // by what is reported
  double peak_ = peakMemory();
  std::string peakIn_ = "an earlier scan";
};

// As a vendor writes a scan: binary PLY with its grid.
void writeScan(const std::string& file, const RangeImage& image) {
  std::ofstream out(file, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nobj_info num_cols " << image.rays->columns() << "\nobj_info num_rows "
      << image.rays->rows() << "\nelement vertex " << image.sampleCount()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement range_grid " << image.range.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    if (!image.valid(i)) continue;
    const Eigen::Vector3f p = image.point(i).cast<float>();
    out.write(reinterpret_cast<const char*>(p.data()), 12);
  }
  std::int32_t vertex = 0;
  for (std::size_t i = 0; i < image.range.size(); ++i) {
    out.put(image.valid(i) ? '\1' : '\0');
    if (!image.valid(i)) continue;
    out.write(reinterpret_cast<const char*>(&vertex), 4);
    ++vertex;
  }
}

struct Arguments {
  int views = 3;
  std::optional<double> spacing;
  std::string object = VANTAGE_RESOURCES "/objects/mug.ply";
  std::string scans;
  int stops = 0;
};

class Head {
 public:
  explicit Head(const Arguments& arguments)
      : arguments_(arguments),
        profile_(std::make_shared<const ScannerProfile>(parseProfile(source_))),
        object_(std::make_shared<const Mesh>(loadMesh(arguments.object, {}, {}).mesh)) {
    std::filesystem::create_directories(folder_);
    std::printf("profile: %.2f s of work, %.0f MB\n", secondsOfWork(), peakMemory());
  }
  ~Head() { std::filesystem::remove_all(folder_); }

  void run() {
    const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile_));
    std::printf("scanner images: %.2f s of work, %.0f MB\n", secondsOfWork(), peakMemory());
    AcquisitionSettings settings;
    settings.thinning.spacing = arguments_.spacing;
    settings.maxViews = arguments_.views + 1;
    const std::string path = (folder_ / "head.vantage").string();
    double most = 0.0;
    {
      Session session = Session::create(path, {source_, settings, nullptr, profile_});
      Acquisition acquisition(session, {{}, images});
      for (int i = 0; i < arguments_.views; ++i) {
        const std::string file = scanFile(i);
        if (i + 1 == arguments_.views) stopAtManyMoments(acquisition, file, i);
        most = std::max(most, add(acquisition, file, i));
      }
      print(*session.state());
    }
    const double begin = secondsOfWork();
    Silence silence;
    const Session again = Session::open(path, SessionAccess::Write, progress(silence));
    std::printf("most work for a scan %.2f s; opened again: %.2f s of work, %.0f MB\n", most, secondsOfWork() - begin,
                peakMemory());
    silence.print();
  }

 private:
  static Progress progress(Silence& silence, std::stop_token stop = {}) {
    return Progress([&silence](double f, std::string_view s) { silence.heard(f, s); }, std::move(stop), 2);
  }

  int position(int i) const { return i * static_cast<int>(profile_->workspace.size()) / arguments_.views; }

  std::string scanFile(int i) const {
    char name[32];
    std::snprintf(name, sizeof(name), "scan_%02d.ply", arguments_.scans.empty() ? i : position(i));
    if (!arguments_.scans.empty()) return arguments_.scans + "/" + name;
    const std::string file = (folder_ / name).string();
    if (!std::filesystem::exists(file))
      writeScan(file, scanFrom(opened(simulatedRig(object_, profile_, {})), position(i), Progress().withThreads(2)));
    return file;
  }

  void addTo(Acquisition& acquisition, const std::string& file, int i, const Progress& progress) const {
    ReadScan scan = readScanAt(file, *profile_, position(i), {}, progress.part(0.0, 0.1, "read scan"));
    acquisition.addScan(std::move(scan.image), progress.part(0.1, 1.0));
  }

  double add(Acquisition& acquisition, const std::string& file, int i) const {
    Silence silence;
    const double work = secondsOfWork();
    const auto begin = Clock::now();
    addTo(acquisition, file, i, progress(silence));
    silence.heard(1.0, "end");
    const double seconds = secondsOfWork() - work;
    const KeptScan& last = acquisition.state()->scans.back();
    std::printf("%d: %.2f s of work, %.2f s, %.0f MB, %zu samples, %s %.4f mm, %zu triangles;", i + 1, seconds,
                secondsSince(begin), peakMemory(), last.record.samples,
                std::string(vantage::name(last.record.registration.verdict)).c_str(), last.record.registration.rms,
                acquisition.state()->model->mesh.triangles.size());
    for (const auto& [phase, s] : last.record.seconds) std::printf(" %s %.2f", name(phase).data(), s);
    std::printf("\n");
    silence.print();
    std::fflush(stdout);
    return seconds;
  }

  // Stops the last scan at moments that are evenly spread over its work.
  void stopAtManyMoments(Acquisition& acquisition, const std::string& file, int i) const {
    double latest = 0.0;
    double latestWork = 0.0;
    std::string where;
    const double all = kGuessedWork;
    for (int k = 0; k < arguments_.stops; ++k) {
      std::stop_source stop;
      std::atomic<bool> done = false;
      Clock::time_point asked = Clock::now();
      double askedWork = 0.0;
      const double moment = secondsOfWork() + all * (k + 0.5) / arguments_.stops;
      std::string step;
      std::mutex mutex;
      const Progress progress(
          [&](double fraction, std::string_view s) {
            const std::lock_guard lock(mutex);
            step = std::to_string(fraction) + " " + std::string(s);
          },
          stop.get_token(), 2);
      std::jthread stopper([&] {
        while (!done && secondsOfWork() < moment) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        asked = Clock::now();
        askedWork = secondsOfWork();
        stop.request_stop();
      });
      try {
        addTo(acquisition, file, i, progress);
        done = true;
        acquisition.undo();
      } catch (const Cancelled&) {
        const double work = secondsOfWork() - askedWork;
        done = true;
        stopper.join();
        std::printf("  stopped after %.2f s of work, answered in %.2f s of work, %.2f s, at %s\n",
                    all * (k + 0.5) / arguments_.stops, work, secondsSince(asked), step.c_str());
        if (work > latestWork) where = step;
        latestWork = std::max(latestWork, work);
        latest = std::max(latest, secondsSince(asked));
      }
    }
    if (arguments_.stops > 0)
      std::printf("latest answer to a stop: %.2f s of work (%s), %.2f s\n", latestWork, where.c_str(), latest);
  }

  void print(const AcquisitionState& state) const {
    const Evaluation evaluation = evaluate(state.model->mesh, *object_, *profile_, {}, Progress().withThreads(2));
    std::printf("%zu views of %zu, model of %zu triangles: covered %.4f, rms %.4f mm\n",
                countScans(state, ScanStatus::In), state.scans.size(), state.model->mesh.triangles.size(),
                evaluation.coverage, evaluation.rms);
  }

  static constexpr double kGuessedWork = 12.0;

  Arguments arguments_;
  ProfileSource source_{"large_head.json", kProfile, {}};
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("large_head_" + std::to_string(getpid()));
  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<const Mesh> object_;
};

}  // namespace
}  // namespace vantage

int main(int argc, char** argv) {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // as the programs do
#endif
  try {
    vantage::Arguments arguments;
    if (argc > 1) arguments.views = std::stoi(argv[1]);
    if (argc > 2 && std::string(argv[2]) != "auto") arguments.spacing = std::stod(argv[2]);
    if (argc > 3) arguments.object = argv[3];
    if (argc > 4) arguments.scans = argv[4];
    if (argc > 5) arguments.stops = std::stoi(argv[5]);
    vantage::Head(arguments).run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
