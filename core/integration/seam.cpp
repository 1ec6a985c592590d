#include "integration/seam.h"

#include <algorithm>
#include <cmath>

#include "base/pace.h"
#include "integration/constrained_delaunay.h"

namespace vantage {
namespace {

// The points at the gap, of the model and of the view, and the borders between them.
class Gap {
 public:
  Gap(ModelEditor& editor, std::span<const ProjectedVertex> projected, const GridSurface& surface, const ViewCut& cut,
      std::uint32_t newView)
      : editor_(editor),
        projected_(projected),
        surface_(surface),
        view_(surface.mesh()),
        cut_(cut),
        newView_(newView),
        modelVertices_(static_cast<std::uint32_t>(projected.size())),
        modelVertexOf_(view_.sample.size(), kNoIndex) {}

  // Points and constraints of the model's border.
  void addModelBorder() {
    const std::uint32_t triangles = editor_.triangleCount();
    pointOf_.assign(modelVertices_, kNoIndex);
    for (std::uint32_t v = 0; v < modelVertices_; ++v)
      if (projected_[v].contact >= Contact::Near && editor_.onBoundary(v)) {
        pointOf_[v] = static_cast<std::uint32_t>(points.size());
        points.push_back(projected_[v].place);
        vertices.push_back(v);
      }
    for (std::uint32_t t = 0; t < triangles; ++t) {
      if (!editor_.alive(t)) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = pointOf_[editor_.triangle(t)[k]];
        const std::uint32_t b = pointOf_[editor_.triangle(t)[(k + 1) % 3]];
        if (a != kNoIndex && b != kNoIndex && editor_.isBorderEdge(t, k)) constraints.push_back({a, b});
      }
    }
  }

  // Brings what is kept of the view into the model. @return how many triangles.
  std::size_t addView() {
    atGap_ = viewVerticesAtGap();
    std::vector<std::uint8_t> used = atGap_;
    for (std::size_t t = 0; t < cut_.triangleKept.size(); ++t)
      if (cut_.triangleKept[t])
        for (const std::uint32_t v : view_.mesh.triangles[t]) used[v] = 1;
    for (std::uint32_t v = 0; v < used.size(); ++v)
      if (used[v])
        modelVertexOf_[v] = editor_.addVertex(surface_.T_object_scanner() * view_.mesh.vertices[v], view_.confidence[v],
                                              newView_, view_.sample[v]);
    std::size_t added = 0;
    for (std::size_t t = 0; t < cut_.triangleKept.size(); ++t) {
      if (!cut_.triangleKept[t]) continue;
      const Triangle& v = view_.mesh.triangles[t];
      added +=
          editor_.addTriangle({modelVertexOf_[v[0]], modelVertexOf_[v[1]], modelVertexOf_[v[2]]}, newView_) ? 1 : 0;
    }
    return added;
  }

  // Points and constraints of the view where triangles were cut off, and of its own border where the model's is near.
  void addViewBorder() {
    std::vector<std::uint32_t> pointOfView(view_.sample.size(), kNoIndex);
    for (std::uint32_t v = 0; v < atGap_.size(); ++v) {
      if (!atGap_[v]) continue;
      pointOfView[v] = static_cast<std::uint32_t>(points.size());
      points.push_back(surface_.planePoint(view_.sample[v]));
      vertices.push_back(modelVertexOf_[v]);
    }
    for (std::size_t t = 0; t < cut_.triangleKept.size(); ++t) {
      if (!cut_.triangleKept[t]) continue;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t a = view_.mesh.triangles[t][k];
        const std::uint32_t b = view_.mesh.triangles[t][(k + 1) % 3];
        if (atGap_[a] && atGap_[b] && editor_.triangleAt(modelVertexOf_[b], modelVertexOf_[a]) == kNoIndex)
          constraints.push_back({pointOfView[a], pointOfView[b]});
      }
    }
  }

  [[nodiscard]] bool ofModel(std::uint32_t point) const { return vertices[point] < modelVertices_; }

  std::vector<PlanePoint> points;
  std::vector<std::uint32_t> vertices;  // of the model, per point
  std::vector<std::array<std::uint32_t, 2>> constraints;

