#include "scenes/model_scene.h"

#include <vtkPolyData.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

#include "acquisition/stand_composites.h"
#include "scanner/table_turn.h"
#include "scenes/camera_marks.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ModelView)
};

const char* edgeClassText(EdgeClass edgeClass) {
  switch (edgeClass) {
    case EdgeClass::OuterJump:
      return QT_TRANSLATE_NOOP("ModelView", "edge against the background");
    case EdgeClass::InnerJump:
      return QT_TRANSLATE_NOOP("ModelView", "hidden behind the object");
    case EdgeClass::LineOfSightJump:
      return QT_TRANSLATE_NOOP("ModelView", "light or camera blocked");
    case EdgeClass::Regular:
      return QT_TRANSLATE_NOOP("ModelView", "open border");
    case EdgeClass::Rim:
      break;
  }
  return QT_TRANSLATE_NOOP("ModelView", "rim of the scan");
}

const char* stateText(PatchState state) {
  switch (state) {
    case PatchState::Open:
      return QT_TRANSLATE_NOOP("ModelView", "open");
    case PatchState::LookedAt:
      return QT_TRANSLATE_NOOP("ModelView", "looked at, still open");
    case PatchState::Answered:
      return QT_TRANSLATE_NOOP("ModelView", "answered: no surface found");
    case PatchState::OutOfReach:
      return QT_TRANSLATE_NOOP("ModelView", "out of reach");
    case PatchState::TooSteep:
      return QT_TRANSLATE_NOOP("ModelView", "too steep");
    case PatchState::LightBlocked:
      return QT_TRANSLATE_NOOP("ModelView", "light blocked");
    case PatchState::ReceiverBlocked:
      return QT_TRANSLATE_NOOP("ModelView", "receiver blocked");
    case PatchState::Erased:
      return QT_TRANSLATE_NOOP("ModelView", "erased: not the object");
    case PatchState::TooLittle:
      break;
  }
  return QT_TRANSLATE_NOOP("ModelView", "too little for a view");
}

KeyLegend edgeClassLegend(const VoidSurface& voids) {
  KeyLegend legend{Text::tr("Unseen edges by kind"), {}};
  for (std::size_t k = 0; k < kEdgeClasses; ++k) {
    const auto edgeClass = static_cast<EdgeClass>(k);
    if (voids.counts[k] == 0) continue;
    legend.entries.push_back({toColour(edgeClassColour(edgeClass)),
                              QStringLiteral("%1  %2").arg(Text::tr(edgeClassText(edgeClass))).arg(voids.counts[k])});
  }
  return legend;
}

KeyLegend stateLegend(const Plan& plan) {
  std::array<std::size_t, kPatchStates> counts{};
  for (const PatchOutlook& outlook : plan.outlook)
    ++counts[static_cast<std::size_t>(patchState(outlook, plan.outcome))];
  KeyLegend legend{Text::tr("Unseen edges by state"), {}};
  for (std::size_t k = 0; k < kPatchStates; ++k) {
    const auto state = static_cast<PatchState>(k);
    if (counts[k] == 0) continue;
    legend.entries.push_back(
        {toColour(patchStateColour(state)), QStringLiteral("%1  %2").arg(Text::tr(stateText(state))).arg(counts[k])});
  }
  return legend;
}

KeyLegend viewLegend(const std::vector<View>& views) {
  constexpr std::size_t kMostEntries = 16;
  KeyLegend legend{Text::tr("Surface by view"), {}};
  for (std::size_t v = 0; v < std::min(views.size(), kMostEntries); ++v) {
    const std::optional<int> position = views[v].image->station.position;
    legend.entries.push_back({toColour(viewColour(v)), position
                                                           ? Text::tr("view %1, position %2").arg(v + 1).arg(*position)
                                                           : Text::tr("view %1").arg(v + 1)});
  }
  if (views.size() > kMostEntries)
    legend.entries.push_back({Qt::transparent, Text::tr("and %1 more").arg(views.size() - kMostEntries)});
  return legend;
}

