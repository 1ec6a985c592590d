#include "acquisition/erased_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "acquisition/stand_composites.h"
#include "finishing/loose_pieces.h"
#include "geometry/mesh_union.h"

namespace vantage {
namespace {

// What scans that come will show of a piece lies up to so many spacings from what is seen of it now.
constexpr double kAroundPiece = 2.0;
// Nothing nearer to the rest of the model than to the piece may go with it.
constexpr double kShareOfGap = 0.45;
// Neighbours on a surface are no farther apart in depth than so many spacings, but where it is seen edge-on.
constexpr double kDepthGap = 6.0;
// Points of a piece need be no nearer to each other than this share of the radius about them.
constexpr double kThinned = 0.3;

bool severalStands(const std::vector<View>& views) {
  return std::any_of(views.begin(), views.end(),
                     [&](const View& v) { return v.image->station.stand != views.front().image->station.stand; });
}

double meanSpacingOf(const std::vector<View>& views) {
  double sum = 0.0;
  for (const View& view : views) sum += view.mesh->spacing;
  return sum / static_cast<double>(std::max<std::size_t>(views.size(), 1));
}

// Those of the points that are near to one of others.
std::vector<Vec3> nearTo(const std::vector<Vec3>& others, const std::vector<Vec3>& points, double reach) {
  if (others.empty()) return {};
  const RegionProbe around(NearPoints{others, reach});
  std::vector<Vec3> near;
  std::copy_if(points.begin(), points.end(), std::back_inserter(near), [&](const Vec3& p) { return around.holds(p); });
  return near;
}

// How near two clouds of points come to each other, up to `most`.
double leastDistance(const std::vector<Vec3>& from, const std::vector<Vec3>& to, double most) {
  const std::vector<Vec3> nearFrom = nearTo(from, to, most);
  double least = most;
  for (const Vec3& p : nearTo(nearFrom, from, most))
    for (const Vec3& q : nearFrom) least = std::min(least, (p - q).norm());
  return least;
}

// A part of the points such that every other one is nearer than `apart` to one of them.
std::vector<Vec3> thinnedTo(const std::vector<Vec3>& points, double apart) {
  std::set<std::array<std::int64_t, 3>> taken;
  std::vector<Vec3> thinned;
  const double side = apart / std::sqrt(3.0);
  for (const Vec3& p : points) {
    const std::array<std::int64_t, 3> cell{static_cast<std::int64_t>(std::floor(p.x() / side)),
                                           static_cast<std::int64_t>(std::floor(p.y() / side)),
                                           static_cast<std::int64_t>(std::floor(p.z() / side))};
    if (taken.insert(cell).second) thinned.push_back(p);
  }
  return thinned;
}

}  // namespace

ErasedSpace erasedSpaceOf(const std::vector<Stand>& stands) {
  ErasedSpace space;
  for (std::size_t s = 0; s < stands.size(); ++s)
    for (const ErasedRegion& erased : stands[s].erased)
      space.add(static_cast<int>(s), erased.region, stands[s].T_object_table.value_or(Pose::Identity()));
  return space;
}

std::vector<int> erasuresOf(const std::vector<Stand>& stands) {
  std::set<int> numbers;
  for (const Stand& stand : stands)
    for (const ErasedRegion& erased : stand.erased) numbers.insert(erased.number);
  return {numbers.begin(), numbers.end()};
}

int nextErasure(const std::vector<Stand>& stands) {
  const std::vector<int> numbers = erasuresOf(stands);
  return numbers.empty() ? 0 : numbers.back() + 1;
}

std::vector<View> viewsToIntegrate(std::vector<View> views, const ErasedSpace& space) {
  if (!space.empty() && severalStands(views))
    for (View& view : views) view = withoutErased(view, space);
  return views;
}

RegistrationTarget targetInStand(const AcquisitionState& state, int stand) {
  RegistrationTarget model(state.model->mesh, state.model->confidence);
  const ErasedSpace space = erasedSpaceOf(state.stands);
  if (!space.isIn(stand)) return model;
  std::vector<float> confidence;
  const Mesh erased = erasedSurface(viewsOf(state), stand, space, &confidence);
  OrientedPoints points = model.surface();
  points.append(RegistrationTarget(erased, confidence).surface(), Pose::Identity());
  return RegistrationTarget(std::move(points));
}

Mesh surfaceInStand(const AcquisitionState& state, int stand) {
  const Mesh erased = erasedSurface(viewsOf(state), stand, erasedSpaceOf(state.stands));
  if (erased.empty()) return state.model->mesh;
  return together(std::array<const Mesh*, 2>{&state.model->mesh, &erased});
}

std::vector<std::uint8_t> erasedBorderNow(const AcquisitionState& state) {
  if (compositeInWork(state) != compositeOf(state, state.stand())) return {};
  return erasedBorder(*state.model, viewsOf(state), state.stand(), erasedSpaceOf(state.stands));
}

ErasedSpace spaceOf(const AcquisitionState& state, const ErasingRegion& erasing) {
  ErasedSpace space;
  const Pose T_object_table = tableOf(state, erasing.stand);
  for (int stand = 0; stand <= state.stand(); ++stand) {
    const bool concerned = erasing.alone ? stand == erasing.stand : compositeOf(state, stand) == compositeInWork(state);
    if (!concerned) continue;
    const Pose T_this_object = tableOf(state, stand).inverse();
    const Region region =
        stand == erasing.stand ? erasing.region : moved(erasing.region, T_this_object * T_object_table);
    space.add(stand, std::make_shared<const RegionProbe>(region), tableOf(state, stand));
  }
  return space;
}

Erasure erasureOf(const AcquisitionState& state, const ErasingRegion& erasing, const Progress& progress) {
  const Mesh& mesh = state.model->mesh;
  Erasure erasure;
  erasure.triangles = erasedTriangles(*state.model, viewsOf(state), spaceOf(state, erasing), progress);
  std::vector<std::uint8_t> stays(mesh.vertices.size(), 0);
  Mesh gone;
  gone.vertices = mesh.vertices;
  for (std::size_t t = 0; t < erasure.triangles.size(); ++t) {
    if (erasure.triangles[t] == 0) {
      for (const std::uint32_t v : mesh.triangles[t]) stays[v] = 1;
      continue;
    }
    gone.triangles.push_back(mesh.triangles[t]);
    erasure.area += triangleArea(mesh, mesh.triangles[t]);
  }
  removeUnusedVertices(gone);
  erasure.samples = mesh.vertices.size() -
                    static_cast<std::size_t>(std::count(stays.begin(), stays.end(), static_cast<std::uint8_t>(1)));
  erasure.pieces = piecesOf(gone).size();
  return erasure;
}

Prism frontOf(const AcquisitionState& state, Prism lasso) {
  lasso.farthest = std::numeric_limits<double>::infinity();
  const Pose T_table_object = tableOf(state, state.stand()).inverse();
  const Pose T_eye_object = lasso.T_region_eye.inverse() * T_table_object;
  const RegionProbe through{Region(lasso)};
  std::vector<double> depths;
  for (const Vec3& v : state.model->mesh.vertices)
    if (through.holds(T_table_object * v)) depths.push_back(-(T_eye_object * v).z());
  std::sort(depths.begin(), depths.end());
  const double gap = kDepthGap * meanSpacingOf(viewsOf(state));
  for (std::size_t i = 1; i < depths.size(); ++i)
    if (depths[i] - depths[i - 1] > gap) {
      lasso.farthest = 0.5 * (depths[i] + depths[i - 1]);
      break;
    }
  return lasso;
}

std::optional<NearPoints> loosePiecesRegion(const AcquisitionState& state, double largestArea) {
  const Mesh& mesh = state.model->mesh;
  const std::vector<std::uint8_t> loose = loosePieces(mesh, largestArea);
  std::vector<std::uint8_t> isOfPiece(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < loose.size(); ++t)
    if (loose[t] != 0)
      for (const std::uint32_t v : mesh.triangles[t]) isOfPiece[v] = 1;
  std::vector<Vec3> ofPieces;
  std::vector<Vec3> rest;
  const Pose T_table_object = tableOf(state, state.stand()).inverse();
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    (isOfPiece[v] != 0 ? ofPieces : rest).push_back(T_table_object * mesh.vertices[v]);
  if (ofPieces.empty()) return std::nullopt;
  const double around = kAroundPiece * meanSpacingOf(viewsOf(state));
  NearPoints region{{}, std::min(around, kShareOfGap * leastDistance(ofPieces, rest, around / kShareOfGap))};
  region.radius = std::max(region.radius, std::numeric_limits<float>::epsilon() * around);
  const double apart = kThinned * region.radius;
  region.points = thinnedTo(ofPieces, apart);
  return region;
}

}  // namespace vantage
