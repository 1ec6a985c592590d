// Pairs of stands of objects that are made in code, acquired by the simulated scanner and aligned without a hint: how
// many came out good and right. Arguments: number of objects (14), the first of them (0), turns of a stand (10), and
// "each" to print every pair. Ends with 1 when a wrong pose was called good, when two objects were called one, when a
// symmetric object was called good, or when fewer than 95 of 100 pairs that can be aligned are good and right.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "composites/composite_alignment.h"
#include "simulated_stands.h"

using namespace vantage;

namespace {

constexpr std::size_t kStands = 2;     // per object
constexpr double kLeastOverlap = 0.1;  // of pairs that can be aligned
constexpr double kBent = 0.3;          // composites whose points lie farther off are wrong in themselves, rms [mm]
constexpr double kRightTurn = 0.5;     // [deg]
constexpr double kRightShift = 0.5;    // [mm]

struct Prepared {
  SimulatedStand stand;
  CompositeModel model;
  double offTruth = 0.0;  // rms [mm]
};

struct ObjectStands {
  StandObject object;
  std::vector<Prepared> stands;
};

ObjectStands acquire(int number, int turns) {
  ObjectStands all{standObject(number), {}};
  const RayCaster caster(all.object.mesh);
  for (std::size_t face = 0; face < kStands; ++face) {
    auto stand = simulatedStand(all.object, face, turns, static_cast<std::uint64_t>(100 * number) + face);
    if (!stand) continue;
    CompositeModel model(stand->composite);
    const double off = fittedTo(caster, model, stand->T_table_object.inverse()).rms;
    all.stands.push_back({std::move(*stand), std::move(model), off});
  }
  return all;
}

// Where the best pose puts the second stand against the first, as the true object has it.
struct PoseError {
  double turn = 180.0;  // [deg]
  double shift = 1e3;   // [mm]
  [[nodiscard]] bool right() const { return turn < kRightTurn && shift < kRightShift; }
};

PoseError errorOf(const Mesh& object, const Prepared& a, const Prepared& b, const AlignedPose& pose) {
  const Pose T_object_a = a.stand.T_table_object.inverse();
  const Pose truth = a.stand.T_table_object * b.stand.T_table_object.inverse();
  const PoseDistance rough = distanceOf(pose.T_reference_moved, truth, b.model.centroid());
  if (!pose.refinement || rough.turn > radians(3.0) || rough.shift > 3.0) return {degrees(rough.turn), rough.shift};
  const RayCaster caster(object);
  const CompositeModel reference = a.model.withPoses(pose.refinement->reference);
  const CompositeModel moved = b.model.withPoses(pose.refinement->moved);
  const Pose first = fittedTo(caster, reference, T_object_a).T_object_composite;
  const Pose second = fittedTo(caster, moved, T_object_a).T_object_composite;
  const PoseDistance fine = distanceOf(first, second, moved.centroid());
  return {degrees(fine.turn), fine.shift};
}

struct Row {
  const char* title;
  int pairs = 0;
  int goodAndRight = 0;
  int goodAndWrong = 0;
  int ambiguous = 0;
  int refused = 0;
};

void add(const CompositeAlignment& found, bool right, Row& row) {
  ++row.pairs;
  if (found.verdict() == AlignmentVerdict::Good) ++(right ? row.goodAndRight : row.goodAndWrong);
  if (found.verdict() == AlignmentVerdict::Ambiguous) ++row.ambiguous;
  if (found.verdict() == AlignmentVerdict::Failed) ++row.refused;
}

void print(const Row& row) {
  std::printf("%-34s %6d %11d %11d %10d %8d\n", row.title, row.pairs, row.goodAndRight, row.goodAndWrong, row.ambiguous,
              row.refused);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class Bench {
 public:
  explicit Bench(bool each) : each_(each) {}

  void sameObject(const ObjectStands& all) {
    if (all.stands.size() < kStands) return;
    const Prepared& a = all.stands[0];
    const Prepared& b = all.stands[1];
    const CompositeAlignment found = timed(a, b);
    PoseError error;
    if (!found.poses.empty()) {
      const std::size_t best = found.judgement.choice.empty() ? 0 : found.judgement.choice.front();
      error = errorOf(all.object.mesh, a, b, found.poses[best]);
    }
    Row& row = rowOf(all, a, b);
    add(found, error.right(), row);
    if (found.verdict() == AlignmentVerdict::Good && error.right()) {
      turns_.push_back(error.turn);
      shifts_.push_back(error.shift);
    }
    if (each_) say(all.object.name + " / " + all.object.name, row, found, error);
  }

  void otherObjects(const ObjectStands& one, const ObjectStands& other) {
    if (one.stands.empty() || other.stands.empty() || one.object.name == other.object.name) return;
    const CompositeAlignment found = timed(one.stands.front(), other.stands.back());
    add(found, false, different_);
    if (each_) say(one.object.name + " / " + other.object.name, different_, found, {});
  }

  [[nodiscard]] bool report() const {
    std::printf("%-34s %6s %11s %11s %10s %8s\n", "pairs", "pairs", "good, right", "good, wrong", "ambiguous",
                "refused");
    for (const Row* row : {&alignable_, &little_, &bent_, &symmetric_, &slides_, &different_}) print(*row);
    std::printf("good and right: off by %.3f deg and %.3f mm in the median\n", median(turns_), median(shifts_));
    std::printf("an alignment takes %.1f s in the median, %.1f s at most\n", median(seconds_),
                seconds_.empty() ? 0.0 : *std::max_element(seconds_.begin(), seconds_.end()));
    const int wrong = alignable_.goodAndWrong + little_.goodAndWrong + bent_.goodAndWrong;
    const int pretended = symmetric_.goodAndRight + symmetric_.goodAndWrong + slides_.goodAndRight +
                          slides_.goodAndWrong + different_.goodAndWrong;
    return wrong + pretended == 0 && 100 * alignable_.goodAndRight >= 95 * alignable_.pairs;
  }

 private:
  CompositeAlignment timed(const Prepared& a, const Prepared& b) {
    const auto start = std::chrono::steady_clock::now();
    CompositeAlignment found = alignComposites(a.model, b.model);
    seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return found;
  }

  Row& rowOf(const ObjectStands& all, const Prepared& a, const Prepared& b) {
    if (all.object.symmetry == Symmetry::Slides) return slides_;
    if (all.object.symmetry == Symmetry::Turns) return symmetric_;
    if (a.offTruth > kBent || b.offTruth > kBent) return bent_;
    const Pose truth = a.stand.T_table_object * b.stand.T_table_object.inverse();
    const AlignmentLimits limits = limitsOf(a.model.scale(), b.model.scale());
    return evidenceOf(a.model, b.model, truth, limits).overlap < kLeastOverlap ? little_ : alignable_;
  }

  void say(const std::string& pair, const Row& row, const CompositeAlignment& found, const PoseError& error) const {
    std::printf("%s: %s, %s (%.4f), %s, off by %.3f deg %.3f mm, %.1f s\n", pair.c_str(), row.title,
                name(found.verdict()).data(), found.judgement.value.value_or(0.0), name(found.judgement.reason).data(),
                error.turn, error.shift, seconds_.back());
    for (const AlignedPose& pose : found.poses) {
      if (!pose.refinement) continue;
      const PoseEvidence& e = pose.evidence;
      std::printf("    overlap %.3f rms %.3f conflict %.4f table %.4f missing %.4f information %.5f\n", e.overlap,
                  e.rms, e.conflict, e.table, e.missing, pose.leastInformation);
    }
    std::fflush(stdout);
  }

  bool each_;
  Row alignable_{"can be aligned"};
  Row little_{"less than a tenth in common"};
  Row bent_{"composite wrong in itself"};
  Row symmetric_{"symmetric"};
  Row slides_{"cylinder"};
  Row different_{"different objects"};
  std::vector<double> turns_;
  std::vector<double> shifts_;
  std::vector<double> seconds_;
};

}  // namespace

int main(int argc, char** argv) {
  const int objects = argc > 1 ? std::atoi(argv[1]) : 14;
  const int first = argc > 2 ? std::atoi(argv[2]) : 0;
  const int turns = argc > 3 ? std::atoi(argv[3]) : 10;
  Bench bench(argc > 4 && std::strcmp(argv[4], "each") == 0);
  try {
    std::optional<ObjectStands> last;
    for (int k = 0; k < objects; ++k) {
      ObjectStands now = acquire(first + k, turns);
      bench.sameObject(now);
      if (last) bench.otherObjects(*last, now);
      last.emplace(std::move(now));
    }
  } catch (const Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return bench.report() ? 0 : 1;
}
