#include "session_views.h"

#include <QEvent>
#include <algorithm>

#include "acquisition/steps.h"
#include "planning/choice.h"
#include "views/geometry_loader.h"

namespace vantage {
namespace {

// What the views of positional space need besides the state; costs about as much as planning did.
struct PlanPictures {
  std::shared_ptr<const PlanImages> images;
  std::shared_ptr<const PositionalLinks> links;
};

PlanPictures computePictures(const ViewSnapshot& snapshot, const Progress& progress) {
  const AcquisitionState& state = *snapshot.state;
  const PlanningScene scene(planInputOf(state), snapshot.plan->voids, stepOptionsFor(state).planner,
                            progress.part(0.0, 0.4));
  PlanPictures pictures;
  pictures.images =
      std::make_shared<const PlanImages>(computePlanImages(scene, *snapshot.scannerImages, progress.part(0.4, 0.9)));
  pictures.links = std::make_shared<const PositionalLinks>(*snapshot.scannerImages, *pictures.images);
  return pictures;
}

// The next position; when nothing comes next, what would, or the one that comes nearest to it; none without a plan.
std::optional<int> positionToExplain(const ViewSnapshot& snapshot) {
  if (!snapshot.plan) return std::nullopt;
  if (snapshot.proposed()) return snapshot.proposed();
  if (snapshot.further) return snapshot.further;
  const std::vector<PositionScore>& scores = snapshot.plan->scores;
  const auto best = std::max_element(scores.begin(), scores.end(), [](const PositionScore& a, const PositionScore& b) {
    return promise(a) < promise(b);
  });
  if (best == scores.end()) return std::nullopt;
  return best->position;
}

}  // namespace

SessionViews::SessionViews(SessionController& controller, PositionInspector& inspector, JobRunner& jobs,
                           const SurfaceMaker& surfaces, QObject* parent)
    : QObject(parent),
      controller_(controller),
      inspector_(inspector),
      jobs_(jobs),
      geometries_(std::make_shared<GeometryStore>()),
      model_(new ModelPane(surfaces, geometries_)),
      space_(new PositionalPane(surfaces, geometries_)),
      map_(new UnrolledMapView),
      objective_(new ObjectiveView) {
  for (QWidget* watched : {static_cast<QWidget*>(space_), static_cast<QWidget*>(map_)})
    watched->installEventFilter(this);
  connectViews();
}

void SessionViews::connectViews() {
  connect(&controller_, &SessionController::shownChanged, this, &SessionViews::refresh);
  connect(&controller_, &SessionController::setUpChanged, this, &SessionViews::refresh);
  connect(&controller_, &SessionController::activityChanged, this, &SessionViews::requestImages);
  connect(space_, &PositionalPane::optionsChanged, map_, &UnrolledMapView::setOptions);
  connect(&space_->view(), &PositionalSpaceView::cellPicked, this, &SessionViews::pickCell);
  connect(&space_->view(), &PositionalSpaceView::cellHovered, map_, &UnrolledMapView::pointAt);
  connect(map_, &UnrolledMapView::cellPicked, this, &SessionViews::pickCell);
  connect(&model_->view(), &ModelView::patchPicked, this, &SessionViews::pickPatch);
  connect(&model_->view(), &ModelView::nothingPicked, this, [this] {
    model_->view().highlight({});
    space_->view().highlightCells({});
    map_->highlightCells({});
  });
  connect(model_, &ModelPane::noticeClicked, &controller_, &SessionController::showNow);
  connect(objective_, &ObjectiveView::positionPicked, this, &SessionViews::examine);
}

// Images of positional space are only computed while somebody looks at them.
bool SessionViews::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show) requestImages();
  return QObject::eventFilter(watched, event);
}

void SessionViews::refresh() {
  jobs_.cancel(imagesJob_);
  imagesJob_ = 0;
  ++question_;
  links_.reset();
  const SharedState& state = controller_.shown();
  const SharedSetUp& setUp = controller_.setUp();
  auto before = std::make_shared<AcquisitionState>();
  if (!state && setUp) before->profile = setUp->profile;
  auto snapshot =
      std::make_shared<ViewSnapshot>(*makeSnapshot(state ? state : before, setUp ? setUp->images : nullptr));
  if (controller_.showsNow()) snapshot->table = controller_.present().tablePosition();
  if (!state || state->scans.empty()) {
    if (setUp && setUp->object) snapshot->expected = setUp->object->mesh;
    if (controller_.showsNow()) snapshot->next = controller_.present().nextPosition();
  }
  showSnapshot(snapshot);
  model_->setNotice(controller_.showsNow() ? QString()
                                           : tr("This is the session as it was after view %1. Back to now")
                                                 .arg(state ? countScans(*state, ScanStatus::In) : 0));
  requestImages();
  examine(positionToExplain(*snapshot_));
  if (!snapshot_->proposed()) model_->view().examine(std::nullopt);
}

