#include "io/mesh_repair.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

#include "geometry/mesh_orientation.h"

namespace vantage {
namespace {

bool isUsable(const Vec3& p) {
  return p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxMeshCoordinate;
}

// The triangles of all polygons that can be surface.
std::vector<Triangle> cutPolygons(const PolygonSoup& soup, MeshRepair& repair, const Progress& progress) {
  std::vector<std::uint8_t> usable(soup.points.size());
  std::transform(soup.points.begin(), soup.points.end(), usable.begin(), isUsable);
  std::vector<Triangle> triangles;
  triangles.reserve(soup.ends.size());
  for (std::size_t i = 0; i < soup.ends.size(); ++i) {
    if (i % 65536 == 0) progress.checkpoint(static_cast<double>(i) / static_cast<double>(soup.ends.size()));
    const auto polygon = soup.polygon(i);
    if (polygon.size() < 3) {
      ++repair.droppedDegenerate;
    } else if (std::any_of(polygon.begin(), polygon.end(), [&](std::uint32_t v) { return v >= usable.size(); })) {
      ++repair.droppedMissingVertex;
    } else if (std::any_of(polygon.begin(), polygon.end(), [&](std::uint32_t v) { return usable[v] == 0; })) {
      ++repair.droppedNotFinite;
    } else {
      repair.polygonsCut += polygon.size() > 3 ? 1 : 0;
      triangulatePolygon(soup.points, polygon, triangles);
    }
  }
  return triangles;
}

std::uint64_t hashOf(const Vec3& p) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    // Adding zero makes -0 and 0 the same.
    hash = (hash ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash;
}

// Per vertex the first vertex at the same place. Open addressing: the table is twice as large as it must be.
std::vector<std::uint32_t> firstAtPlace(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 2), kNoIndex);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    std::size_t slot = hashOf(points[v]) & (table.size() - 1);
    while (table[slot] != kNoIndex && points[table[slot]] != points[v]) slot = (slot + 1) & (table.size() - 1);
    if (table[slot] == kNoIndex) table[slot] = v;
    first[v] = table[slot];
  }
  return first;
}

void mergeVertices(Mesh& mesh, MeshRepair& repair) {
  // What is not a number equals nothing, not even itself, and no triangle uses it.
  for (Vec3& p : mesh.vertices)
    if (!isUsable(p)) p.setConstant(2.0 * kMaxMeshCoordinate);
  const std::vector<std::uint32_t> first = firstAtPlace(mesh.vertices);
  std::vector<std::uint8_t> isMerged(mesh.vertices.size(), 0);
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& v : t) {
      isMerged[v] = first[v] != v ? 1 : 0;
      v = first[v];
    }
  }
  repair.mergedVertices = static_cast<std::size_t>(std::count(isMerged.begin(), isMerged.end(), 1));
}

// An area that single precision cannot tell from nothing would be no surface to the ray caster.
bool hasArea(const Mesh& mesh, const Triangle& t) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
  const Eigen::Vector3f a = mesh.vertices[t[0]].cast<float>();
  const Eigen::Vector3f b = mesh.vertices[t[1]].cast<float>();
  const Eigen::Vector3f c = mesh.vertices[t[2]].cast<float>();
  return areaVector(mesh, t).norm() > 0.0 && (b - a).cast<double>().cross((c - a).cast<double>()).norm() > 0.0;
}

Triangle smallestFirst(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

void dropDuplicates(Mesh& mesh, MeshRepair& repair) {
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::vector<Triangle> key(mesh.triangles.size());
  std::transform(mesh.triangles.begin(), mesh.triangles.end(), key.begin(), smallestFirst);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
  std::vector<std::uint8_t> repeated(mesh.triangles.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i) repeated[order[i]] = key[order[i]] == key[order[i - 1]] ? 1 : 0;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (repeated[t] == 0) mesh.triangles[kept++] = mesh.triangles[t];
  repair.droppedDuplicate = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
}

std::size_t dropUnused(Mesh& mesh) {
  const std::size_t before = mesh.vertices.size();
  removeUnusedVertices(mesh);
  return before - mesh.vertices.size();
}

void addPhrase(std::string& text, std::size_t count, const char* one, const char* many) {
  if (count == 0) return;
  if (!text.empty()) text += ", ";
  text += std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

Mesh repairedMesh(PolygonSoup soup, MeshRepair& repair, const Progress& progress) {
  Mesh mesh;
  repair.bytesLeftOver = soup.bytesLeftOver;
  mesh.triangles = cutPolygons(soup, repair, progress.part(0.0, 0.3));
  mesh.vertices = std::move(soup.points);
  soup = {};
  mergeVertices(mesh, repair);
  progress.checkpoint(0.5);
  repair.droppedDegenerate += std::erase_if(mesh.triangles, [&](const Triangle& t) { return !hasArea(mesh, t); });
  dropDuplicates(mesh, repair);
  progress.checkpoint(0.7);
  repair.unusedVertices = dropUnused(mesh) - repair.mergedVertices;
  const OrientationResult orientation = orientOutward(mesh);
  repair.flippedTriangles = orientation.flippedTriangles;
  repair.openSeams = orientation.openSeams;
  progress.checkpoint(1.0);
  return mesh;
}

std::string describe(const MeshRepair& repair) {
  std::string text;
  addPhrase(text, repair.polygonsCut, "polygon cut into triangles", "polygons cut into triangles");
  addPhrase(text, repair.droppedMissingVertex, "face that names a missing vertex, normal or texture coordinate dropped",
            "faces that name a missing vertex, normal or texture coordinate dropped");
  addPhrase(text, repair.droppedNotFinite, "face with a coordinate that is no number or beyond 1e9 dropped",
            "faces with a coordinate that is no number or beyond 1e9 dropped");
  addPhrase(text, repair.droppedDegenerate, "face without an area dropped", "faces without an area dropped");
  addPhrase(text, repair.droppedDuplicate, "repeated triangle dropped", "repeated triangles dropped");
  addPhrase(text, repair.mergedVertices, "vertex merged with another", "vertices merged with others");
  addPhrase(text, repair.unusedVertices, "unused vertex left out", "unused vertices left out");
  addPhrase(text, repair.flippedTriangles, "triangle turned round", "triangles turned round");
  addPhrase(text, repair.openSeams, "edge where no orientation agrees", "edges where no orientation agrees");
  addPhrase(text, repair.bytesLeftOver, "byte at the end of the file not read",
            "bytes at the end of the file not read");
  return text;
}

}  // namespace vantage
