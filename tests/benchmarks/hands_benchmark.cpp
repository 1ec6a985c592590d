// Acquisitions before a table that a person turns, who errs by some degrees and mm: evenly spaced steps, and as the
// plan asks. How many scans were asked for, what was called good, doubtful, refused, and what is wrong: half a
// millimetre off the object's surface. What slid is as far from where it was taken, be it on the surface. Arguments:
// number of hands each (3), steps ("30,45,60,0" degrees; 0: planned), objects (the sample objects), and "each" to print
// every scan. Ends with 1 when a view was called good that is wrong, or is a millimetre from where it was taken.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "base/random.h"
#include "geometry/ray_caster.h"
#include "io/mesh_reader.h"
#include "report/evaluation.h"
#include "scanner/simulated_sensor.h"

namespace vantage {
namespace {

constexpr const char* kProfile = R"({ "name": "By hand",
  "scanner": { "type": "rotating_stripe", "position": [300, 0, 110], "stripe_height_mm": 220, "samples_per_stripe": 160,
    "stripes": 140, "sweep_deg": 40, "receivers": [[60, 0, 0]], "breakdown_angle_deg": 60, "range_mm": [100, 500],
    "noise": { "range_sigma_mm": 0.1, "dropout": 0.0 } },
  "workspace": { "type": "turntable", "steps": 72 }, "viewing_volume": { "radius_mm": 130, "height_mm": 220 },
  "positional_space": { "surface": "cylinder", "rows": 12, "columns": 72 },
  "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.3 } })";

// As the program counts on a person.
constexpr Mechanics kHand{radians(7.5), 3.0};
constexpr double kFarthest = 2.0;   // [sigmas]
constexpr double kWrong = 0.5;      // of a scan's samples, rms [mm]
constexpr double kElsewhere = 1.0;  // of a good view's samples from where they are, rms [mm]
constexpr double kFarOff = 20.0;    // nothing is looked for farther from the surface [mm]
constexpr std::uint64_t kHandStream = 0x68616e64ULL << 24;

std::shared_ptr<const ScannerProfile> benchProfile() {
  return std::make_shared<const ScannerProfile>(parseProfile({"hands.json", kProfile, {}}));
}

// Sensor and table in one: what the person does to the table, and the scanner that looks at it.
class Hand final : public Positioner, public RangeSensor {
 public:
  Hand(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile, std::uint64_t seed)
      : object_(std::move(object)), profile_(std::move(profile)), seed_(seed) {}

  [[nodiscard]] std::string identity() const override { return "hand"; }
  void open(const Progress& /*progress*/) override {}
  void close() noexcept override {}
  [[nodiscard]] std::optional<std::string> notReady() const override { return {}; }
  [[nodiscard]] std::optional<ReachedPose> where() const override { return where_; }

  [[nodiscard]] ReachedPose moveTo(int position, const Progress& /*progress*/) override {
    const Pose& said = profile_->workspace.poses[static_cast<std::size_t>(position)];
    Random random(seed_, kHandStream + truths.size());
    const auto error = [&] { return std::clamp(random.normal(), -kFarthest, kFarthest); };
    const double angle = kHand.angleSigma * error();
    const double x = kHand.positionSigma * error();
    const double y = kHand.positionSigma * error();
    truths.push_back(Eigen::Translation3d(x, y, 0.0) * (Eigen::AngleAxisd(angle, Vec3::UnitZ()) * said));
    where_ = ReachedPose{position, said, PoseSource::ByHand, kHand};
    return *where_;
  }

  [[nodiscard]] RangeImage capture(const Progress& progress) override {
    auto there = std::make_shared<ScannerProfile>(*profile_);
    there->workspace.poses = {truths.back()};
    there->mechanics = {0.0, 0.0};
    const Rig rig = opened(simulatedRig(object_, there, {seed_, false}, static_cast<int>(truths.size()) - 1));
    RangeImage image = scanFrom(rig, 0, progress);
    image.rays = profile_->rays;
    return image;
  }

  std::vector<Pose> truths;  ///< T_table_scanner of every scan

 private:
  std::shared_ptr<const Mesh> object_;
  std::shared_ptr<const ScannerProfile> profile_;
  std::uint64_t seed_;
  std::optional<ReachedPose> where_;
};

struct Row {
  int asked = 0;
  int good = 0;
  int doubtful = 0;
  int refused = 0;
  int wrong = 0;
  int slid = 0;
  int goodAndWrong = 0;
  double coverage = 0.0;
  double falseSurface = 0.0;
  std::map<std::string, int> ends;

