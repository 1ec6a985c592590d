#include "integration/view_witness.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"

namespace vantage {
namespace {

// A line more inclined to the triangle than this meets it nowhere worth counting,
constexpr double kMinCosine = 0.2;
// and a view that a surface turns away from farther than this has not seen it.
constexpr double kMinFacing = 0.1;

}  // namespace

ViewWitness::ViewWitness(const View& view, const ConsensusOptions& options)
    : surface_(view),
      maxOffset_(std::max(options.maxOffset, options.spacingOffset * surface_.mesh().spacing)),
      minNormalCosine_(std::cos(options.normalTolerance)),
      leastFacing_(surface_.leastFacing(kMinFacing)) {}

Opinion ViewWitness::ask(const Vec3& vertex, const Vec3& vertexNormal, std::optional<GridPosition>& hint) const {
  const Vec3 normal = surface_.T_scanner_object().linear() * vertexNormal;
  if (!surface_.mayFace(normal, leastFacing_)) return {};
  const Vec3 p = surface_.T_scanner_object() * vertex;
  const auto position = hint ? surface_.rays().locate(p, *hint) : surface_.rays().locate(p);
  if (!position) return {};
  hint = position;
  const auto contact = surface_.at(*position);
  if (!contact || normal.dot(surface_.normal(*contact)) < minNormalCosine_) return {};
  if (-normal.dot(surface_.rays().rayAt(*position).direction) < kMinFacing) return {};
  const Mesh& mesh = surface_.mesh().mesh;
  const Triangle& t = mesh.triangles[contact->triangle];
  const Vec3 plane = triangleNormal(mesh, t);
  const double along = plane.dot(normal);
  if (along < kMinCosine) return {};
  const double offset = plane.dot(mesh.vertices[t[0]] - p) / along;
  const double excess = offset / maxOffset_;
  if (std::abs(excess) >= 1.0) return {};
  const double fade = (1.0 - excess * excess) * (1.0 - excess * excess);
  return {offset, fade * surface_.quality(*contact), surface_.confidence(*contact), *contact};
}

std::vector<ViewWitness> witnessesOf(std::span<const View> views, const ConsensusOptions& options,
                                     const Progress& progress) {
  std::vector<std::optional<ViewWitness>> slots(views.size());
  parallelChunks(views.size(), 1, progress, [&](std::size_t i, std::size_t) { slots[i].emplace(views[i], options); });
  std::vector<ViewWitness> witnesses;
  witnesses.reserve(views.size());
  for (auto& slot : slots) witnesses.push_back(*std::move(slot));
  return witnesses;
}

}  // namespace vantage
