// Scans that are not what they are said to be, added to models of four right ones: what was called good, what became of
// the model. Fifteen bodies made in code before a scanner with a turntable. Arguments: number of bodies (15), first
// seed (1), and "each" to print every scan. Ends with 1 when a scan that is wrong was called good, when more than 1 of
// 100 wrong scans spoiled the model, when a right scan was refused, or when more than 1 of 10 right scans of bodies
// with a unique pose are doubtful.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "acquisition/apply_command.h"
#include "scanner/profile.h"
#include "simulated_bodies.h"

using namespace vantage;

namespace {

enum class Wrong : std::uint8_t {
  Nothing,
  Moved3,
  Moved10,
  Raised5,
  Turned3,
  Turned20,
  NextPosition,
  FifthPosition,
  Elsewhere
};
constexpr int kWrongs = 9;
constexpr std::array<const char*, kWrongs> kNames{"nothing",       "moved by 3 mm",   "moved by 10 mm",
                                                  "raised 5 mm",   "turned by 3 deg", "turned by 20 deg",
                                                  "next position", "fifth position",  "another object"};

constexpr std::array<int, 4> kFirst{0, 10, 20, 30};
constexpr std::array<int, 3> kNew{5, 15, 37};
constexpr double kNoise = 0.05;      // [mm]
constexpr double kFar = 3.0;         // [spacings]
constexpr double kSpoiled = 0.01;    // of the model's surface, more than before
constexpr double kWrongPlace = 1.0;  // [spacings] of a scan's samples from the surface, rms

constexpr const char* kProfile = R"({ "name": "Bench", "scanner": { "type": "rotating_stripe",
  "position": [300, 0, 60], "stripe_height_mm": 140, "samples_per_stripe": 110, "stripes": 100, "sweep_deg": 30,
  "receivers": [[60, 0, 0]], "breakdown_angle_deg": 65, "range_mm": [100, 500] },
  "workspace": { "type": "turntable", "steps": 72 }, "viewing_volume": { "radius_mm": 90, "height_mm": 130 },
  "positional_space": { "surface": "cylinder", "rows": 8, "columns": 72 },
  "mechanics": { "angle_sigma_deg": 0.3, "position_sigma_mm": 0.3 } })";

class Stage {
 public:
  Stage(const std::shared_ptr<const ScannerProfile>& profile, std::uint64_t seed) : profile_(profile), seed_(seed) {
    Random random(seed);
    constexpr std::array<BodyKind, 5> kKinds{BodyKind::Unique, BodyKind::Unique, BodyKind::Unique, BodyKind::Symmetric,
                                             BodyKind::Unique};
    kind = kKinds[seed % kKinds.size()];
    body = bodyOf(kind, random);
    other_ = bodyOf(kind, random);
    state_.profile = profile;
    state_ = applyCommand(state_, ChangeSettings{}, input(), {});
    for (const int position : kFirst) add(state_, scanFrom(position, position, Pose::Identity(), body));
    spoiled_ = farShare(state_);
  }

  BodyKind kind = BodyKind::Unique;
  Body body;

  struct Outcome {
    Verdict verdict = Verdict::Failed;
    bool in = false;
    double off = 0.0;  // of the scan's samples from the surface, rms [spacings]
    double spoiled = 0.0;
    std::string reason;
  };

  [[nodiscard]] Outcome tryOut(Wrong wrong, int position) {
    const auto positions = static_cast<int>(profile_->workspace.size());
    int from = position;
    if (wrong == Wrong::NextPosition) from = (position + 1) % positions;
    if (wrong == Wrong::FifthPosition) from = (position + 5) % positions;
    const Body& seen = wrong == Wrong::Elsewhere ? other_ : body;
    AcquisitionState after = state_;
    const std::shared_ptr<const RangeImage> image = scanFrom(position, from, displacement(wrong), seen);
    add(after, image);
    const KeptScan& scan = after.scans.back();
    Outcome outcome;
    outcome.in = scan.status == ScanStatus::In;
    outcome.verdict = outcome.in ? scan.record.registration.verdict : Verdict::Failed;
    outcome.reason = name(scan.record.registration.finding.reason);
    if (outcome.in) outcome.off = distanceOf(*image, scan.view.T_object_scanner);
    outcome.spoiled = farShare(after) - spoiled_;
    return outcome;
  }

 private:
  [[nodiscard]] CommandInput input() const {
    return {[this](std::int64_t number) { return scans_[static_cast<std::size_t>(number)]; }, nullptr};
  }

  // How the object was displaced on the table.
  static Pose displacement(Wrong wrong) {
    Pose pose = Pose::Identity();
    const Vec3 aside(0.8, 0.6, 0.0);
    if (wrong == Wrong::Moved3) pose.translation() = 3.0 * aside;
    if (wrong == Wrong::Moved10) pose.translation() = 10.0 * aside;
    if (wrong == Wrong::Raised5) pose.translation() = Vec3(0, 0, 5);
    if (wrong == Wrong::Turned3) pose.rotate(Eigen::AngleAxisd(radians(3.0), Vec3::UnitZ()));
    if (wrong == Wrong::Turned20) pose.rotate(Eigen::AngleAxisd(radians(20.0), Vec3::UnitZ()));
    return pose;
  }