  Row& operator+=(const Row& other) {
    asked += other.asked;
    good += other.good;
    doubtful += other.doubtful;
    refused += other.refused;
    wrong += other.wrong;
    slid += other.slid;
    goodAndWrong += other.goodAndWrong;
    coverage += other.coverage;
    falseSurface += other.falseSurface;
    for (const auto& [end, count] : other.ends) ends[end] += count;
    return *this;
  }
};

// How far a scan's samples are from where they were taken, rms [mm].
double distanceOff(const KeptScan& scan, const Pose& found, const Pose& truth) {
  const RangeImage& image = *scan.view.image;
  double sum = 0.0;
  for (std::size_t i = 0; i < image.range.size(); ++i)
    if (image.valid(i)) sum += (found * image.point(i) - truth * image.point(i)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(image.sampleCount(), 1)));
}

// Where the table is as the good views have it together, in the least squares of their samples: the frame is theirs,
// whichever view was the first.
Pose frameOf(const AcquisitionState& state, const std::vector<Pose>& truths) {
  constexpr std::size_t kEvery = 40;
  std::vector<Vec3> where;
  std::vector<Vec3> found;
  for (std::size_t k = 0; k < state.scans.size(); ++k) {
    const KeptScan& scan = state.scans[k];
    if (scan.status != ScanStatus::In || scan.record.registration.verdict != Verdict::Good) continue;
    const RangeImage& image = *scan.view.image;
    for (std::size_t i = 0; i < image.range.size(); i += kEvery) {
      if (!image.valid(i)) continue;
      where.push_back(truths[k] * image.point(i));
      found.push_back(scan.view.T_object_scanner * image.point(i));
    }
  }
  if (where.size() < 3) return state.scans.front().view.T_object_scanner * truths.front().inverse();
  const auto columns = [](const std::vector<Vec3>& points) {
    return Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, static_cast<Eigen::Index>(points.size()));
  };
  return Pose(Eigen::umeyama(columns(where), columns(found), false));
}

struct Off {
  double place = 0.0;    // from where it was taken, rms [mm]
  double atFirst = 0.0;  // the same, as it was registered
  double surface = 0.0;  // from the object's surface, rms [mm]
};

// Of a scan that was refused: only where it was registered.
Off whereRefused(const KeptScan& scan, const Pose& truth) {
  return {0.0, distanceOff(scan, scan.record.registration.T_object_scanner, truth), 0.0};
}

void printScan(const KeptScan& scan, const Off& off, double turnOff) {
  const RegistrationResult& found = scan.record.registration;
  std::printf("    scan %2d at %2d: %s %s %s", static_cast<int>(scan.number), *scan.station().position,
              std::string(name(scan.status)).c_str(), std::string(name(found.verdict)).c_str(),
              std::string(name(found.finding.reason)).c_str());
  if (found.finding.value) std::printf(" %.3f", *found.finding.value);
  std::printf(
      "; %zu pairs, sigma %.2f mm; turned %.1f deg from said, %.2f mm off (%.2f at first), %.2f off the surface\n",
      found.pairs, found.poseSigma, turnOff, off.place, off.atFirst, off.surface);
}

class Run {
 public:
  Run(std::shared_ptr<const Mesh> object, std::shared_ptr<const ScannerProfile> profile,
      std::shared_ptr<const ScannerImages> images)
      : object_(std::move(object)), profile_(std::move(profile)), images_(std::move(images)) {}

  [[nodiscard]] Row tryOut(int step, std::uint64_t seed, bool each) const {
    AcquisitionSettings settings;
    settings.maxViews = kMostScans;
    if (step > 0) {
      settings.strategy.kind = Strategy::Kind::Uniform;
      settings.strategy.uniformViews = 360 / step;
    }
    const auto hand = std::make_shared<Hand>(object_, profile_, seed);
    MemoryJournal journal(profile_, settings);
    Acquisition acquisition(journal, {Rig{hand, hand}, images_});
    const auto tooMany = [&] { return hand->truths.size() >= static_cast<std::size_t>(kMostScans); };
    acquisition.runUntilTheEnd(Progress().withThreads(2), tooMany);
    return judged(*journal.state(), hand->truths, each);
  }

