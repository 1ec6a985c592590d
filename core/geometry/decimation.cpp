#include "geometry/decimation.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <limits>
#include <numeric>
#include <vector>

#include "base/errors.h"

namespace vantage {
namespace {

struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

class OpenMeshMesh : public OpenMesh::TriMesh_ArrayKernelT<MeshTraits> {
 public:
  OpenMeshMesh() { add_property(origin_); }

  // The vertex of the input that a vertex is.
  [[nodiscard]] std::uint32_t origin(VertexHandle v) const { return property(origin_, v); }
  void setOrigin(VertexHandle v, std::uint32_t origin) { property(origin_, v) = origin; }

  // Whether collapsing from v0 to v1 keeps the mesh manifold. Stands in front of OpenMesh's own test, which lives in
  // its library and there, with the assertions Debian builds it with, takes two thirds of a decimation.
  bool is_collapse_ok(HalfedgeHandle v0v1) {  // NOLINT(readability-identifier-naming): OpenMesh calls it so
    const HalfedgeHandle v1v0 = opposite_halfedge_handle(v0v1);
    const VertexHandle v0 = to_vertex_handle(v1v0);
    const VertexHandle v1 = to_vertex_handle(v0v1);
    if (status(edge_handle(v0v1)).deleted() || status(v0).deleted() || status(v1).deleted()) return false;
    if (isEar(v0v1) || isEar(v1v0)) return false;
    const VertexHandle left = oppositeVertex(v0v1);
    const VertexHandle right = oppositeVertex(v1v0);
    if (left == right) return false;
    if (is_boundary(v0) && is_boundary(v1) && !is_boundary(v0v1) && !is_boundary(v1v0)) return false;
    // The link condition: the rings of v0 and v1 share no other vertices.
    ringOf_.resize(n_vertices());
    forRing(v0v1, [&](VertexHandle v) { ringOf_[static_cast<std::size_t>(v.idx())] = v0; });
    bool linked = true;
    forRing(v1v0, [&](VertexHandle v) {
      if (ringOf_[static_cast<std::size_t>(v.idx())] == v0 && v != left && v != right) linked = false;
    });
    forRing(v0v1, [&](VertexHandle v) { ringOf_[static_cast<std::size_t>(v.idx())].invalidate(); });
    return linked;
  }

 private:
  // A triangle whose other two edges are both boundary would be left hanging.
  [[nodiscard]] bool isEar(HalfedgeHandle h) const {
    if (is_boundary(h)) return false;
    const HalfedgeHandle next = next_halfedge_handle(h);
    return is_boundary(opposite_halfedge_handle(next)) &&
           is_boundary(opposite_halfedge_handle(next_halfedge_handle(next)));
  }

  [[nodiscard]] VertexHandle oppositeVertex(HalfedgeHandle h) const {
    return is_boundary(h) ? VertexHandle() : to_vertex_handle(next_halfedge_handle(h));
  }

  // Visits the neighbours of the vertex that a half-edge leaves.
  template <typename Visit>
  void forRing(HalfedgeHandle first, const Visit& visit) const {
    HalfedgeHandle h = first;
    do {
      visit(to_vertex_handle(h));
      h = opposite_halfedge_handle(prev_halfedge_handle(h));
    } while (h != first);
  }

  std::vector<VertexHandle> ringOf_;
  OpenMesh::VPropHandleT<std::uint32_t> origin_;
};

using Decimater = OpenMesh::Decimater::DecimaterT<OpenMeshMesh>;

// A collapse turns no triangle by more than this [degrees].
constexpr double kMaxTurn = 60.0;
// Collapses between two looks at the stop request.
constexpr std::size_t kStopInterval = 1000;

// Orders collapses by quadric error, which OpenMesh weighs by area, and refuses those whose vertex would lie farther
// from the planes it stands for than a distance (root mean square over their area).
class BoundedQuadric : public OpenMesh::Decimater::ModQuadricT<OpenMeshMesh> {
 public:
  using Base = OpenMesh::Decimater::ModQuadricT<OpenMeshMesh>;
  using Handle = OpenMesh::Decimater::ModHandleT<BoundedQuadric>;

  explicit BoundedQuadric(OpenMeshMesh& mesh) : Base(mesh) {
    set_max_err(std::numeric_limits<double>::max(), false);
    mesh.add_property(area_);
  }
  ~BoundedQuadric() override { mesh().remove_property(area_); }
  BoundedQuadric(const BoundedQuadric&) = delete;
  BoundedQuadric& operator=(const BoundedQuadric&) = delete;

  void setMaxDistance(double distance) { maxSquaredDistance_ = distance * distance; }

  void initialize() override {
    Base::initialize();
    for (const auto v : mesh().vertices()) {
      double& area = mesh().property(area_, v);
      area = 0.0;
      for (const auto f : mesh().vf_range(v)) area += mesh().calc_face_area(f);
    }
  }

  float collapse_priority(const OpenMesh::Decimater::CollapseInfoT<OpenMeshMesh>& collapse) override {
    const float error = Base::collapse_priority(collapse);
    const double area = mesh().property(area_, collapse.v0) + mesh().property(area_, collapse.v1);
    return static_cast<double>(error) <= maxSquaredDistance_ * area ? error : static_cast<float>(ILLEGAL_COLLAPSE);
  }

