#include "integration/redundancy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/pace.h"

namespace vantage {
namespace {

// The view has surface at the triangle's place: the same, or behind it, which refutes it.
bool judged(const Triangle& t, std::span<const ProjectedVertex> projected) {
  return std::all_of(t.begin(), t.end(),
                     [&](std::uint32_t v) { return projected[v].contact == Contact::On || projected[v].refuted; });
}

double ownQuality(const Model& model, std::uint32_t v, std::span<const View> views) {
  const ViewMesh& view = *views[model.vertexView[v]].mesh;
  const std::uint32_t own = view.vertexOfSample[model.vertexSample[v]];
  if (own == kNoIndex) return 0.0;
  return view.onBoundary[own] ? 0.5 * view.confidence[own] : view.confidence[own];
}

// Takes triangles away from the border inwards as long as they are wanted gone.
template <typename Unwanted>
std::size_t erode(ModelEditor& editor, const Unwanted& unwanted, Pace& pace) {
  std::vector<std::uint32_t> queue;
  const std::uint32_t count = editor.triangleCount();
  for (std::uint32_t t = 0; t < count; ++t) {
    pace.step();
    if (!editor.alive(t) || !unwanted(t)) continue;
    for (int k = 0; k < 3; ++k)
      if (editor.isBorderEdge(t, k)) {
        queue.push_back(t);
        break;
      }
  }
  std::size_t removed = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    pace.step();
    const std::uint32_t t = queue[i];
    if (!editor.alive(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t next = editor.neighbour(t, k);
      if (next != kNoIndex && unwanted(next)) queue.push_back(next);
    }
    editor.removeTriangle(t);
    ++removed;
  }
  return removed;
}

// Removes pieces of up to `most` triangles that lie on the view.
std::size_t removeCoveredRemainders(ModelEditor& editor, std::span<const ProjectedVertex> projected, std::size_t most,
                                    Pace& pace) {
  std::vector<std::uint8_t> visited(editor.triangleCount(), 0);
  std::size_t removed = 0;
  std::vector<std::uint32_t> piece;
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    if (!editor.alive(t) || visited[t] || !judged(editor.triangle(t), projected)) continue;
    piece.assign(1, t);
    visited[t] = 1;
    bool covered = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      pace.step();
      covered = covered && judged(editor.triangle(piece[i]), projected);
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t next = editor.neighbour(piece[i], k);
        if (next == kNoIndex || visited[next]) continue;
        visited[next] = 1;
        piece.push_back(next);
      }
    }
    if (!covered || piece.size() > most) continue;
    for (const std::uint32_t p : piece) editor.removeTriangle(p);
    removed += piece.size();
  }
  return removed;
}

void bounds(std::span<const PlanePoint> points, PlanePoint& low, PlanePoint& high) {
  low = high = points[0];
  for (const PlanePoint& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
}

template <typename Visit>
void visitCells(const GridSurface::CellRange& range, const Visit& visit) {
  for (int r = range.firstRow; r <= range.lastRow; ++r)
    for (int c = range.firstColumn; c <= range.lastColumn; ++c) visit(r, c);
}

double squaredDistance(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
  const Vec2 along(b.x - a.x, b.y - a.y);
  const Vec2 to(p.x - a.x, p.y - a.y);
  const double length = along.squaredNorm();
  const double s = length > 0.0 ? std::clamp(to.dot(along) / length, 0.0, 1.0) : 0.0;
  return (to - s * along).squaredNorm();
}

}  // namespace

std::size_t removeRedundantTriangles(ModelEditor& editor, std::span<const ProjectedVertex> projected,
                                     std::span<const View> views, const ZipperOptions& options,
                                     const Progress& progress) {
  const Model& model = editor.model();
  Pace pace(progress);
  const auto unwanted = [&](std::uint32_t t) {
    const Triangle& v = editor.triangle(t);
    if (!judged(v, projected)) return false;
    double gain = 0.0;
    for (const std::uint32_t i : v) gain += projected[i].quality - ownQuality(model, i, views);
    return gain > 3.0 * options.confidenceMargin;
  };
  const std::size_t removed = erode(editor, unwanted, pace);
  if (removed == 0) return 0;
  return removed +
         removeCoveredRemainders(editor, projected, static_cast<std::size_t>(options.minIslandTriangles), pace);
}

