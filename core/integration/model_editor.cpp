#include "integration/model_editor.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "base/errors.h"

namespace vantage {
namespace {

std::uint64_t hashOf(std::uint32_t vertex) {
  return mixedBits((static_cast<std::uint64_t>(vertex) + 1) * 0x9e3779b97f4a7c15ULL);
}

}  // namespace

ModelEditor::ModelEditor(Model model)
    : model_(std::move(model)),
      alive_(model_.mesh.triangles.size(), 1),
      first_(model_.mesh.vertices.size(), kNoIndex),
      next_(3 * model_.mesh.triangles.size(), kNoIndex),
      rim_(model_.mesh.vertices.size(), 0) {
  const std::size_t vertices = model_.mesh.vertices.size();
  if (model_.confidence.size() != vertices || model_.vertexView.size() != vertices ||
      model_.vertexSample.size() != vertices || model_.triangleView.size() != model_.mesh.triangles.size())
    throw InvalidInput("model of " + std::to_string(vertices) + " vertices whose provenance is not complete");
  for (std::uint32_t t = 0; t < triangleCount(); ++t) {
    const Triangle& v = triangle(t);
    if (std::max({v[0], v[1], v[2]}) >= vertices)
      throw InvalidInput("model: triangle " + std::to_string(t) + " names a vertex that is not there");
    for (std::uint32_t k = 0; k < 3; ++k) attach(3 * t + k);
  }
}

std::uint32_t ModelEditor::triangleAt(std::uint32_t from, std::uint32_t to) const {
  for (std::uint32_t corner = first_[from]; corner != kNoIndex; corner = next_[corner]) {
    const std::uint32_t following = corner % 3 == 2 ? corner - 2 : corner + 1;
    if (model_.mesh.triangles[following / 3][following % 3] == to) return corner / 3;
  }
  return kNoIndex;
}

std::vector<std::uint32_t> ModelEditor::trianglesOf(std::uint32_t vertex) const {
  std::vector<std::uint32_t> result;
  visitTriangles(vertex, [&](std::uint32_t t) { result.push_back(t); });
  return result;
}

std::uint32_t ModelEditor::addVertex(const Vec3& position, float confidence, std::uint32_t view, std::uint32_t sample) {
  model_.mesh.vertices.push_back(position);
  model_.confidence.push_back(confidence);
  model_.vertexView.push_back(view);
  model_.vertexSample.push_back(sample);
  first_.push_back(kNoIndex);
  rim_.push_back(0);
  return vertexCount() - 1;
}

void ModelEditor::raiseConfidence(std::uint32_t vertex, float confidence) {
  model_.confidence[vertex] = std::max(model_.confidence[vertex], confidence);
}

bool ModelEditor::addTriangle(const Triangle& triangle, std::uint32_t view) {
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t to = triangle[(k + 1) % 3];
    if (triangle[k] == to || triangleAt(triangle[k], to) != kNoIndex) return false;
  }
  model_.mesh.triangles.push_back(triangle);
  model_.triangleView.push_back(view);
  alive_.push_back(1);
  next_.resize(next_.size() + 3, kNoIndex);
  for (std::uint32_t k = 0; k < 3; ++k) attach(3 * (triangleCount() - 1) + k);
  return true;
}

void ModelEditor::removeTriangle(std::uint32_t t) {
  if (!alive(t)) return;
  alive_[t] = 0;
  for (std::uint32_t k = 0; k < 3; ++k) detach(3 * t + k);
}

void ModelEditor::restoreTriangle(std::uint32_t t) {
  if (alive(t)) return;
  alive_[t] = 1;
  for (std::uint32_t k = 0; k < 3; ++k) attach(3 * t + k);
}

void ModelEditor::attach(std::uint32_t corner) {
  const Triangle& t = triangle(corner / 3);
  const std::uint32_t vertex = t[corner % 3];
  next_[corner] = first_[vertex];
  first_[vertex] = corner;
  rim_[vertex] += hashOf(t[(corner + 1) % 3]) - hashOf(t[(corner + 2) % 3]);
}

void ModelEditor::detach(std::uint32_t corner) {
  const Triangle& t = triangle(corner / 3);
  const std::uint32_t vertex = t[corner % 3];
  std::uint32_t* link = &first_[vertex];
  while (*link != corner) link = &next_[*link];
  *link = next_[corner];
  rim_[vertex] -= hashOf(t[(corner + 1) % 3]) - hashOf(t[(corner + 2) % 3]);
}

Model ModelEditor::take() && {
  Model result;
  result.mesh.vertices = std::move(model_.mesh.vertices);
  for (std::uint32_t t = 0; t < alive_.size(); ++t) {
    if (!alive_[t]) continue;
    result.mesh.triangles.push_back(model_.mesh.triangles[t]);
    result.triangleView.push_back(model_.triangleView[t]);
  }
  const std::vector<std::uint32_t> newIndex = removeUnusedVertices(result.mesh);
  const std::size_t used = result.mesh.vertices.size();
  result.confidence.resize(used);
  result.vertexView.resize(used);
  result.vertexSample.resize(used);
  for (std::size_t v = 0; v < newIndex.size(); ++v) {
    if (newIndex[v] == kNoIndex) continue;
    result.confidence[newIndex[v]] = model_.confidence[v];
    result.vertexView[newIndex[v]] = model_.vertexView[v];
    result.vertexSample[newIndex[v]] = model_.vertexSample[v];
  }
  return result;
}

}  // namespace vantage
