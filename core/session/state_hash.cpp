#include "session/state_hash.h"

#include <cstring>

namespace vantage {
namespace {

// The finaliser of splitmix64: every bit of the argument reaches every bit of the result.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

void addSettings(ContentHash& hash, const AcquisitionSettings& s) {
  hash.add(s.object);
  hash.add(name(s.placement));
  hash.add(s.seed);
  hash.add(s.ideal);
  hash.add(s.firstView);
  hash.add(s.maxViews);
  hash.add(s.tolerance);
  hash.add(name(s.strategy));
}

void addScore(ContentHash& hash, const PositionScore& score) {
  hash.add(score.position);
  hash.add(score.voidArea);
  hash.add(score.overlapArea);
  hash.add(score.tracedVoidArea.value_or(-1.0));
  hash.add(score.poseSigma.value_or(-1.0));
  hash.add(score.weakDirection);
  hash.add(score.constraint);
  hash.add(score.shortBy);
  hash.add(score.patches);
}

void addPlan(ContentHash& hash, const Plan& plan) {
  hash.add(plan.outcome);
  hash.add(plan.position);
  hash.add(plan.leastOverlap);
  hash.add(plan.terminationThreshold);
  hash.add(plan.voidLeft);
  hash.add(plan.relaxations);
  hash.add(plan.angularError);
  for (const PositionScore& score : plan.scores) addScore(hash, score);
}

void addPatches(ContentHash& hash, const Plan& plan) {
  if (plan.voids) {
    for (const VoidPatch& p : plan.voids->patches) {
      hash.add(p.triangle);
      hash.add(std::as_bytes(std::span(p.centre.data(), 3)));
      hash.add(p.angle);
      hash.add(p.weight);
      hash.add(p.edgeClass);
    }
  }
  for (const PatchOutlook& o : plan.outlook) {
    hash.add(o.looks);
    hash.add(o.answered);
    hash.add(o.reason);
    hash.add(o.promise);
  }
}

void addRegistration(ContentHash& hash, const RegistrationResult& r) {
  hash.add(r.T_object_scanner);
  hash.add(r.verdict);
  hash.add(r.reason);
  hash.add(r.rms);
  hash.add(r.inlierShare);
  hash.add(static_cast<std::uint64_t>(r.pairs));
  hash.add(r.iterations);
}

void addImage(ContentHash& hash, const RangeImage& image) {
  hash.add(image.position);
  hash.add(image.T_object_scanner);
  hash.add(image.range);
}

void addView(ContentHash& hash, const View& view, const ViewRecord& record) {
  hash.add(record.scan);
  hash.add(view.T_object_scanner);
  if (view.image) addImage(hash, *view.image);
  addRegistration(hash, record.registration);
  hash.add(record.newArea);
  hash.add(record.overlapArea);
  hash.add(record.predicted.has_value());
  if (record.predicted) addScore(hash, *record.predicted);
  hash.add(record.plan != nullptr);
  if (record.plan) addPlan(hash, *record.plan);
}

void addModel(ContentHash& hash, const Model& model) {
  hash.add(contentHash(model.mesh));
  hash.add(model.confidence);
  hash.add(model.vertexView);
  hash.add(model.vertexSample);
  hash.add(model.triangleView);
}

}  // namespace

void ContentHash::add(std::span<const std::byte> bytes) {
  value_ = mixed(value_ ^ bytes.size());
  for (; bytes.size() >= sizeof(std::uint64_t); bytes = bytes.subspan(sizeof(std::uint64_t))) {
    std::uint64_t word;
    std::memcpy(&word, bytes.data(), sizeof word);
    value_ = (value_ ^ word) * 0x9fb21c651e98df25ULL;
    value_ ^= value_ >> 29;
  }
  std::uint64_t rest = 0;
  if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
  value_ = mixed(value_ ^ rest);
}

void ContentHash::add(const Pose& pose) {
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c) add(pose.matrix()(r, c));
}

std::uint64_t ContentHash::value() const {
  return mixed(value_);
}

std::string hashText(std::uint64_t hash) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = kDigits[hash & 15];
  return text;
}

std::uint64_t contentHash(const Mesh& mesh) {
  ContentHash hash;
  for (const Vec3& v : mesh.vertices) hash.add(std::as_bytes(std::span(v.data(), 3)));
  hash.add(mesh.triangles);
  return hash.value();
}

std::uint64_t stateHash(const AcquisitionState& state) {
  ContentHash hash;
  addSettings(hash, state.settings);
  for (std::size_t i = 0; i < state.views.size(); ++i) addView(hash, state.views[i], state.records[i]);
  for (const LeftOutView& v : state.leftOut) addView(hash, v.view, v.record);
  for (const RejectedScan& scan : state.rejected) {
    hash.add(scan.scan);
    if (scan.image) addImage(hash, *scan.image);
    addRegistration(hash, scan.registration);
  }
  if (const auto plan = currentPlan(state)) addPatches(hash, *plan);
  if (state.model) addModel(hash, *state.model);
  hash.add(state.chosenPosition);
  hash.add(state.termination);
  return hash.value();
}

}  // namespace vantage
