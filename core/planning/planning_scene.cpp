#include "planning/planning_scene.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/mesh_union.h"
#include "planning/planning_surface.h"
#include "planning/void_extent.h"
#include "void_space/void_patch_builder.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 64;
constexpr double kClearOfBreakdown = radians(2.0);
constexpr double kExpectedMargin = 0.6;  // [sides of a voxel]

double meanSpacing(const std::vector<View>& views) {
  if (views.empty()) throw InvalidInput("planning has 0 views to go on from, expected at least 1");
  double sum = 0.0;
  for (const View& view : views) sum += view.mesh->spacing;
  return sum / static_cast<double>(views.size());
}

std::shared_ptr<const VoidSurface> findVoid(const PlanInput& input, const PlannerOptions& options,
                                            const Progress& progress) {
  const double spacing = meanSpacing(input.views);
  VoidOptions voidOptions = options.voidSpace;
  voidOptions.breakdownAngle = input.profile->breakdownAngle;
  VoidSurface surface = buildVoidPatches(*input.model, input.views, voidOptions, progress);
  if (options.lookAhead) {
    const auto extents = voidExtents(
        surface.patches, {options.lookAheadReach * spacing, options.widestHole * spacing, options.facingAngle});
    for (std::size_t p = 0; p < extents.size(); ++p) surface.patches[p].weight *= extents[p];
  }
  return std::make_shared<const VoidSurface>(std::move(surface));
}

// Nothing when the object stands on the table as its frame does: then nothing is moved, to the last bit.
std::optional<Pose> tableFrame(const Pose& T_object_table) {
  if (T_object_table.matrix() == Pose::Identity().matrix()) return std::nullopt;
  return T_object_table.inverse();
}

std::optional<std::vector<VoidPatch>> moved(const std::vector<VoidPatch>& patches,
                                            const std::optional<Pose>& T_table_object) {
  if (!T_table_object) return std::nullopt;
  std::vector<VoidPatch> result = patches;
  for (VoidPatch& patch : result) {
    patch.centre = *T_table_object * patch.centre;
    patch.normal = T_table_object->linear() * patch.normal;
    for (Vec3& corner : patch.corners) corner = *T_table_object * corner;
  }
  return result;
}

std::vector<View> moved(std::vector<View> views, const std::optional<Pose>& T_table_object) {
  if (T_table_object)
    for (View& view : views) view.T_object_scanner = *T_table_object * view.T_object_scanner;
  return views;
}

Mesh surfaceOf(const PlanInput& input, const PlannerOptions& options, const std::optional<Pose>& T_table_object,
               const Progress& progress) {
  Mesh mesh = tracedMesh(input.model->mesh, options.tracedTriangles, options.planningError, progress);
  return T_table_object ? transformed(mesh, *T_table_object) : mesh;
}

// Of every patch whether what lies beyond it was erased; nothing where none is.
std::vector<std::uint8_t> erasedPatches(const std::vector<VoidPatch>& patches, const ErasedInStand& erased) {
  std::vector<std::uint8_t> marks;
  if (erased.border.empty()) return marks;
  for (const VoidPatch& patch : patches)
    marks.push_back(erased.border.at(patch.from) != 0 && erased.border.at(patch.to) != 0 ? 1 : 0);
  return marks;
}

Mesh erasedSurfaceOf(const PlanInput& input, const std::optional<Pose>& T_table_object) {
  if (!input.erased.surface) return {};
  return T_table_object ? transformed(*input.erased.surface, *T_table_object) : *input.erased.surface;
}

RayCaster obstaclesOf(const Mesh& surface, const Mesh& beside) {
  return beside.empty() ? RayCaster(surface) : RayCaster(together(std::array<const Mesh*, 2>{&surface, &beside}));
}

// What was erased goes on for long, as a table does: what lies about the model is what bounds the unseen.
constexpr double kAboutModel = 10.0;  // [spacings]

Mesh aboutModel(const Mesh& beside, const Mesh& surface, double spacing) {
  const BoundingBox box = boundingBox(surface);
  const Vec3 about = Vec3::Constant(kAboutModel * spacing);
  const Vec3 low = box.min - about;
  const Vec3 high = box.max + about;
  Mesh near;
  near.vertices = beside.vertices;
  for (const Triangle& t : beside.triangles)
    if (const Vec3 c = triangleCentre(beside, t); (c.array() >= low.array()).all() && (c.array() <= high.array()).all())
      near.triangles.push_back(t);
  removeUnusedVertices(near);
  return near;
}

// What is expected where the operator erased something is more of that.
void dropErased(ClosingSurface& closing, const PlanInput& input) {
  const ErasedInStand& erased = input.erased;
  if (erased.space.empty()) return;
  std::erase_if(closing.faces, [&](const LevelFace& face) {
    return erased.space.holds(erased.stand, input.T_object_table * face.centre, closing.side);
  });
}