KeyLegend standLegend(const std::vector<View>& views) {
  std::map<int, int> counts;
  for (const int stand : standsOf(views)) ++counts[stand];
  KeyLegend legend{Text::tr("Surface by stand"), {}};
  for (const auto& [stand, count] : counts)
    legend.entries.push_back(
        {toColour(standColour(stand)),
         count == 1 ? Text::tr("stand %1, 1 view").arg(stand) : Text::tr("stand %1, %2 views").arg(stand).arg(count)});
  return legend;
}

// What the grey of a model is whose scans saw colours only here and there; nothing to say where they did everywhere.
std::optional<KeyLegend> coloursLegend(const VertexColours& colours) {
  if (countColourless(colours) == 0) return std::nullopt;
  return KeyLegend{Text::tr("Surface in its colours"), {{toColour(kGrey), Text::tr("no colour was measured")}}};
}

QString voidPatchesText(std::size_t count) {
  return count == 1 ? Text::tr("1 unseen edge")
                    : Text::tr("%1 unseen edges").arg(shortNumber(static_cast<double>(count)));
}

QString titleOf(std::size_t views, int composite, bool isObject) {
  if (!isObject)
    return views == 1 ? Text::tr("Stand %1 alone after 1 view").arg(composite)
                      : Text::tr("Stand %1 alone after %2 views").arg(composite).arg(views);
  return views == 1 ? Text::tr("Model after 1 view") : Text::tr("Model after %1 views").arg(views);
}

double areaOf(const VoidSurface& voids) {
  double sum = 0.0;
  for (const VoidPatch& patch : voids.patches) sum += patch.weight;
  return sum;
}

}  // namespace

ModelScene::ModelScene()
    : turntable_(scene_),
      setUp_(scene_),
      model_(scene_),
      viewMark_(scene_),
      erasure_(scene_),
      voids_(scene_),
      currentRays_(scene_),
      proposedRays_(scene_),
      measure_(scene_),
      theme_(&lightTheme()) {
  setTheme(lightTheme());
  erasure_.setColour(patchStateColour(PatchState::Erased));
}

void ModelScene::set(SharedSnapshot snapshot, std::shared_ptr<const ModelGeometry> geometry) {
  snapshot_ = std::move(snapshot);
  geometry_ = std::move(geometry);
  turntable_.set(snapshot_ ? snapshot_->profile() : nullptr);
  markedView_.reset();
  viewMark_.set(geometry_, {});
  markErasure(nullptr);
  const bool before = isBefore();
  setUp_.set(before ? snapshot_->profile() : nullptr, before ? snapshot_->expected : nullptr);
  update();
}

void ModelScene::setOptions(const ModelViewOptions& options) {
  options_ = options;
  update();
}

void ModelScene::setTheme(const Theme& theme) {
  theme_ = &theme;
  scene_.setTheme(theme);
  turntable_.setTheme(theme);
  setUp_.setTheme(theme);
  viewMark_.setTheme(theme);
  model_.setTheme(theme);
  voids_.setTheme(theme);
  measure_.setTheme(theme);
  currentRays_.setColour(theme.current);
  proposedRays_.setColour(examined_ ? theme.examined : theme.proposed);
}

void ModelScene::examine(std::optional<int> position) {
  examined_ = position;
  updateRays();
}

void ModelScene::markView(std::optional<std::uint32_t> view) {
  markedView_ = view;
  viewMark_.set(geometry_, view);
}

void ModelScene::markErasure(const std::shared_ptr<const Mesh>& part) {
  marksErasure_ = part && !part->empty();
  erasure_.setPart(part);
}

void ModelScene::highlight(const std::vector<std::uint32_t>& patches) {
  voids_.highlight(patches);
}

