#include "finishing/simplification.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "base/errors.h"
#include "geometry/decimation.h"

namespace vantage {
namespace {

// No surface is as large: as good as no limit [mm].
constexpr double kNoLimit = 1e9;
// The mean error over a collapsed vertex is below the greatest one: this often it is made smaller, by as much as the
// greatest one was too large and this factor, until that holds.
constexpr int kTries = 6;
constexpr double kSmaller = 0.85;

void check(const Mesh& mesh, const SimplificationOptions& options) {
  if (mesh.triangles.empty()) throw InvalidInput("there is no surface to simplify");
  if (!options.maxTriangles && !options.maxError)
    throw InvalidInput("to simplify a surface a number of triangles or a greatest error is needed");
  if (options.maxTriangles && *options.maxTriangles == 0)
    throw InvalidInput("a surface of 0 triangles is none: at least 1 is needed");
  if (options.maxError && !(*options.maxError > 0.0 && std::isfinite(*options.maxError)))
    throw InvalidInput("the greatest error of a simplified surface is a length above 0 mm");
}

SimplifiedMesh unchanged(const Mesh& mesh, std::size_t most) {
  SimplifiedMesh result{mesh, std::vector<std::uint32_t>(mesh.vertices.size()), {}, mesh.triangles.size() <= most};
  std::iota(result.vertexOf.begin(), result.vertexOf.end(), 0U);
  return result;
}

}  // namespace

SimplifiedMesh simplify(const Mesh& mesh, const SimplificationOptions& options, const Progress& progress) {
  progress.checkpoint(0.0);
  check(mesh, options);
  const std::size_t most = options.maxTriangles.value_or(mesh.triangles.size());
  DecimationOptions decimation;
  decimation.targetTriangles = options.maxTriangles.value_or(1);
  decimation.maxError = options.maxError.value_or(kNoLimit);
  for (int tries = 0; tries < kTries; ++tries) {
    const Progress part = progress.part(static_cast<double>(tries) / kTries, (tries + 1.0) / kTries);
    DecimatedMesh coarse = decimateKnowing(mesh, decimation, part.part(0.0, 0.6));
    if (!coarse.mesh.triangles.empty()) {
      const SurfaceDistance error = distanceBetween(mesh, coarse.mesh, part.part(0.6, 1.0));
      if (!options.maxError || error.greatest <= *options.maxError) {
        const bool reached = coarse.mesh.triangles.size() <= most;
        return {std::move(coarse.mesh), std::move(coarse.vertexOf), error, reached};
      }
      decimation.maxError *= *options.maxError / error.greatest;
    }
    decimation.maxError *= kSmaller;
  }
  return unchanged(mesh, most);
}

}  // namespace vantage
