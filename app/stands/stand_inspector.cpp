#include "stands/stand_inspector.h"

#include <QPointer>
#include <utility>

#include "scenes/composite_scene.h"
#include "scenes/model_scene.h"
#include "scenes/ray_picture.h"

namespace vantage {
namespace {

constexpr QSize kPictureSize(132, 100);

std::shared_ptr<const ModelGeometry> geometryOf(const CompositeModel& model, const Progress& progress) {
  const auto geometry = prepareModelGeometry(model.composite().model, progress.part(0.0, 0.4));
  return withStandIn(geometry, {}, progress.part(0.4, 1.0));
}

ComparedStand compared(const AcquisitionState& state, int stand, const Progress& progress) {
  ComparedStand result;
  result.comparison = std::make_shared<const StandComparison>(compareStand(state, stand, progress.part(0.0, 0.6)));
  result.object = geometryOf(result.comparison->object, progress.part(0.6, 0.8));
  result.stand = geometryOf(result.comparison->composite, progress.part(0.8, 1.0));
  return result;
}

// The surface of a composite by what its vertices are to the other.
PicturedSurface pictured(const CompositeModel& model, const Pose& T, const std::vector<PlaceWord>& words,
                         const Rgb& plain) {
  const Mesh& mesh = model.composite().model->mesh;
  return {&model.caster(), T, [&mesh, &words, plain](std::uint32_t triangle) {
            return placeColour(words[mesh.triangles[triangle][0]]).value_or(plain);
          }};
}

}  // namespace

QImage posePicture(const StandComparison& comparison, const Pose& T_object_stand, const PosePlaces& places,
                   const QSize& size, const Theme& theme, const Progress& progress) {
  BoundingBox box = boundingBox(comparison.object.composite().model->mesh);
  for (const Vec3& p : comparison.composite.composite().model->mesh.vertices) box.extend(T_object_stand * p);
  const Camera camera =
      presetCamera(CameraPreset::Oblique, box, {}, std::nullopt, static_cast<double>(size.width()) / size.height());
  const std::vector<PicturedSurface> surfaces{
      pictured(comparison.object, Pose::Identity(), places.reference, objectColour(theme)),
      pictured(comparison.composite, T_object_stand, places.moved, standSurfaceColour(theme))};
  return rayPicture(surfaces, camera, size, theme, progress);
}

StandInspector::StandInspector(JobRunner& jobs, QObject* parent) : QObject(parent), jobs_(jobs) {}

StandInspector::~StandInspector() {
  stop();
}

void StandInspector::stop() {
  ++question_;
  for (JobRunner::Id* job : {&loading_, &looking_})
    if (*job != 0) jobs_.cancel(std::exchange(*job, 0));
}

void StandInspector::load(const std::shared_ptr<const AcquisitionState>& state, int stand) {
  stop();
  stand_ = {};
  looks_.clear();
  const QPointer<StandInspector> self(this);
  const int question = question_;
  loading_ = -1;
  const JobRunner::Id job = jobs_.run<ComparedStand>(
      tr("Comparing stand %1 with the object").arg(stand),
      [state, stand](const Progress& progress) { return compared(*state, stand, progress); },
      [self, question](JobResult<ComparedStand> result) {
        if (!self || self->question_ != question) return;
        self->loading_ = 0;
        if (result.value) {
          self->stand_ = std::move(*result.value);
          emit self->loaded();
        } else {
          emit self->failed(result.cancelled ? tr("Stopped. Open this window again to look at the stand.")
                                             : result.error);
        }
        emit self->ended();
      });
  if (loading_ == -1) loading_ = job;
}

void StandInspector::lookAt(const std::vector<Pose>& poses, const Theme& theme) {
  if (!stand_.comparison) return;
  ++question_;
  if (looking_ != 0) jobs_.cancel(std::exchange(looking_, 0));
  looks_.assign(poses.size(), {});
  if (poses.empty()) return;
  const QPointer<StandInspector> self(this);
  const int question = question_;
  // On the UI thread, while the job goes on.
  const auto tell = [self, question](std::size_t pose, PoseLook look) {
    if (!self || self->question_ != question) return;
    self->looks_[pose] = std::move(look);
    emit self->looked(static_cast<int>(pose));
  };
  looking_ = -1;
  const JobRunner::Id job = jobs_.run<bool>(
      tr("Looking at the poses"),
      [runner = &jobs_, comparison = stand_.comparison, poses, tell, &theme](const Progress& progress) {
        for (std::size_t i = 0; i < poses.size(); ++i) {
          const auto count = static_cast<double>(poses.size());
          const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
          PoseLook look;
          look.places = std::make_shared<const PosePlaces>(comparison->placesAt(poses[i], part.part(0.0, 0.8)));
          look.picture = posePicture(*comparison, poses[i], *look.places, kPictureSize, theme, part.part(0.8, 1.0));
          QMetaObject::invokeMethod(runner, [tell, i, look = std::move(look)]() mutable { tell(i, std::move(look)); });
        }
        return true;
      },
      [self, question](const JobResult<bool>& result) {
        if (!self || self->question_ != question) return;
        self->looking_ = 0;
        if (!result.error.isEmpty()) emit self->failed(result.error);
        emit self->ended();
      });
  if (looking_ == -1) looking_ = job;
}

}  // namespace vantage