// Where the prediction is off by a voxel, its own surface is not to hide it, and what is just steep enough is not to
// count.
SightOptions lookingAtExpected(const ScannerProfile& profile, double side) {
  return {std::max(0.0, profile.breakdownAngle - kClearOfBreakdown), kExpectedMargin * side, kExpectedMargin * side};
}

std::vector<double> mostSquarely(const ClosingSurface& closing, const std::vector<View>& views, const SightTest& sight,
                                 const Progress& progress) {
  std::vector<double> seenAt(closing.faces.size(), 0.0);
  parallelChunks(seenAt.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      for (const View& view : views) {
        const Sight s = sight.look(view.T_object_scanner, closing.faces[f].centre, closing.faces[f].normal);
        if (s.visibility == Visibility::Seen) seenAt[f] = std::max(seenAt[f], s.cosine);
      }
  });
  return seenAt;
}

std::unique_ptr<const ExpectedSurface> expectedAbout(const Mesh& model, const Mesh& beside, const RayCaster& obstacles,
                                                     const std::vector<View>& views, const PlanInput& input,
                                                     const PlannerOptions& options, const Progress& progress) {
  if (!options.forecast || model.empty()) return nullptr;
  const double spacing = meanSpacing(input.views);
  const Mesh near = aboutModel(beside, model, spacing);
  const Mesh surface = near.empty() ? model : together(std::array<const Mesh*, 2>{&model, &near});
  ClosingSurface closing = predictClosingSurface(surface, obstacles, views, *input.profile, spacing, options.closing,
                                                 progress.part(0.0, 0.9));
  dropErased(closing, input);
  RayCaster itself(closing.mesh);
  RayCaster all(together(std::array<const Mesh*, 2>{&surface, &closing.mesh}));
  const SightTest sight(*input.profile, obstacles, lookingAtExpected(*input.profile, closing.side), &itself);
  std::vector<double> seenAt = mostSquarely(closing, views, sight, progress.part(0.9, 1.0));
  return std::make_unique<const ExpectedSurface>(ExpectedSurface{std::move(closing), std::move(itself), std::move(all),
                                                                 trustIn(input.ledger, spacing, options.ledger),
                                                                 std::move(seenAt)});
}

}  // namespace

PlanningScene::PlanningScene(const PlanInput& input, const PlannerOptions& options, const Progress& progress)
    : PlanningScene(input, findVoid(input, options, progress.part(0.0, 0.5)), options, progress.part(0.5, 1.0)) {}

PlanningScene::PlanningScene(PlanInput input, std::shared_ptr<const VoidSurface> voids, const PlannerOptions& options,
                             const Progress& progress)
    : input_(std::move(input)),
      options_(options),
      spacing_(meanSpacing(input_.views)),
      T_table_object_(tableFrame(input_.T_object_table)),
      voids_(std::move(voids)),
      turnedPatches_(moved(voids_->patches, T_table_object_)),
      erased_(erasedPatches(voids_->patches, input_.erased)),
      surface_(surfaceOf(input_, options_, T_table_object_, progress.part(0.0, 0.6))),
      beside_(erasedSurfaceOf(input_, T_table_object_)),
      obstacles_(obstaclesOf(surface_, beside_)),
      sight_(*input_.profile, obstacles_,
             {input_.profile->breakdownAngle, options_.surfaceOffset * spacing_, options_.sightMargin * spacing_}),
      history_(patches(), moved(input_.views, T_table_object_), sight_, options_.history, progress.part(0.6, 0.7),
               erased_),
      spread_(input_.profile->workspace, mechanics()),
      expected_(expectedAbout(surface_, beside_, obstacles_, moved(input_.views, T_table_object_), input_, options_,
                              progress.part(0.7, 1.0))) {
  if (expected_)
    sightOfExpected_ = std::make_unique<const SightTest>(
        profile(), obstacles_, lookingAtExpected(profile(), expected_->closing.side), &expected_->obstacles);
}

const Pose& PlanningScene::pose(int position) const {
  const std::vector<Pose>& poses = profile().workspace.poses;
  if (position < 0 || position >= static_cast<int>(poses.size()))
    throw InvalidInput("position " + std::to_string(position) + " is not in the workspace, which has positions 0 to " +
                       std::to_string(static_cast<int>(poses.size()) - 1));
  return poses[static_cast<std::size_t>(position)];
}

bool PlanningScene::taken(int position) const {
  return std::find(input_.taken.begin(), input_.taken.end(), position) != input_.taken.end();
}

Vec3 PlanningScene::pointOnTable(const Vec3& inObject) const {
  return T_table_object_ ? *T_table_object_ * inObject : inObject;
}

Vec3 PlanningScene::directionOnTable(const Vec3& inObject) const {
  return T_table_object_ ? T_table_object_->linear() * inObject : inObject;
}

}  // namespace vantage
