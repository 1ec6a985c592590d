#include "finishing/finished_model.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "finishing/loose_pieces.h"
#include "geometry/measures.h"
#include "geometry/ray_caster.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 4096;

// A model with vertices and triangles of another: kNoIndex is invented.
Model modelOf(const Model& before, Mesh mesh, const std::vector<std::uint32_t>& vertexOf,
              std::vector<std::uint32_t> triangleView) {
  Model model;
  model.mesh = std::move(mesh);
  model.triangleView = std::move(triangleView);
  for (const std::uint32_t v : vertexOf) {
    const bool invented = v == kNoIndex;
    model.confidence.push_back(invented ? 0.0F : before.confidence[v]);
    model.vertexView.push_back(invented ? kNoIndex : before.vertexView[v]);
    model.vertexSample.push_back(invented ? kNoIndex : before.vertexSample[v]);
  }
  return model;
}

// After steps on vertices: what every vertex was before the first.
void follow(std::vector<std::uint32_t>& vertexOf, const std::vector<std::uint32_t>& step) {
  std::vector<std::uint32_t> followed(step.size());
  for (std::size_t v = 0; v < step.size(); ++v) followed[v] = step[v] == kNoIndex ? kNoIndex : vertexOf[step[v]];
  vertexOf = std::move(followed);
}

class Finisher {
 public:
  Finisher(const Model& model, FinishedModel& result)
      : before_(model), result_(result), mesh_(model.mesh), view_(model.triangleView) {
    vertexOf_.resize(mesh_.vertices.size());
    std::iota(vertexOf_.begin(), vertexOf_.end(), 0U);
  }

  void leaveOut(double largestArea) {
    const std::vector<std::uint8_t> loose = loosePieces(mesh_, largestArea);
    const std::size_t pieces = piecesOf(mesh_).size();
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (loose[t] != 0) {
        result_.areaLeftOut += triangleArea(mesh_, mesh_.triangles[t]);
        continue;
      }
      mesh_.triangles[kept] = mesh_.triangles[t];
      view_[kept++] = view_[t];
    }
    mesh_.triangles.resize(kept);
    view_.resize(kept);
    result_.piecesLeftOut = pieces - piecesOf(mesh_).size();
  }

  void repair(const Progress& progress) {
    RepairedSurface repaired = repairForPrint(mesh_, progress);
    result_.trianglesTurned += repaired.turned;
    mesh_ = std::move(repaired.mesh);
    std::vector<std::uint32_t> view;
    for (const std::uint32_t t : repaired.triangleOf) view.push_back(view_[t]);
    view_ = std::move(view);
    follow(vertexOf_, repaired.vertexOf);
  }

  void close(const HoleClosingOptions& options, const Progress& progress) {
    ClosedMesh closed = closeHoles(mesh_, options, progress);
    std::vector<std::uint32_t> step(closed.firstInventedVertex);
    std::iota(step.begin(), step.end(), 0U);
    step.insert(step.end(), closed.copyOf.begin(), closed.copyOf.end());
    follow(vertexOf_, step);
    mesh_ = std::move(closed.mesh);
    view_.resize(mesh_.triangles.size(), kNoIndex);
    result_.closed = std::move(closed.closed);
    result_.left = std::move(closed.left);
  }

  void simplify(const SimplificationOptions& options, const Progress& progress) {
    SimplifiedMesh coarse = vantage::simplify(mesh_, options, progress.part(0.0, 0.9));
    follow(vertexOf_, coarse.vertexOf);
    view_ = viewsOf(coarse.mesh, progress.part(0.9, 1.0));
    mesh_ = std::move(coarse.mesh);
    coarse.mesh = {};
    result_.simplified = std::move(coarse);
  }

  void end(const Progress& progress) {
    const std::vector<std::uint32_t> place = removeUnusedVertices(mesh_);
    std::size_t kept = 0;
    for (std::size_t v = 0; v < place.size(); ++v)
      if (place[v] != kNoIndex) vertexOf_[kept++] = vertexOf_[v];
    vertexOf_.resize(kept);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      (view_[t] == kNoIndex ? result_.inventedArea : result_.measuredArea) += triangleArea(mesh_, mesh_.triangles[t]);
    result_.check = checkForPrint(mesh_, progress);
    result_.model = modelOf(before_, std::move(mesh_), vertexOf_, std::move(view_));
    result_.vertexOf = std::move(vertexOf_);
  }

 private:
  // Of a coarser mesh: the view of the triangle that is nearest to the centre of each.
  [[nodiscard]] std::vector<std::uint32_t> viewsOf(const Mesh& coarse, const Progress& progress) const {
    const RayCaster fine(mesh_);
    std::vector<std::uint32_t> views(coarse.triangles.size(), kNoIndex);
    parallelChunks(views.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const auto nearest =
            fine.closestPoint(triangleCentre(coarse, coarse.triangles[t]), std::numeric_limits<double>::infinity());
        if (nearest) views[t] = view_[nearest->triangle];
      }
    });
    return views;
  }

  const Model& before_;
  FinishedModel& result_;
  Mesh mesh_;
  std::vector<std::uint32_t> view_;
  std::vector<std::uint32_t> vertexOf_;
};

}  // namespace

std::vector<std::uint8_t> FinishedModel::invented() const {
  std::vector<std::uint8_t> invented(vertexOf.size(), 0);
  for (std::size_t v = 0; v < vertexOf.size(); ++v) invented[v] = vertexOf[v] == kNoIndex ? 1 : 0;
  if (std::find(invented.begin(), invented.end(), 1) == invented.end()) invented.clear();
  return invented;
}

VertexColours FinishedModel::coloursOf(const VertexColours& before) const {
  VertexColours colours;
  if (before.empty()) return colours;
  for (const std::uint32_t v : vertexOf) colours.push_back(v == kNoIndex ? std::nullopt : before[v]);
  return colours;
}

FinishedModel finish(const Model& model, const FinishingOptions& options, const Progress& progress) {
  progress.checkpoint(0.0);
  if (model.mesh.triangles.empty()) throw InvalidInput("the model has no surface");
  if (options.leaveOut && !(*options.leaveOut > 0.0))
    throw InvalidInput("the area of loose pieces that are left out is above 0 mm^2");
  if (options.close && options.close->maxWidth && !(*options.close->maxWidth > 0.0))
    throw InvalidInput("the width of openings that are closed is above 0 mm");
  FinishedModel result;
  Finisher finisher(model, result);
  if (options.leaveOut) finisher.leaveOut(*options.leaveOut);
  if (options.repair) finisher.repair(progress.part(0.0, 0.1));
  if (options.close) finisher.close(*options.close, progress.part(0.1, 0.5, "close openings"));
  if (options.simplify) finisher.simplify(*options.simplify, progress.part(0.5, 0.8, "simplify"));
  // What was open had no inside to be turned to.
  if (options.repair && options.close) finisher.repair(progress.part(0.8, 0.85));
  finisher.end(progress.part(0.85, 1.0, "check"));
  return result;
}

}  // namespace vantage
