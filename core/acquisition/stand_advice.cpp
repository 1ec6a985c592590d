#include "acquisition/stand_advice.h"

#include <algorithm>
#include <cmath>

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

// What the workspace shows of the void while the object stands so, and of how much there is in all [mm^2].
struct Shown {
  double area = 0.0;
  double all = 0.0;
};

Shown shownIn(const PlanningScene& scene, const Pose& T_object_table) {
  const std::span<const VoidPatch> patches = scene.patches();
  const std::vector<Pose>& poses = scene.profile().workspace.poses;
  const std::size_t everyPatch = 1 + patches.size() / kMostPatches;
  const std::size_t everyPose = 1 + poses.size() / kMostPositions;
  Shown shown;
  for (std::size_t i = 0; i < patches.size(); i += everyPatch) {
    const double weight = patches[i].weight * static_cast<double>(everyPatch);
    shown.all += weight;
    for (std::size_t p = 0; p < poses.size(); p += everyPose) {
      const Sight sight = scene.sight().look(T_object_table * poses[p], patches[i].centre, patches[i].normal);
      if (sight.visibility != Visibility::Seen || !scene.history().attracts(i, sight.cosine)) continue;
      shown.area += weight;
      break;
    }
  }
  return shown;
}

// The sides that the object stood on, and those that it was put on: it may have rolled onto another.
std::vector<Vec3> sidesBefore(const AcquisitionState& state) {
  std::vector<Vec3> sides;
  for (const Stand& stand : state.stands) {
    if (stand.T_object_table) sides.emplace_back(-stand.T_object_table->linear().col(2));
    if (stand.down) sides.push_back(*stand.down);
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

std::vector<StandAdvice> adviseStands(const AcquisitionState& state, const Progress& progress) {
  const AcquisitionState object = withObject(state);
  if (!object.model || !object.profile) return {};
  const std::vector<RestingFace> faces = facesOf(object.model->mesh);
  if (faces.empty()) return {};
  PlanInput input = planInputOf(object);
  input.T_object_table = Pose::Identity();
  const PlanningScene scene(input, stepOptionsFor(object).planner, progress.part(0.0, 0.5));
  const std::vector<Vec3> before = sidesBefore(state);
  std::vector<StandAdvice> advice(faces.size());
  parallelChunks(faces.size(), 1, progress.part(0.5, 1.0), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Pose T_object_table = restingPose(faces[i]).inverse();
      const Shown shown = shownIn(scene, T_object_table);
      const bool isNew = std::none_of(before.begin(), before.end(), [&](const Vec3& side) {
        return side.dot(faces[i].normal) > std::cos(kSameSide);
      });
      advice[i] = {faces[i].normal, T_object_table, shown.area, shown.all > 0.0 ? shown.area / shown.all : 0.0,
                   faces[i].margin, isNew};
    }
  });
  std::stable_sort(advice.begin(), advice.end(), [](const StandAdvice& a, const StandAdvice& b) {
    return a.isNew != b.isNew ? a.isNew : a.gain > b.gain;
  });
  return advice;
}

}  // namespace vantage