 private:
  [[nodiscard]] Row judged(const AcquisitionState& state, const std::vector<Pose>& truths, bool each) const {
    Row row;
    row.ends[std::string(name(state.termination))] = 1;
    row.asked = static_cast<int>(state.scans.size());
    const Pose T_object_table = frameOf(state, truths);
    for (std::size_t i = 0; i < state.scans.size(); ++i) {
      const KeptScan& scan = state.scans[i];
      const bool in = scan.status == ScanStatus::In;
      const bool good = scan.record.registration.verdict == Verdict::Good;
      const Off off = in ? offOf(scan, T_object_table, truths[i]) : whereRefused(scan, T_object_table * truths[i]);
      (in ? good ? row.good : row.doubtful : row.refused) += 1;
      if (off.place > kWrong) (off.surface > kWrong ? row.wrong : row.slid) += 1;
      if (good && (off.surface > kWrong || off.place > kElsewhere)) ++row.goodAndWrong;
      const Pose moved = truths[i] * scan.view.image->T_table_scanner.inverse();
      if (each) printScan(scan, off, degrees(std::atan2(moved.linear()(1, 0), moved.linear()(0, 0))));
    }
    const Mesh model = transformed(state.model->mesh, T_object_table.inverse());
    const Evaluation evaluation = evaluate(model, *object_, *profile_, {10000}, Progress().withThreads(2));
    row.coverage = evaluation.coverage;
    row.falseSurface = evaluation.falseSurface;
    return row;
  }

  [[nodiscard]] Off offOf(const KeptScan& scan, const Pose& T_object_table, const Pose& truth) const {
    const Pose& found = scan.view.T_object_scanner;
    const RangeImage& image = *scan.view.image;
    double sum = 0.0;
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      if (!image.valid(i)) continue;
      const auto near = surface_.closestPoint(T_object_table.inverse() * (found * image.point(i)), kFarOff);
      const double distance = near ? near->distance : kFarOff;
      sum += distance * distance;
    }
    return {distanceOff(scan, found, T_object_table * truth),
            distanceOff(scan, scan.record.registration.T_object_scanner, T_object_table * truth),
            std::sqrt(sum / static_cast<double>(std::max<std::size_t>(image.sampleCount(), 1)))};
  }

  static constexpr int kMostScans = 36;

  std::shared_ptr<const Mesh> object_;
  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<const ScannerImages> images_;
  RayCaster surface_{*object_};
};

void print(const std::string& object, const std::string& step, const Row& row, int runs) {
  std::printf("%-16s %8s %6d %5d %9d %8d %6d %5d %12d %8.4f %7.4f ", object.c_str(), step.c_str(), row.asked, row.good,
              row.doubtful, row.refused, row.wrong, row.slid, row.goodAndWrong, row.coverage / runs,
              row.falseSurface / runs);
  for (const auto& [end, count] : row.ends) std::printf(" %s: %d", end.c_str(), count);
  std::printf("\n");
  std::fflush(stdout);
}

struct Arguments {
  int hands = 3;
  std::vector<int> steps{30, 45, 60, 0};
  std::vector<std::string> objects;
  bool each = false;
};

Arguments argumentsOf(int argc, char** argv) {
  Arguments arguments;
  if (argc > 1) arguments.hands = std::stoi(argv[1]);
  if (argc > 2) {
    arguments.steps.clear();
    std::stringstream list(argv[2]);
    for (std::string step; std::getline(list, step, ',');) arguments.steps.push_back(std::stoi(step));
  }
  for (int i = 3; i < argc; ++i) {
    if (std::string(argv[i]) == "each")
      arguments.each = true;
    else
      arguments.objects.emplace_back(argv[i]);
  }
  if (arguments.objects.empty())
    for (const char* object : {"handset", "mug", "candle_holder"})
      arguments.objects.push_back(std::string(VANTAGE_RESOURCES "/objects/") + object + ".ply");
  return arguments;
}

// @return how many views were called good that are not
int run(const Arguments& arguments) {
  const auto profile = benchProfile();
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
  std::printf("%-16s %8s %6s %5s %9s %8s %6s %5s %12s %8s %7s  %s\n", "object", "step", "asked", "good", "doubtful",
              "refused", "wrong", "slid", "good, wrong", "covered", "false", "ends");
  int wrong = 0;
  for (const std::string& object : arguments.objects) {
    const Run run(std::make_shared<const Mesh>(loadMesh(object, {}, {}).mesh), profile, images);
    const std::string title = std::filesystem::path(object).stem().string();
    for (const int step : arguments.steps) {
      const std::string stepTitle = step > 0 ? std::to_string(step) : "planned";
      Row all;
      for (int seed = 1; seed <= arguments.hands; ++seed) {
        const Row row = run.tryOut(step, static_cast<std::uint64_t>(seed), arguments.each);
        if (arguments.each) print(title, stepTitle, row, 1);
        all += row;
      }
      print(title, stepTitle, all, arguments.hands);
      wrong += all.goodAndWrong;
    }
  }
  return wrong;
}

}  // namespace
}  // namespace vantage

int main(int argc, char** argv) {
  try {
    return vantage::run(vantage::argumentsOf(argc, argv)) == 0 ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
