#include "integration/consensus.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "integration/view_witness.h"

namespace vantage {
namespace {

void averagePositions(Model& model, std::span<const ViewWitness> witnesses, const Progress& progress) {
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
  const std::vector<ViewWitness> witnesses = witnessesOf(views, options, progress.part(0.0, 0.0));
  Model result = model;
  for (int pass = 0; pass < options.passes; ++pass)
    averagePositions(
        result, witnesses,
        progress.part(static_cast<double>(pass) / options.passes, (pass + 1.0) / options.passes, "consensus"));
  return result;
}

}  // namespace vantage
