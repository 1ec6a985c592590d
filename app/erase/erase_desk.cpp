#include "erase/erase_desk.h"

#include <limits>
#include <utility>

#include "acquisition/stand_composites.h"

namespace vantage {
namespace {

// What goes, as a mesh of its own.
std::shared_ptr<const Mesh> partOf(const Mesh& mesh, const std::vector<std::uint8_t>& marked) {
  auto part = std::make_shared<Mesh>();
  for (std::size_t t = 0; t < marked.size(); ++t)
    if (marked[t] != 0) part->triangles.push_back(mesh.triangles[t]);
  if (part->triangles.empty()) return nullptr;
  part->vertices = mesh.vertices;
  removeUnusedVertices(*part);
  return part;
}

}  // namespace

Prism lassoOf(const QPolygonF& corners, const Camera& camera, const QSizeF& size) {
  Prism lasso;
  const Vec3 right = camera.right();
  const Vec3 forward = camera.forward();
  lasso.T_region_eye.linear().col(0) = right;
  lasso.T_region_eye.linear().col(1) = right.cross(forward);
  lasso.T_region_eye.linear().col(2) = -forward;
  lasso.T_region_eye.translation() = camera.eye;
  lasso.perspective = true;
  lasso.farthest = std::numeric_limits<double>::infinity();
  const Vec3 up = lasso.T_region_eye.linear().col(1);
  for (const QPointF& corner : corners) {
    const Vec3 direction = sightLine(camera, corner, size).direction;
    const double depth = direction.dot(forward);
    lasso.corners.emplace_back(direction.dot(right) / depth, direction.dot(up) / depth);
  }
  return lasso;
}

EraseDesk::EraseDesk(SessionController& controller, JobRunner& jobs, ModelView& view, QObject* parent)
    : QObject(parent), controller_(controller), jobs_(jobs), view_(view) {
  // What was asked of another model says nothing of this one.
  connect(&controller, &SessionController::shownChanged, this, [this] {
    forget();
    emit modelChanged();
  });
  connect(&controller, &SessionController::activityChanged, this, &EraseDesk::changed);
}

QString EraseDesk::whyNot() const {
  if (!controller_.showsNow()) return tr("An earlier moment is shown: go back to now first.");
  return controller_.permissions().whyNotErase();
}

void EraseDesk::ask(Find find) {
  forget();
  if (!whyNot().isEmpty()) return;
  job_ = jobs_.run<ErasePreview>(
      {},
      [state = controller_.now(), find = std::move(find)](const Progress& progress) {
        ErasePreview preview;
        const std::optional<ErasingRegion> erasing = find(*state);
        if (!erasing) return preview;
        const Erasure erasure = erasureOf(*state, *erasing, progress);
        preview.erasing = *erasing;
        preview.samples = erasure.samples;
        preview.pieces = erasure.pieces;
        preview.area = erasure.area;
        preview.part = partOf(state->model->mesh, erasure.triangles);
        return preview;
      },
      [this, question = question_](JobResult<ErasePreview> result) {
        if (question != question_) return;
        job_ = 0;
        failure_ = result.error;
        if (result.value) {
          preview_ = std::move(*result.value);
          view_.markErasure(preview_->part);
        }
        emit changed();
      });
  emit changed();
}

void EraseDesk::askDrawn(const QPolygonF& corners, bool front) {
  const Prism lasso = lassoOf(corners, view_.camera(), view_.size());
  ask([lasso, front](const AcquisitionState& state) -> std::optional<ErasingRegion> {
    const Pose T_table_object = tableOf(state, state.stand()).inverse();
    Prism onTable = std::get<Prism>(moved(lasso, T_table_object));
    if (front) onTable = frontOf(state, std::move(onTable));
    return ErasingRegion{state.stand(), std::move(onTable), false};
  });
}

void EraseDesk::askBelow(double height) {
  ask([height](const AcquisitionState& state) -> std::optional<ErasingRegion> {
    return ErasingRegion{state.stand(), BelowPlane{Vec3(0.0, 0.0, height), Vec3::UnitZ()}, true};
  });
}

void EraseDesk::askLoosePieces(double largestArea) {
  ask([largestArea](const AcquisitionState& state) -> std::optional<ErasingRegion> {
    auto pieces = loosePiecesRegion(state, largestArea);
    if (!pieces) return std::nullopt;
    return ErasingRegion{state.stand(), *std::move(pieces), false};
  });
}

void EraseDesk::forget() {
  ++question_;
  if (job_ != 0) jobs_.cancel(job_);
  job_ = 0;
  failure_.clear();
  preview_.reset();
  view_.markErasure(nullptr);
  emit changed();
}

void EraseDesk::erase() {
  if (!preview_ || preview_->samples == 0) return;
  const ErasingRegion erasing = preview_->erasing;
  controller_.change(EraseRegion{erasing.stand, erasing.region, erasing.alone});
}

}  // namespace vantage
