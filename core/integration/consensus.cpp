#include "integration/consensus.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "integration/grid_surface.h"

namespace vantage {
namespace {

// A line more inclined to the triangle than this meets it nowhere worth counting,
constexpr double kMinCosine = 0.2;
// and a view that a surface turns away from farther than this has not seen it.
constexpr double kMinFacing = 0.1;

// What a view says about a vertex.
struct Opinion {
  double offset = 0.0;
  double weight = 0.0;
  double confidence = 0.0;
};

class Witness {
 public:
  Witness(const View& view, const ConsensusOptions& options)
      : surface_(view),
        maxOffset_(std::max(options.maxOffset, options.spacingOffset * surface_.mesh().spacing)),
        minNormalCosine_(std::cos(options.normalTolerance)),
        leastFacing_(surface_.leastFacing(kMinFacing)) {}

  [[nodiscard]] Opinion ask(const Vec3& vertex, const Vec3& vertexNormal, std::optional<GridPosition>& hint) const {
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
    return {offset, fade * surface_.quality(*contact), surface_.confidence(*contact)};
  }

 private:
  GridSurface surface_;
  double maxOffset_;
  double minNormalCosine_;
  double leastFacing_;
};

void averagePositions(Model& model, std::span<const Witness> witnesses, const Progress& progress) {
  const std::vector<Vec3> normals = computeVertexNormals(model.mesh);
  parallelChunks(normals.size(), 1024, progress, [&](std::size_t begin, std::size_t end) {
    std::vector<std::optional<GridPosition>> hints(witnesses.size());
    for (std::size_t v = begin; v < end; ++v) {
      if (normals[v].isZero()) continue;
      double sum = 0.0;
      double weight = 0.0;
      double confidence = model.confidence[v];
      for (std::size_t k = 0; k < witnesses.size(); ++k) {
        const Opinion opinion = witnesses[k].ask(model.mesh.vertices[v], normals[v], hints[k]);
        sum += opinion.weight * opinion.offset;
        weight += opinion.weight;
        if (opinion.weight > 0.0) confidence = std::max(confidence, opinion.confidence);
      }
      if (weight > 0.0) model.mesh.vertices[v] += sum / weight * normals[v];
      model.confidence[v] = static_cast<float>(confidence);
    }
  });
}

}  // namespace

Model applyConsensus(const Model& model, std::span<const View> views, const ConsensusOptions& options,
                     const Progress& progress) {
  std::vector<std::optional<Witness>> slots(views.size());
  parallelChunks(views.size(), 1, progress.part(0.0, 0.0),
                 [&](std::size_t i, std::size_t) { slots[i].emplace(views[i], options); });
  std::vector<Witness> witnesses;
  witnesses.reserve(views.size());
  for (auto& slot : slots) witnesses.push_back(*std::move(slot));
  Model result = model;
  for (int pass = 0; pass < options.passes; ++pass)
    averagePositions(
        result, witnesses,
        progress.part(static_cast<double>(pass) / options.passes, (pass + 1.0) / options.passes, "consensus"));
  return result;
}

}  // namespace vantage
