#include "integration/manifold.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace vantage {
namespace {

// The triangles at a vertex, fan by fan.
std::vector<std::vector<std::uint32_t>> fansOf(const ModelEditor& editor, std::uint32_t vertex) {
  std::vector<std::uint32_t> rest = editor.trianglesOf(vertex);
  const auto corner = [&](std::uint32_t t, int offset) {
    const Triangle& v = editor.triangle(t);
    const int k = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    return v[(k + offset) % 3];
  };
  std::vector<std::vector<std::uint32_t>> fans;
  while (!rest.empty()) {
    std::vector<std::uint32_t> fan{rest.back()};
    rest.pop_back();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      for (std::size_t j = rest.size(); j-- > 0;) {
        if (corner(rest[j], 1) != corner(fan[i], 2) && corner(rest[j], 2) != corner(fan[i], 1)) continue;
        fan.push_back(rest[j]);
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(j));
      }
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

}  // namespace

bool isSingleFan(const ModelEditor& editor, std::uint32_t vertex) {
  int count = 0;
  std::uint32_t start = kNoIndex;
  int starts = 0;
  editor.visitTriangles(vertex, [&](std::uint32_t t) {
    ++count;
    const Triangle& v = editor.triangle(t);
    const int k = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    const bool first = editor.triangleAt(v[(k + 1) % 3], vertex) == kNoIndex;
    starts += first ? 1 : 0;
    if (first || start == kNoIndex) start = v[(k + 1) % 3];
  });
  if (count == 0) return true;
  if (starts > 1) return false;
  int walked = 0;
  std::uint32_t at = start;
  for (std::uint32_t t = editor.triangleAt(vertex, at); t != kNoIndex; t = editor.triangleAt(vertex, at)) {
    const Triangle& v = editor.triangle(t);
    const int k = v[0] == vertex ? 0 : (v[1] == vertex ? 1 : 2);
    at = v[(k + 2) % 3];
    ++walked;
    if (at == start) break;
  }
  return walked == count;
}

std::size_t resolveBowTies(ModelEditor& editor, std::span<const std::uint32_t> vertices) {
  std::vector<std::uint32_t> suspects(vertices.begin(), vertices.end());
  for (std::uint32_t v = 0; v < editor.vertexCount(); ++v)
    if (editor.onBoundary(v)) suspects.push_back(v);
  std::size_t removed = 0;
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    if (isSingleFan(editor, suspects[i])) continue;
    auto fans = fansOf(editor, suspects[i]);
    const auto keep = std::max_element(fans.begin(), fans.end(), [](const auto& a, const auto& b) {
      if (a.size() != b.size()) return a.size() < b.size();
      return *std::min_element(a.begin(), a.end()) > *std::min_element(b.begin(), b.end());
    });
    keep->clear();
    for (const auto& fan : fans) {
      for (const std::uint32_t t : fan) {
        editor.removeTriangle(t);
        for (const std::uint32_t v : editor.triangle(t)) suspects.push_back(v);
        ++removed;
      }
    }
  }
  return removed;
}

std::size_t removeIslands(ModelEditor& editor, int minTriangles) {
  std::vector<std::uint32_t> parent(editor.vertexCount());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    if (!editor.alive(t)) continue;
    const Triangle& v = editor.triangle(t);
    const std::uint32_t a = root(v[0]);
    parent[root(v[1])] = a;
    parent[root(v[2])] = a;
  }
  std::vector<int> size(editor.vertexCount(), 0);
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t)
    if (editor.alive(t)) ++size[root(editor.triangle(t)[0])];
  std::size_t removed = 0;
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    if (!editor.alive(t) || size[root(editor.triangle(t)[0])] >= minTriangles) continue;
    editor.removeTriangle(t);
    ++removed;
  }
  return removed;
}

}  // namespace vantage