ModelColouring ModelScene::colouring() const {
  const ModelColouring wanted =
      geometry_ ? geometry_->shown(options_.colouring) : options_.colouring.value_or(ModelColouring::Plain);
  const bool isOne = wanted == ModelColouring::Stand && !(snapshot_ && haveStands(snapshot_->views));
  return isOne ? ModelColouring::Plain : wanted;
}

void ModelScene::update() {
  model_.set(geometry_, colouring(), snapshot_ ? standsOf(snapshot_->views) : std::vector<int>());
  model_.setVisible(options_.surface, options_.boundary);
  model_.setStyle(options_.style, options_.backFaces);
  model_.setSection(options_.section);
  voids_.setSection(options_.section);
  voids_.set(snapshot_ ? snapshot_->plan : nullptr, options_.voidColouring);
  voids_.setVisible(options_.voidPatches);
  turntable_.setVisible(options_.turntable);
  updateRays();
}

void ModelScene::updateRays() {
  currentRays_.clear();
  proposedRays_.clear();
  proposedRays_.setColour(examined_ ? theme_->examined : theme_->proposed);
  const ScannerProfile* profile = snapshot_ ? snapshot_->profile() : nullptr;
  if (profile == nullptr) return turntable_.mark({}, {});
  const auto azimuth = [&](std::optional<int> position) -> std::optional<double> {
    if (!position || *position >= static_cast<int>(profile->workspace.size())) return std::nullopt;
    return azimuthOf(*profile, profile->workspace.poses[static_cast<std::size_t>(*position)]);
  };
  const std::optional<int> asked = examined_ ? examined_ : snapshot_->proposed();
  turntable_.mark(azimuth(snapshot_->current()), azimuth(snapshot_->proposed()));
  if (options_.currentRays && !snapshot_->views.empty()) currentRays_.showView(*profile, snapshot_->views.back());
  if (asked && (options_.proposedRays || examined_ || isBefore()))
    proposedRays_.showPosition(*profile, *asked, geometry_ ? geometry_->caster.get() : nullptr);
}

bool ModelScene::isBefore() const {
  return snapshot_ && snapshot_->profile() != nullptr && !geometry_ && snapshot_->state &&
         snapshot_->state->scans.empty();
}

// A box whose corners lie on the disc: its sides reach into the corners of a picture of it.
BoundingBox ModelScene::everything() const {
  const ScannerProfile* profile = snapshot_ ? snapshot_->profile() : nullptr;
  const double radius = profile != nullptr ? 0.95 * profile->viewingVolume.radius : 100.0;
  BoundingBox box = geometry_ ? geometry_->box : BoundingBox{Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.3 * radius)};
  box.extend({-radius, -radius, 0.0});
  box.extend({radius, radius, 0.0});
  if (!isBefore()) return box;
  box.extend({0.0, 0.0, profile->viewingVolume.height});
  if (snapshot_->expected)
    for (const Vec3& v : snapshot_->expected->vertices) box.extend(v);
  if (const auto eye = scannersEye(snapshot_.get(), snapshot_->proposed())) box.extend(*eye);
  return box;
}

BoundingBox ModelScene::box() const {
  return geometry_ ? geometry_->box : everything();
}

Camera ModelScene::camera(CameraPreset preset, double aspect) const {
  const std::optional<int> position = examined_ ? examined_ : (snapshot_ ? snapshot_->foremost() : std::nullopt);
  return presetCamera(preset, preset == CameraPreset::Everything ? everything() : box(), scene_.camera(),
                      scannersEye(snapshot_.get(), position), aspect);
}

