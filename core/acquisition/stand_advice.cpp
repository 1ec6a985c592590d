#include "acquisition/stand_advice.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/resting_faces.h"

namespace vantage {
namespace {

// So many patches and positions stand for all.
constexpr std::size_t kMostPatches = 1500;
constexpr std::size_t kMostPositions = 24;
// Sides whose directions are nearer to each other are one.
constexpr double kSameSide = radians(20.0);

// Patches of the void that are looked at, each with what it stands for.
class Patches {
 public:
  explicit Patches(const PlanningScene& scene) : all_(scene.patches()), every_(1 + all_.size() / kMostPatches) {}

  [[nodiscard]] std::size_t count() const { return (all_.size() + every_ - 1) / every_; }
  [[nodiscard]] std::size_t index(std::size_t i) const { return i * every_; }
  [[nodiscard]] const VoidPatch& patch(std::size_t i) const { return all_[index(i)]; }
  [[nodiscard]] double area(std::size_t i) const { return patch(i).weight * static_cast<double>(every_); }
  [[nodiscard]] double area(const std::vector<char>& which) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < which.size(); ++i)
      if (which[i] != 0) sum += area(i);
    return sum;
  }

 private:
  std::span<const VoidPatch> all_;
  std::size_t every_;
};

// Whether the workspace shows a patch while the object stands so, for every one.
std::vector<char> shownIn(const PlanningScene& scene, const Patches& patches, const Pose& T_object_table) {
  const std::vector<Pose>& poses = scene.profile().workspace.poses;
  const std::size_t everyPose = 1 + poses.size() / kMostPositions;
  std::vector<char> shown(patches.count(), 0);
  for (std::size_t i = 0; i < patches.count(); ++i) {
    for (std::size_t p = 0; p < poses.size() && shown[i] == 0; p += everyPose) {
      const VoidPatch& patch = patches.patch(i);
      const Sight sight = scene.sight().look(T_object_table * poses[p], patch.centre, patch.normal);
      if (sight.visibility == Visibility::Seen && scene.history().attracts(patches.index(i), sight.cosine))
        shown[i] = 1;
    }
  }
  return shown;
}

// The sides that the object stood on, and those that it was put on: it may have rolled onto another.
std::vector<Vec3> sidesBefore(const AcquisitionState& state) {
  std::vector<Vec3> sides;
  for (int stand = 0; stand <= state.stand(); ++stand) {
    if (isOfObject(state, stand)) sides.emplace_back(-tableOf(state, stand).linear().col(2));
    if (const auto meant = sideMeant(state, stand)) sides.push_back(*meant);
  }
  return sides;
}

std::vector<RestingFace> facesOf(const Mesh& mesh) {
  try {
    return restingFaces(mesh.vertices);
  } catch (const InvalidInput&) {
    return {};  // a sheet rests on nothing
  }
}

}  // namespace

StandOutlook lookAtStands(const AcquisitionState& state, const Progress& progress) {
  const AcquisitionState object = withObject(state);
  if (!object.model || !object.profile) return {};
  const std::vector<RestingFace> faces = facesOf(object.model->mesh);
  if (faces.empty()) return {};
  PlanInput input = planInputOf(object);
  input.T_object_table = Pose::Identity();
  const PlanningScene scene(input, stepOptionsFor(object).planner, progress.part(0.0, 0.5));
  const Patches patches(scene);
  const std::vector<Vec3> before = sidesBefore(state);
  StandOutlook outlook;
  outlook.left = patches.area(std::vector<char>(patches.count(), 1));
  outlook.sides.resize(faces.size());
  std::vector<std::vector<char>> shown(faces.size());
  parallelChunks(faces.size(), 1, progress.part(0.5, 1.0), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Pose T_object_table = restingPose(faces[i]).inverse();
      shown[i] = shownIn(scene, patches, T_object_table);
      const double gain = patches.area(shown[i]);
      const bool isNew = std::none_of(before.begin(), before.end(), [&](const Vec3& side) {
        return side.dot(faces[i].normal) > std::cos(kSameSide);
      });
      outlook.sides[i] = {faces[i].normal, T_object_table, gain, outlook.left > 0.0 ? gain / outlook.left : 0.0,
                          faces[i].margin, isNew};
    }
  });
  for (std::size_t i = 0; i < patches.count(); ++i)
    if (std::none_of(shown.begin(), shown.end(), [i](const auto& side) { return side[i] != 0; }))
      outlook.hidden += patches.area(i);
  std::stable_sort(outlook.sides.begin(), outlook.sides.end(), [](const StandAdvice& a, const StandAdvice& b) {
    return a.isNew != b.isNew ? a.isNew : a.gain > b.gain;
  });
  return outlook;
}

std::vector<StandAdvice> adviseStands(const AcquisitionState& state, const Progress& progress) {
  return lookAtStands(state, progress).sides;
}

}  // namespace vantage