void SessionViews::showSnapshot(const SharedSnapshot& snapshot) {
  snapshot_ = snapshot;
  model_->setSnapshot(snapshot);
  space_->view().setSnapshot(snapshot);
  map_->setSnapshot(snapshot);
  objective_->setSnapshot(snapshot);
}

// While an acquisition runs the processors are its own.
void SessionViews::requestImages() {
  const bool wanted = space_->isVisible() || map_->isVisible();
  if (!wanted || imagesJob_ != 0 || !controller_.idle() || !snapshot_ || !snapshot_->plan || !snapshot_->plan->voids ||
      !snapshot_->scannerImages || snapshot_->planImages || snapshot_->model() == nullptr)
    return;
  imagesJob_ = jobs_.run<PlanPictures>(
      {}, [snapshot = snapshot_](const Progress& progress) { return computePictures(*snapshot, progress); },
      [this, question = question_](JobResult<PlanPictures> result) {
        if (question != question_) return;
        if (!result.value) return;
        auto complete = std::make_shared<ViewSnapshot>(*snapshot_);
        complete->planImages = result.value->images;
        links_ = result.value->links;
        showSnapshot(complete);
      });
}

void SessionViews::pickCell(const MapCell& picked) {
  if (!snapshot_ || !snapshot_->scannerImages) return;
  const auto cell = static_cast<std::uint32_t>(picked.row * snapshot_->scannerImages->grid().columns() + picked.column);
  space_->view().highlightCells({cell});
  map_->highlightCells({cell});
  if (links_) model_->view().highlight(links_->patchesThrough(cell));
}

void SessionViews::pickPatch(std::uint32_t patch) {
  model_->view().highlight({patch});
  if (!links_) return;
  const std::vector<std::uint32_t> cells = links_->cellsOf(patch);
  space_->view().highlightCells(cells);
  map_->highlightCells(cells);
}

void SessionViews::showScan(std::optional<std::int64_t> scan) {
  std::optional<std::uint32_t> view;
  std::optional<int> position;
  if (scan && snapshot_ && snapshot_->state) {
    const std::vector<const KeptScan*> in = scansOf(*snapshot_->state, ScanStatus::In);
    for (std::size_t i = 0; i < in.size(); ++i)
      if (in[i]->number == *scan) view = static_cast<std::uint32_t>(i);
    if (const KeptScan* kept = findScan(*snapshot_->state, *scan);
        kept != nullptr && kept->station().stand == snapshot_->state->stand())
      position = kept->station().position;
  }
  model_->view().markView(view);
  if (position) examine(position);
}

void SessionViews::showEdges(EdgeReason reason) {
  if (!snapshot_ || !snapshot_->plan) return;
  std::vector<std::uint32_t> patches;
  const std::vector<PatchOutlook>& outlook = snapshot_->plan->outlook;
  for (std::size_t patch = 0; patch < outlook.size(); ++patch)
    if (outlook[patch].reason == reason) patches.push_back(static_cast<std::uint32_t>(patch));
  model_->view().highlight(patches);
}

void SessionViews::examine(std::optional<int> position) {
  if (position && snapshot_)
    inspector_.inspect(snapshot_->state, *position);
  else
    inspector_.forget();
  objective_->examine(position);
  space_->setPosition(position);
  const bool asked = snapshot_ && position != snapshot_->proposed();
  model_->view().examine(asked ? position : std::nullopt);
  if (position) emit positionExamined(*position);
}

void SessionViews::setTheme(const Theme& theme) {
  model_->view().setTheme(theme);
  space_->view().setTheme(theme);
  map_->setTheme(theme);
  objective_->setTheme(theme);
}

void SessionViews::setNavigation(NavigationScheme scheme) {
  model_->view().setNavigation(scheme);
  space_->view().setNavigation(scheme);
}

}  // namespace vantage