 private:
  [[nodiscard]] std::vector<std::uint8_t> viewVerticesAtGap() const {
    std::vector<std::uint8_t> atGap(view_.sample.size(), 0);
    for (std::size_t t = 0; t < cut_.triangleKept.size(); ++t)
      if (!cut_.triangleKept[t])
        for (const std::uint32_t v : view_.mesh.triangles[t]) atGap[v] = cut_.vertexKept[v];
    constexpr std::int32_t kReach = kNearCells * kPlaneCell;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PlanePoint& p = points[i];
      const auto range = surface_.cellsUnder({p.x - kReach, p.y - kReach}, {p.x + kReach, p.y + kReach});
      for (int r = range.firstRow; r <= range.lastRow; ++r)
        for (int c = range.firstColumn; c <= range.lastColumn; ++c) {
          const std::uint32_t v = view_.vertexOfSample[surface_.rays().index(r, c)];
          if (v != kNoIndex && view_.onBoundary[v] && cut_.vertexKept[v]) atGap[v] = 1;
        }
    }
    return atGap;
  }

  ModelEditor& editor_;
  std::span<const ProjectedVertex> projected_;
  const GridSurface& surface_;
  const ViewMesh& view_;
  const ViewCut& cut_;
  std::uint32_t newView_;
  std::uint32_t modelVertices_;
  std::vector<std::uint32_t> pointOf_;
  std::vector<std::uint8_t> atGap_;  // per vertex of the view
  std::vector<std::uint32_t> modelVertexOf_;
};

// Decides which triangles of the plane belong to the gap.
class GapTest {
 public:
  GapTest(const ModelEditor& editor, const Gap& gap, const GridSurface& surface, const ViewCut& cut,
          const OverlapIndex& overlap, std::span<const View> views, const ZipperOptions& options)
      : editor_(editor),
        gap_(gap),
        surface_(surface),
        cut_(cut),
        overlap_(overlap),
        views_(views),
        maxLengthRatio_(options.discontinuityFactor / std::cos(options.breakdownAngle)) {}

  [[nodiscard]] bool fills(const Triangle& t) const {
    if (!continuous(t[0], t[1]) || !continuous(t[1], t[2]) || !continuous(t[2], t[0])) return false;
    const bool ofModel = gap_.ofModel(t[0]);
    const bool joins = ofModel != gap_.ofModel(t[1]) || ofModel != gap_.ofModel(t[2]);
    const PlanePoint place[3] = {gap_.points[t[0]], gap_.points[t[1]], gap_.points[t[2]]};
    return (joins || surface_.at(surface_.centreOf(place)).has_value()) && !overlapsView(place) &&
           !overlap_.overlaps(place);
  }

 private:
  [[nodiscard]] bool continuous(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t u = gap_.vertices[a];
    const std::uint32_t v = gap_.vertices[b];
    const double spacing = std::max({surface_.mesh().spacing, spacingOf(u), spacingOf(v)});
    return (editor_.position(u) - editor_.position(v)).norm() <= maxLengthRatio_ * spacing;
  }
  [[nodiscard]] double spacingOf(std::uint32_t v) const { return views_[editor_.model().vertexView[v]].mesh->spacing; }

  [[nodiscard]] bool overlapsView(const PlanePoint (&t)[3]) const {
    const ViewMesh& view = surface_.mesh();
    const auto [lowX, highX] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [lowY, highY] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto range = surface_.cellsUnder({lowX, lowY}, {highX, highY});
    for (int r = range.firstRow; r <= range.lastRow; ++r)
      for (int c = range.firstColumn; c <= range.lastColumn; ++c)
        for (const std::uint32_t s : surface_.cell(r, c)) {
          if (s == kNoIndex || !cut_.triangleKept[s]) continue;
          const Triangle& v = view.mesh.triangles[s];
          if (trianglesOverlap({surface_.planePoint(view.sample[v[0]]), surface_.planePoint(view.sample[v[1]]),
                                surface_.planePoint(view.sample[v[2]])},
                               t))
            return true;
        }
    return false;
  }

  const ModelEditor& editor_;
  const Gap& gap_;
  const GridSurface& surface_;
  const ViewCut& cut_;
  const OverlapIndex& overlap_;
  std::span<const View> views_;
  double maxLengthRatio_;
};

}  // namespace

Seam stitch(ModelEditor& editor, std::span<const ProjectedVertex> projected, const GridSurface& surface,
            const ViewCut& cut, const OverlapIndex& overlap, std::span<const View> views, std::uint32_t newView,
            const ZipperOptions& options, const Progress& progress) {
  Gap gap(editor, projected, surface, cut, newView);
  gap.addModelBorder();
  progress.checkpoint(0.1);
  Seam seam;
  seam.viewTriangles = gap.addView();
  progress.checkpoint(0.3);
  gap.addViewBorder();
  progress.checkpoint(0.4);

  ConstrainedDelaunay delaunay(gap.points);
  Pace pace(progress, 0.6);
  for (const auto& [a, b] : gap.constraints) {
    pace.step();
    delaunay.constrain(a, b);
  }
  const GapTest test(editor, gap, surface, cut, overlap, views, options);
  for (const Triangle& t : delaunay.triangles()) {
    pace.step();
    if (!test.fills(t)) continue;
    seam.seamTriangles +=
        editor.addTriangle({gap.vertices[t[0]], gap.vertices[t[1]], gap.vertices[t[2]]}, newView) ? 1 : 0;
  }
  seam.vertices = std::move(gap.vertices);
  std::sort(seam.vertices.begin(), seam.vertices.end());
  return seam;
}

}  // namespace vantage