  [[nodiscard]] std::shared_ptr<const RangeImage> scanFrom(int said, int from, const Pose& displaced,
                                                           const Body& seen) const {
    const Pose& T_table_scanner = profile_->workspace.poses[static_cast<std::size_t>(from)];
    RangeImage image = scanned(seen, displaced.inverse() * T_table_scanner, profile_->rays, profile_->maxRange, 1.3,
                               kNoise, seed_ * 1000 + scans_.size());
    image.station.position = said;
    image.poseKnownBy = PoseSource::Commanded;
    image.T_table_scanner = profile_->workspace.poses[static_cast<std::size_t>(said)];
    return std::make_shared<const RangeImage>(std::move(image));
  }

  void add(AcquisitionState& state, const std::shared_ptr<const RangeImage>& image) {
    scans_.push_back(image);
    state = applyCommand(state, AddScan{static_cast<std::int64_t>(scans_.size() - 1), {}}, input(), {});
    if (spacing_ == 0.0 && state.scans.back().view.mesh) spacing_ = state.scans.back().view.mesh->spacing;
  }

  [[nodiscard]] double farShare(const AcquisitionState& state) const {
    const auto& vertices = state.model->mesh.vertices;
    const auto far = std::count_if(vertices.begin(), vertices.end(),
                                   [&](const Vec3& v) { return std::abs(body(v)) > kFar * spacing_; });
    return static_cast<double>(far) / static_cast<double>(std::max<std::size_t>(vertices.size(), 1));
  }

  [[nodiscard]] double distanceOf(const RangeImage& image, const Pose& T_object_scanner) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.range.size(); ++i) {
      if (!image.valid(i)) continue;
      const double distance = body(T_object_scanner * image.point(i));
      sum += distance * distance;
      ++count;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1))) / spacing_;
  }

  std::shared_ptr<const ScannerProfile> profile_;
  std::uint64_t seed_;
  Body other_;
  AcquisitionState state_;
  std::vector<std::shared_ptr<const RangeImage>> scans_;
  double spacing_ = 0.0;
  double spoiled_ = 0.0;
};

struct Row {
  int scans = 0;
  int good = 0;
  int doubtful = 0;
  int rejected = 0;
  int wrongPlace = 0;
  int goodAndWrong = 0;
  int spoiled = 0;
};

void add(const Stage::Outcome& outcome, Row& row) {
  const bool wrong = outcome.in && outcome.off > kWrongPlace;
  const bool good = outcome.in && outcome.verdict == Verdict::Good;
  ++row.scans;
  row.good += good ? 1 : 0;
  row.doubtful += outcome.in && !good ? 1 : 0;
  row.rejected += outcome.in ? 0 : 1;
  row.wrongPlace += wrong ? 1 : 0;
  row.goodAndWrong += good && wrong ? 1 : 0;
  row.spoiled += outcome.spoiled > kSpoiled ? 1 : 0;
}

void print(const char* title, const Row& row) {
  std::printf("%-18s %6d %6d %9d %9d %12d %15d %8d\n", title, row.scans, row.good, row.doubtful, row.rejected,
              row.wrongPlace, row.goodAndWrong, row.spoiled);
}

}  // namespace

int main(int argc, char** argv) {
  const int bodies = argc > 1 ? std::atoi(argv[1]) : 15;
  const int first = argc > 2 ? std::atoi(argv[2]) : 1;
  const bool each = argc > 3 && std::strcmp(argv[3], "each") == 0;
  const auto profile = std::make_shared<const ScannerProfile>(parseProfile({"bench.json", kProfile, {}}));
  std::array<Row, kWrongs> rows;
  Row wrong;
  Row unique;  // right scans of bodies that have one pose only
  for (int k = 0; k < bodies; ++k) {
    Stage stage(profile, static_cast<std::uint64_t>(first + k));
    for (int w = 0; w < kWrongs; ++w) {
      for (const int position : kNew) {
        const Stage::Outcome outcome = stage.tryOut(static_cast<Wrong>(w), position);
        add(outcome, rows[static_cast<std::size_t>(w)]);
        if (w != 0) add(outcome, wrong);
        if (w == 0 && stage.kind == BodyKind::Unique) add(outcome, unique);
        if (each)
          std::printf("%3d %-13s %-17s at %2d: %s, %.2f spacings off, %.2f %% more of the model far, %s\n", first + k,
                      name(stage.kind), kNames[static_cast<std::size_t>(w)], position,
                      outcome.in ? (outcome.verdict == Verdict::Good ? "good" : "doubtful") : "rejected", outcome.off,
                      100.0 * outcome.spoiled, outcome.reason.c_str());
      }
    }
    std::fflush(stdout);
  }
  std::printf("%-18s %6s %6s %9s %9s %12s %15s %8s\n", "what is wrong", "scans", "good", "doubtful", "rejected",
              "wrong place", "good and wrong", "spoiled");
  for (int w = 0; w < kWrongs; ++w) print(kNames[static_cast<std::size_t>(w)], rows[static_cast<std::size_t>(w)]);
  print("all wrong ones", wrong);
  print("right, unique", unique);
  const bool fine = wrong.goodAndWrong + rows[0].goodAndWrong == 0 && wrong.spoiled * 100 <= wrong.scans &&
                    rows[0].rejected == 0 && unique.doubtful * 10 <= unique.scans;
  return fine ? 0 : 1;
}
