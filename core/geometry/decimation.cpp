#include "geometry/decimation.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/Property.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace vantage {
namespace {

struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

OpenMeshMesh toOpenMesh(const Mesh& mesh) {
  OpenMeshMesh result;
  result.request_vertex_status();
  result.request_edge_status();
  result.request_halfedge_status();
  result.request_face_status();
  for (const Vec3& v : mesh.vertices) result.add_vertex({v.x(), v.y(), v.z()});
  using Handle = OpenMeshMesh::VertexHandle;
  for (const Triangle& t : mesh.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    result.add_face(Handle(static_cast<int>(t[0])), Handle(static_cast<int>(t[1])), Handle(static_cast<int>(t[2])));
  }
  return result;
}

Mesh fromOpenMesh(const OpenMeshMesh& source) {
  Mesh mesh;
  mesh.vertices.reserve(source.n_vertices());
  for (const auto v : source.vertices()) {
    const OpenMesh::Vec3d& p = source.point(v);
    mesh.vertices.emplace_back(p[0], p[1], p[2]);
  }
  mesh.triangles.reserve(source.n_faces());
  for (const auto f : source.faces()) {
    Triangle t{};
    int k = 0;
    for (const auto v : source.fv_range(f)) t[k++] = static_cast<std::uint32_t>(v.idx());
    mesh.triangles.push_back(t);
  }
  return mesh;
}

}  // namespace

Mesh decimate(const Mesh& mesh, const DecimationOptions& options, const Progress& progress) {
  progress.checkpoint(0.0);
  if (mesh.triangles.size() <= options.targetTriangles) return mesh;
  // OpenMesh complains on std::cerr about every complex edge it refuses; that is not ours to print.
  omerr().disable();
  OpenMeshMesh work = toOpenMesh(mesh);
  omerr().enable();
  if (options.keepBoundary) {
    for (const auto e : work.edges()) {
      if (!work.is_boundary(e)) continue;
      const auto h = work.halfedge_handle(e, 0);
      work.status(work.from_vertex_handle(h)).set_locked(true);
      work.status(work.to_vertex_handle(h)).set_locked(true);
    }
  }
  OpenMesh::Decimater::DecimaterT<OpenMeshMesh> decimater(work);
  OpenMesh::Decimater::ModQuadricT<OpenMeshMesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).set_max_err(options.maxError * options.maxError, false);
  decimater.initialize();
  progress.checkpoint(0.2);
  decimater.decimate_to_faces(0, options.targetTriangles);
  work.garbage_collection();
  Mesh result = fromOpenMesh(work);
  removeUnusedVertices(result);
  progress.checkpoint(1.0);
  return result;
}

}  // namespace vantage