  void postprocess_collapse(const OpenMesh::Decimater::CollapseInfoT<OpenMeshMesh>& collapse) override {
    Base::postprocess_collapse(collapse);
    mesh().property(area_, collapse.v1) += mesh().property(area_, collapse.v0);
  }

 private:
  OpenMesh::VPropHandleT<double> area_;
  double maxSquaredDistance_ = 0.0;
};

// Tells how far the decimation is, and ends it when a stop is requested.
class StopObserver final : public OpenMesh::Decimater::Observer {
 public:
  // @param collapses about so many are to come; each takes two triangles
  StopObserver(const Progress& progress, std::size_t collapses)
      : Observer(kStopInterval), progress_(progress), collapses_(static_cast<double>(collapses)) {}
  // No exception may go through OpenMesh.
  void notify(std::size_t step) override {
    try {
      progress_.checkpoint(static_cast<double>(step) / collapses_);
    } catch (const Cancelled&) {
      // abort() tells.
    }
  }
  [[nodiscard]] bool abort() const override { return progress_.stopRequested(); }

 private:
  Progress progress_;
  double collapses_;
};

// OpenMesh complains on std::cerr about every triangle it refuses; that is not ours to print.
void silenceOpenMesh() {
  static const bool silent = (omerr().disable(), true);
  static_cast<void>(silent);
}

OpenMeshMesh toOpenMesh(const Mesh& mesh) {
  silenceOpenMesh();
  OpenMeshMesh result;
  result.request_vertex_status();
  result.request_edge_status();
  result.request_halfedge_status();
  result.request_face_status();
  for (const Vec3& v : mesh.vertices) {
    const auto added = result.add_vertex({v.x(), v.y(), v.z()});
    result.setOrigin(added, static_cast<std::uint32_t>(added.idx()));
  }
  using Handle = OpenMeshMesh::VertexHandle;
  for (const Triangle& t : mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    result.add_face(Handle(static_cast<int>(t[0])), Handle(static_cast<int>(t[1])), Handle(static_cast<int>(t[2])));
  }
  return result;
}

DecimatedMesh fromOpenMesh(const OpenMeshMesh& source) {
  DecimatedMesh result;
  Mesh& mesh = result.mesh;
  mesh.vertices.reserve(source.n_vertices());
  for (const auto v : source.vertices()) {
    const OpenMesh::Vec3d& p = source.point(v);
    mesh.vertices.emplace_back(p[0], p[1], p[2]);
    result.vertexOf.push_back(source.origin(v));
  }
  mesh.triangles.reserve(source.n_faces());
  for (const auto f : source.faces()) {
    Triangle t{};
    int k = 0;
    for (const auto v : source.fv_range(f)) t[k++] = static_cast<std::uint32_t>(v.idx());
    mesh.triangles.push_back(t);
  }
  return result;
}

// Drops vertices that no triangle uses.
void dropUnused(DecimatedMesh& result) {
  const std::vector<std::uint32_t> place = removeUnusedVertices(result.mesh);
  std::size_t kept = 0;
  for (std::size_t v = 0; v < place.size(); ++v)
    if (place[v] != kNoIndex) result.vertexOf[kept++] = result.vertexOf[v];
  result.vertexOf.resize(kept);
}

DecimatedMesh asItIs(const Mesh& mesh) {
  DecimatedMesh result{mesh, std::vector<std::uint32_t>(mesh.vertices.size())};
  std::iota(result.vertexOf.begin(), result.vertexOf.end(), 0U);
  return result;
}

void lockBoundary(OpenMeshMesh& mesh) {
  for (const auto e : mesh.edges()) {
    if (!mesh.is_boundary(e)) continue;
    const auto h = mesh.halfedge_handle(e, 0);
    mesh.status(mesh.from_vertex_handle(h)).set_locked(true);
    mesh.status(mesh.to_vertex_handle(h)).set_locked(true);
  }
}

}  // namespace

Mesh decimate(const Mesh& mesh, const DecimationOptions& options, const Progress& progress) {
  return decimateKnowing(mesh, options, progress).mesh;
}

DecimatedMesh decimateKnowing(const Mesh& mesh, const DecimationOptions& options, const Progress& progress) {
  progress.checkpoint(0.0);
  validate(mesh);
  if (mesh.triangles.size() <= options.targetTriangles) return asItIs(mesh);
  OpenMeshMesh work = toOpenMesh(mesh);
  work.request_face_normals();
  work.update_face_normals();
  if (options.keepBoundary) lockBoundary(work);
  progress.checkpoint(0.2);

  Decimater decimater(work);
  BoundedQuadric::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).setMaxDistance(options.maxError);
  OpenMesh::Decimater::ModNormalFlippingT<OpenMeshMesh>::Handle flipping;
  decimater.add(flipping);
  decimater.module(flipping).set_max_normal_deviation(kMaxTurn);
  StopObserver observer(progress.part(0.3, 0.9), (mesh.triangles.size() - options.targetTriangles) / 2 + 1);
  decimater.set_observer(&observer);
  decimater.initialize();
  progress.checkpoint(0.3);
  decimater.decimate_to_faces(0, options.targetTriangles);
  progress.checkpoint(0.9);

  work.garbage_collection();
  DecimatedMesh result = fromOpenMesh(work);
  dropUnused(result);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