OverlapIndex::OverlapIndex(const ModelEditor& editor, std::span<const ProjectedVertex> projected,
                           const GridSurface& surface, const Progress& progress)
    : surface_(surface), start_(surface.rays().size() + 1, 0) {
  Pace pace(progress);
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    pace.step();
    if (!editor.alive(t)) continue;
    const Triangle& v = editor.triangle(t);
    const auto contact = [&](int k) { return projected[v[k]].contact; };
    if (contact(0) == Contact::Unseen || contact(1) == Contact::Unseen || contact(2) == Contact::Unseen) continue;
    if (contact(0) == Contact::Apart && contact(1) == Contact::Apart && contact(2) == Contact::Apart) continue;
    std::array<PlanePoint, 3> place{projected[v[0]].place, projected[v[1]].place, projected[v[2]].place};
    const std::int64_t turn = orientation(place[0], place[1], place[2]);
    if (turn == 0) continue;
    if (turn < 0) std::swap(place[1], place[2]);
    triangles_.push_back(place);
  }
  const auto columns = static_cast<std::size_t>(surface.rays().columns());
  const auto visit = [&](const std::array<PlanePoint, 3>& place, const auto& each) {
    pace.step();
    PlanePoint low;
    PlanePoint high;
    bounds(place, low, high);
    visitCells(surface_.cellsUnder(low, high), [&](int r, int c) { each(static_cast<std::size_t>(r) * columns + c); });
  };
  for (const auto& place : triangles_) visit(place, [&](std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  entries_.resize(start_.back());
  std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
  for (std::uint32_t i = 0; i < triangles_.size(); ++i)
    visit(triangles_[i], [&](std::size_t cell) { entries_[fill[cell]++] = i; });
}

bool OverlapIndex::overlaps(const PlanePoint (&t)[3]) const {
  PlanePoint low;
  PlanePoint high;
  bounds(t, low, high);
  bool found = false;
  visitCells(surface_.cellsUnder(low, high), [&](int r, int c) {
    const std::size_t cell = surface_.rays().index(r, c);
    for (std::uint32_t i = start_[cell]; i < start_[cell + 1] && !found; ++i) {
      const auto& s = triangles_[entries_[i]];
      found = trianglesOverlap({s[0], s[1], s[2]}, t);
    }
  });
  return found;
}

ViewCut cutView(const ModelEditor& editor, std::span<const ProjectedVertex> projected, const GridSurface& surface,
                const OverlapIndex& overlap, const ZipperOptions& options, const Progress& progress) {
  Pace pace(progress);
  const ViewMesh& view = surface.mesh();
  const RayGrid& rays = surface.rays();
  ViewCut cut{std::vector<std::uint8_t>(view.sample.size(), 1),
              std::vector<std::uint8_t>(view.mesh.triangles.size(), 1)};

  for (const auto& s : overlap.triangles()) {
    pace.step();
    PlanePoint low;
    PlanePoint high;
    bounds(s, low, high);
    visitCells(surface.cellsUnder(low, high), [&](int r, int c) {
      for (const std::uint32_t t : surface.cell(r, c)) {
        if (t == kNoIndex || !cut.triangleKept[t]) continue;
        const Triangle& v = view.mesh.triangles[t];
        const PlanePoint place[3] = {surface.planePoint(view.sample[v[0]]), surface.planePoint(view.sample[v[1]]),
                                     surface.planePoint(view.sample[v[2]])};
        if (trianglesOverlap({s[0], s[1], s[2]}, place)) cut.triangleKept[t] = 0;
      }
      const std::uint32_t vertex = view.vertexOfSample[rays.index(r, c)];
      if (vertex == kNoIndex) return;
      const PlanePoint p = surface.planePoint(view.sample[vertex]);
      if (orientation(s[0], s[1], p) >= 0 && orientation(s[1], s[2], p) >= 0 && orientation(s[2], s[0], p) >= 0)
        cut.vertexKept[vertex] = 0;
    });
  }

  const double reach = options.clearance * kPlaneCell;
  const auto margin = static_cast<std::int32_t>(std::ceil(reach));
  for (std::uint32_t t = 0; t < editor.triangleCount(); ++t) {
    pace.step();
    if (!editor.alive(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const ProjectedVertex& a = projected[editor.triangle(t)[k]];
      const ProjectedVertex& b = projected[editor.triangle(t)[(k + 1) % 3]];
      if (a.contact < Contact::Near || b.contact < Contact::Near || !editor.isBorderEdge(t, k)) continue;
      const PlanePoint low{std::min(a.place.x, b.place.x) - margin, std::min(a.place.y, b.place.y) - margin};
      const PlanePoint high{std::max(a.place.x, b.place.x) + margin, std::max(a.place.y, b.place.y) + margin};
      visitCells(surface.cellsUnder(low, high), [&](int r, int c) {
        const std::uint32_t vertex = view.vertexOfSample[rays.index(r, c)];
        if (vertex == kNoIndex) return;
        if (squaredDistance(surface.planePoint(view.sample[vertex]), a.place, b.place) < reach * reach)
          cut.vertexKept[vertex] = 0;
      });
    }
  }

  for (std::size_t t = 0; t < cut.triangleKept.size(); ++t)
    for (const std::uint32_t v : view.mesh.triangles[t])
      if (!cut.vertexKept[v]) cut.triangleKept[t] = 0;
  return cut;
}

}  // namespace vantage