Overlay ModelScene::overlay() const {
  Overlay overlay;
  if (!snapshot_ || !snapshot_->state) return overlay;
  const auto& state = *snapshot_->state;
  const std::vector<View>& views = snapshot_->views;
  const int composite = compositeInWork(state);
  const bool isObject = composite == referenceOf(state.stands);
  if (isBefore()) {
    overlay.notes << Text::tr("Before the first scan");
    if (snapshot_->proposed()) overlay.notes << Text::tr("The scanner at position %1").arg(*snapshot_->proposed());
    overlay.notes << (snapshot_->expected ? Text::tr("The simulated object and the viewing volume")
                                          : Text::tr("The viewing volume"));
    return overlay;
  }
  if (views.empty()) {
    overlay.notes << (isObject ? Text::tr("No view taken yet")
                               : Text::tr("No view of stand %1 taken yet").arg(composite));
    if (!state.aside.empty()) overlay.notes << Text::tr("The object is set aside meanwhile");
    return overlay;
  }
  overlay.notes << titleOf(views.size(), composite, isObject);
  if (!isObject) overlay.notes << Text::tr("Not put together with the object yet");
  if (state.model)
    overlay.notes << Text::tr("%1 triangles").arg(shortNumber(static_cast<double>(state.model->mesh.triangles.size())));
  if (snapshot_->plan && snapshot_->plan->voids)
    overlay.notes << Text::tr("%1, %2 mm²")
                         .arg(voidPatchesText(snapshot_->plan->voids->patches.size()),
                              shortNumber(areaOf(*snapshot_->plan->voids)));
  if (!options_.legends) return overlay;
  if (options_.voidPatches && snapshot_->plan && snapshot_->plan->voids && !snapshot_->plan->voids->patches.empty())
    overlay.legends.emplace_back(options_.voidColouring == VoidColouring::State
                                     ? stateLegend(*snapshot_->plan)
                                     : edgeClassLegend(*snapshot_->plan->voids));
  if (options_.surface && colouring() == ModelColouring::Confidence)
    overlay.legends.emplace_back(
        ScaleLegend{Text::tr("Confidence"), Text::tr("(1: seen head-on)"), 0.0, 1.0, ColourMap::Cividis});
  if (options_.surface && colouring() == ModelColouring::View) overlay.legends.emplace_back(viewLegend(views));
  if (options_.surface && colouring() == ModelColouring::Stand) overlay.legends.emplace_back(standLegend(views));
  if (options_.surface && colouring() == ModelColouring::Colours && geometry_)
    if (const auto legend = coloursLegend(geometry_->colours)) overlay.legends.emplace_back(*legend);
  if (options_.surface && colouring() == ModelColouring::Age)
    overlay.legends.emplace_back(ScaleLegend{Text::tr("Surface by age"), Text::tr("view"), 1.0,
                                             static_cast<double>(views.size()), ColourMap::Viridis});
  KeyLegend rays{Text::tr("Ranging rays"), {}};
  const std::optional<int> last = views.back().image->station.position;
  if (options_.currentRays && last)
    rays.entries.push_back({theme_->current, Text::tr("last view, position %1").arg(*last)});
  if (examined_)
    rays.entries.push_back({theme_->examined, Text::tr("examined position %1").arg(*examined_)});
  else if (options_.proposedRays && snapshot_->proposed())
    rays.entries.push_back({theme_->proposed, (snapshot_->operatorsChoice ? Text::tr("your choice, position %1")
                                                                          : Text::tr("proposed view, position %1"))
                                                  .arg(*snapshot_->proposed())});
  if (!rays.entries.empty()) overlay.legends.emplace_back(rays);
  KeyLegend marks{Text::tr("Marks"), {}};
  if (options_.boundary && geometry_ && geometry_->boundary)
    marks.entries.push_back({theme_->boundary, Text::tr("border of the model")});
  if (markedView_ && *markedView_ < views.size())
    marks.entries.push_back({theme_->examined, Text::tr("what the chosen scan brought")});
  if (marksErasure_)
    marks.entries.push_back({toColour(patchStateColour(PatchState::Erased)), Text::tr("what would be erased")});
  if (options_.turntable && snapshot_->current())
    marks.entries.push_back(
        {theme_->current, Text::tr("where the scanner stands, position %1").arg(*snapshot_->current())});
  if (options_.turntable && snapshot_->proposed())
    marks.entries.push_back({theme_->proposed, Text::tr("where it is next, position %1").arg(*snapshot_->proposed())});
  if (!marks.entries.empty()) overlay.legends.emplace_back(marks);
  return overlay;
}

