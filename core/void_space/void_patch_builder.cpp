#include "void_space/void_patch_builder.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "base/parallel.h"
#include "geometry/mesh_border.h"
#include "geometry/mesh_topology.h"
#include "void_space/edge_classification.h"

namespace vantage {
namespace {

constexpr std::size_t kEdgesPerChunk = 64;

void validate(const Model& model, const RayIndex& rays, const VoidOptions& options) {
  if (!(options.breakdownAngle > 0.0 && options.breakdownAngle < 0.5 * kPi))
    throw InvalidInput("the breakdown angle of " + std::to_string(degrees(options.breakdownAngle)) +
                       " degrees is not between 0 and 90");
  vantage::validate(model.mesh);
  const std::size_t vertices = model.mesh.vertices.size();
  if (model.vertexView.size() != vertices || model.vertexSample.size() != vertices ||
      model.confidence.size() != vertices || model.triangleView.size() != model.mesh.triangles.size())
    throw InvalidInput("the model's tables do not have an entry for each of its " + std::to_string(vertices) +
                       " vertices and " + std::to_string(model.mesh.triangles.size()) + " triangles");
  for (std::size_t v = 0; v < vertices; ++v)
    if (model.vertexView[v] >= rays.views() ||
        model.vertexSample[v] >= rays.view(model.vertexView[v]).image->rays->size())
      throw InvalidInput("vertex " + std::to_string(v) + " of the model names sample " +
                         std::to_string(model.vertexSample[v]) + " of view " + std::to_string(model.vertexView[v]) +
                         ", which does not exist among the " + std::to_string(rays.views()) + " views");
}

// The topology of a manifold mesh near its border only: large models have little border. Vertices keep their numbers.
class BorderTopology {
 public:
  // Knows the triangles around vertices up to `rings` edges from the border.
  BorderTopology(const Mesh& mesh, int rings, const Progress& progress)
      : border_(borderVertices(mesh)), near_(nearBorder(mesh, border_, rings, progress.part(0.2, 0.7))) {
    progress.checkpoint(0.7);
    Mesh part;
    part.vertices = mesh.vertices;
    part.triangles.reserve(near_.size());
    for (const std::uint32_t t : near_) part.triangles.push_back(mesh.triangles[t]);
    topology_.emplace(part);
    for (const BoundaryEdge& edge : topology_->boundaryEdges())
      if (border_[edge.from] != 0 && border_[edge.to] != 0)
        edges_.push_back({edge.from, edge.to, near_[edge.triangle]});
  }

  // In order of triangle and edge.
  [[nodiscard]] const std::vector<BoundaryEdge>& edges() const { return edges_; }

  template <typename Visit>
  void visitTriangles(std::uint32_t vertex, const Visit& visit) const {
    for (const std::uint32_t t : topology_->trianglesOf(vertex)) visit(near_[t]);
  }

 private:
  // The triangles that touch a vertex so near, ascending.
  static std::vector<std::uint32_t> nearBorder(const Mesh& mesh, std::vector<std::uint8_t> reached, int rings,
                                               const Progress& progress) {
    const auto touches = [&](const Triangle& t) { return (reached[t[0]] | reached[t[1]] | reached[t[2]]) != 0; };
    for (int ring = 0; ring < rings; ++ring) {
      progress.checkpoint(static_cast<double>(ring) / rings);
      std::vector<std::uint8_t> grown = reached;
      for (const Triangle& t : mesh.triangles)
        if (touches(t)) grown[t[0]] = grown[t[1]] = grown[t[2]] = 1;
      reached = std::move(grown);
    }
    std::vector<std::uint32_t> near;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (touches(mesh.triangles[t])) near.push_back(t);
    return near;
  }

  std::vector<std::uint8_t> border_;
  std::vector<std::uint32_t> near_;
  std::optional<MeshTopology> topology_;
  std::vector<BoundaryEdge> edges_;
};

// Builds patches one by one. Const and shared by threads; what speeds up the search is kept by the caller.
class PatchBuilder {
 public:
  using Hints = std::vector<std::optional<GridPosition>>;

  PatchBuilder(const Model& model, const RayIndex& rays, const VoidOptions& options, const Progress& progress)
      : model_(model),
        options_(options),
        topology_(model.mesh, std::max(0, options.normalRings), progress.part(0.0, 0.4)),
        caster_(model.mesh, RayCaster::Precision::Fast, progress.part(0.4, 1.0)),
        rays_(rays),
        classifier_(caster_, rays_, {options.breakdownAngle, options.jumpFactor, options.shadowReach}) {}

  [[nodiscard]] const std::vector<BoundaryEdge>& edges() const { return topology_.edges(); }

  // The patch of an edge; without width for an edge without length.
  [[nodiscard]] VoidPatch patch(const BoundaryEdge& edge, Hints& hints) const {
    VoidPatch patch;
    patch.from = edge.from;
    patch.to = edge.to;
    patch.triangle = edge.triangle;
    const Vec3& from = model_.mesh.vertices[edge.from];
    const Vec3& to = model_.mesh.vertices[edge.to];
    if (from == to) return patch;

    const EdgeFrame frame = makeEdgeFrame(from, to, normalAt(edge));
    const std::uint32_t sampler = samplingVertex(edge);
    const RayPassage first = rays_.ofSample(model_.vertexView[sampler], model_.vertexSample[sampler], frame.middle);
    const EdgeVerdict verdict = classifier_.classify(frame, first, true);
    const VoidAngle angle = freeSpace(frame, first, verdict, hints).voidAngle();
    patch.view = first.view;
    patch.edgeClass = verdict.edgeClass;
    patch.angle = angle.angle;
    patch.bridged = angle.bridged;
    shape(patch, frame, first.spacing);
    return patch;
  }