std::optional<ModelScene::Pick> ModelScene::pick(const SightLine& line) const {
  const auto patch = voids_.pick(line);
  const auto surface = pickSurface(line);
  // Patches begin on the surface's border: in a draw they are what is meant.
  constexpr double kDraw = 0.5;
  const auto distanceOf = [&](const Pick& pick) { return (pick.point - line.origin).norm(); };
  if (patch && (!surface || patch->distance < distanceOf(*surface) + kDraw))
    return Pick{patch->patch, {}, line.origin + patch->distance * line.direction};
  return surface;
}

// What is cut away is passed through.
std::optional<ModelScene::Pick> ModelScene::pickSurface(const SightLine& line) const {
  if (!geometry_ || !geometry_->caster || !options_.surface) return std::nullopt;
  constexpr double kBehind = 1e-3;  // [mm]
  constexpr int kMostLayers = 256;
  SightLine rest = line;
  for (int layer = 0; layer < kMostLayers; ++layer) {
    const auto hit = geometry_->caster->intersect(rest.origin, rest.direction);
    if (!hit) return std::nullopt;
    const Vec3 point = rest.origin + hit->distance * rest.direction;
    if (!options_.section || !options_.section->hides(point)) return Pick{{}, hit->triangle, point};
    rest.origin = point + kBehind * rest.direction;
  }
  return std::nullopt;
}

void ModelScene::setMeasured(const std::vector<Vec3>& places) {
  constexpr double kShare = 0.012;  // of what there is to look at
  measure_.set(places, kShare * box().size().norm());
}

QImage makePicture(Scene& scene, const Overlay& overlay, const Theme& theme, OffscreenWindow& window, const QSize& size,
                   double pixelRatio) {
  QImage image = window.render(scene, scene.camera(), size, pixelRatio);
  QPainter painter(&image);
  const QRectF area(QPointF(), QSizeF(size) / pixelRatio);
  paintCameraMarks(painter, area, scene.camera(), theme);
  paintOverlay(painter, area, overlay, theme);
  return image;
}

Camera presetCamera(CameraPreset preset, const BoundingBox& box, const Camera& now, const std::optional<Vec3>& eye,
                    double aspect) {
  switch (preset) {
    case CameraPreset::Fit:
    case CameraPreset::Everything:
      return cameraToward(now.forward(), box, aspect);
    case CameraPreset::Front:
      return cameraToward(-Vec3::UnitX(), box, aspect);
    case CameraPreset::Top:
      return cameraToward(-Vec3::UnitZ(), box, aspect);
    case CameraPreset::ScannersEye:
      if (eye) {
        Camera camera = cameraToward(box.centre() - *eye, box, aspect);
        camera.eye = *eye;
        // From where it stands the scanner may be too near to have all of it in sight.
        const double reach = 0.5 * box.size().norm();
        camera.viewAngle = std::clamp(2.0 * std::atan(reach / std::max(1.0, (box.centre() - *eye).norm())),
                                      radians(10.0), radians(100.0));
        return camera;
      }
      return cameraToward(-Vec3::UnitX(), box, aspect);
    case CameraPreset::Oblique:
      break;
  }
  return cameraToward(Vec3(-1.0, 0.55, -0.55), box, aspect);
}

std::optional<Vec3> scannersEye(const ViewSnapshot* snapshot, std::optional<int> position) {
  const ScannerProfile* profile = snapshot != nullptr ? snapshot->profile() : nullptr;
  if (profile == nullptr || !position || *position >= static_cast<int>(profile->workspace.size())) return std::nullopt;
  return scannerPlace(*profile, profile->workspace.poses[static_cast<std::size_t>(*position)]);
}

}  // namespace vantage