 private:
  // A ray of the set R and its place in the order of merging.
  struct Candidate {
    double rho;
    std::uint32_t view;
    RayPassage ray;
  };

  // The endpoint whose ray is r_1.
  [[nodiscard]] std::uint32_t samplingVertex(const BoundaryEdge& edge) const {
    const std::uint32_t own = model_.triangleView[edge.triangle];
    const auto rank = [&](std::uint32_t v) { return std::tuple(model_.vertexView[v] == own, model_.confidence[v]); };
    return rank(edge.to) > rank(edge.from) ? edge.to : edge.from;
  }

  [[nodiscard]] FreeSpaceMap freeSpace(const EdgeFrame& frame, const RayPassage& first, const EdgeVerdict& verdict,
                                       Hints& hints) const {
    FreeSpaceMap map = verdict.freeSpace;
    for (const Candidate& c : otherRays(frame, first, hints)) {
      const bool measured = classifier_.measured(frame, c.ray);
      if (!measured && map.at(c.rho) != Space::Free) break;
      map = FreeSpaceMap::merged(map, classifier_.classify(frame, c.ray, measured).freeSpace);
    }
    return map;
  }

  [[nodiscard]] std::vector<Candidate> otherRays(const EdgeFrame& frame, const RayPassage& first, Hints& hints) const {
    std::vector<Candidate> rays;
    for (std::uint32_t v = 0; v < rays_.views(); ++v) {
      if (v == first.view) continue;
      const auto ray = rays_.through(v, frame.middle, hints[v]);
      if (!ray) continue;
      hints[v] = ray->position;
      if (classifier_.sees(frame, *ray)) rays.push_back({frame.angleOf(-ray->line.direction), v, *ray});
    }
    std::sort(rays.begin(), rays.end(),
              [](const Candidate& a, const Candidate& b) { return std::tie(a.rho, a.view) < std::tie(b.rho, b.view); });
    return rays;
  }

  // Mean normal about the edge, weighted by area; that of its triangle where the mean is of no use.
  [[nodiscard]] Vec3 normalAt(const BoundaryEdge& edge) const {
    const Mesh& mesh = model_.mesh;
    std::vector<std::uint32_t> vertices{edge.from, edge.to};
    std::vector<std::uint32_t> triangles{edge.triangle};
    for (int ring = 0; ring < options_.normalRings; ++ring) {
      triangles.clear();
      for (const std::uint32_t v : vertices)
        topology_.visitTriangles(v, [&](std::uint32_t t) { triangles.push_back(t); });
      makeUnique(triangles);
      for (const std::uint32_t t : triangles)
        for (const std::uint32_t v : mesh.triangles[t]) vertices.push_back(v);
      makeUnique(vertices);
    }
    Vec3 mean = Vec3::Zero();
    for (const std::uint32_t t : triangles) mean += areaVector(mesh, mesh.triangles[t]);
    const Vec3 own = areaVector(mesh, mesh.triangles[edge.triangle]);
    const Vec3 along = (mesh.vertices[edge.to] - mesh.vertices[edge.from]).normalized();
    const Vec3 across = mean - mean.dot(along) * along;
    const bool useful = across.dot(own) > 0.0 && across.norm() > 0.5 * mean.norm();
    if (useful) return mean;
    return own.norm() > 0.0 ? own : Vec3(along.unitOrthogonal());
  }

  static void makeUnique(std::vector<std::uint32_t>& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }

  void shape(VoidPatch& patch, const EdgeFrame& frame, double spacing) const {
    const Vec3& from = model_.mesh.vertices[patch.from];
    const Vec3& to = model_.mesh.vertices[patch.to];
    const Vec3 outward = spacing * frame.direction(patch.angle);
    patch.corners = {to, from, from + outward, to + outward};
    patch.centre = frame.middle + 0.5 * outward;
    patch.normal = frame.direction(patch.angle - 0.5 * kPi);
    patch.width = frame.length;
    patch.depth = spacing;
    patch.weight = options_.weight == PatchWeight::TriangleArea
                       ? triangleArea(model_.mesh, model_.mesh.triangles[patch.triangle])
                       : frame.length * spacing;
  }

  const Model& model_;
  const VoidOptions& options_;
  BorderTopology topology_;
  RayCaster caster_;
  const RayIndex& rays_;
  EdgeClassifier classifier_;
};

}  // namespace

std::string_view name(PatchWeight weight) {
  return weight == PatchWeight::TriangleArea ? "triangle" : "spacing";
}

VoidSurface buildVoidPatches(const Model& model, std::span<const View> views, const VoidOptions& options,
                             const Progress& progress) {
  progress.checkpoint(0.0);
  const RayIndex rays(views);
  validate(model, rays, options);
  const PatchBuilder builder(model, rays, options, progress.part(0.0, 0.2));
  VoidSurface surface;
  surface.patches.resize(builder.edges().size());
  parallelChunks(builder.edges().size(), kEdgesPerChunk, progress.part(0.2, 1.0),
                 [&](std::size_t begin, std::size_t end) {
                   PatchBuilder::Hints hints(views.size());
                   for (std::size_t i = begin; i < end; ++i)
                     surface.patches[i] = builder.patch(builder.edges()[i], hints);
                 });
  std::erase_if(surface.patches, [](const VoidPatch& p) { return p.width == 0.0; });
  for (const VoidPatch& p : surface.patches) {
    ++surface.counts[static_cast<std::size_t>(p.edgeClass)];
    surface.bridged += p.bridged ? 1 : 0;
  }
  return surface;
}

}  // namespace vantage
