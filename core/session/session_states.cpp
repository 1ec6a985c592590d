#include "session/session_states.h"

#include <algorithm>
#include <utility>

#include "acquisition/apply_command.h"
#include "acquisition/steps.h"
#include "base/errors.h"

namespace vantage {
namespace {

// Whether a model's provenance names views and samples that are there.
bool fits(const Model& model, const std::vector<View>& views) {
  for (std::size_t v = 0; v < model.vertexView.size(); ++v)
    if (model.vertexView[v] >= views.size() || model.vertexSample[v] >= views[model.vertexView[v]].image->range.size())
      return false;
  return std::all_of(model.triangleView.begin(), model.triangleView.end(),
                     [&](std::uint32_t view) { return view < views.size(); });
}

// Whether the patches of a plan lie on a model.
bool fits(const Plan& plan, const Model& model, std::size_t views) {
  return std::all_of(plan.voids->patches.begin(), plan.voids->patches.end(), [&](const VoidPatch& p) {
    return p.from < model.mesh.vertices.size() && p.to < model.mesh.vertices.size() &&
           p.triangle < model.mesh.triangles.size() && p.view < views;
  });
}

}  // namespace

void SessionStates::lose(const std::string& sentence) {
  if (std::find(losses_.begin(), losses_.end(), sentence) == losses_.end()) losses_.push_back(sentence);
}

std::shared_ptr<const ScannerProfile> SessionStates::parsed(const std::optional<ProfileSource>& source) {
  return source ? std::make_shared<const ScannerProfile>(parseProfile(*source)) : nullptr;
}

void SessionStates::dropImpossible(StoredHistory& history) {
  const auto known = [&](const OutlinedView& view) {
    return view.record->position >= -1 && exists(view.record->position);
  };
  for (std::size_t i = history.entries.size(); i-- > 0;) {
    const StateOutline& outline = *history.entries[i].outline;
    bool possible = exists(outline.chosenPosition);
    for (const auto* list : {&outline.views, &outline.rejected, &outline.leftOut})
      possible = possible && std::all_of(list->begin(), list->end(), known);
    if (possible) continue;
    lose(store_.path() + ": step " + std::to_string(history.entries[i].step) + " is lost: it names no position");
    history.entries.erase(history.entries.begin() + static_cast<std::ptrdiff_t>(i));
    if (history.cursor > 0 && history.cursor >= i) --history.cursor;
  }
}

bool SessionStates::exists(int position) const {
  return position < 0 || (profile_ && position < static_cast<int>(profile_->workspace.size()));
}

std::shared_ptr<const RayGrid> SessionStates::raysOf(std::int64_t id) {
  if (id == 0) return profile_ ? profile_->rays : nullptr;
  std::shared_ptr<const RayGrid> rays = rays_[id].lock();
  if (!rays) rays_[id] = rays = std::make_shared<const RayGrid>(store_.rays(id));
  return rays;
}

std::shared_ptr<const RangeImage> SessionStates::scan(std::int64_t number) {
  if (auto image = scans_[number].lock()) return image;
  auto [image, rays] = store_.scan(number);
  const std::string what = store_.path() + ": scan " + std::to_string(number);
  image.rays = raysOf(rays);
  if (!image.rays) throw InvalidInput(what + " has no rays: the profile is missing");
  if (!exists(image.position))
    throw InvalidInput(what + " is damaged: its position " + std::to_string(image.position) + " does not exist");
  try {
    validate(image);
  } catch (const InvalidInput& e) {
    throw InvalidInput(what + " is damaged: " + e.what());
  }
  auto shared = std::make_shared<const RangeImage>(std::move(image));
  scans_[number] = shared;
  return shared;
}

StoredScan SessionStates::keep(const RangeImage& image) {
  if (!exists(image.position))
    throw InvalidInput(store_.path() + ": a scan of position " + std::to_string(image.position) +
                       ", which does not exist");
  StoredScan scan;
  if (!profile_ || image.rays != profile_->rays) {
    const auto known =
        std::find_if(rays_.begin(), rays_.end(), [&](const auto& r) { return r.second.lock() == image.rays; });
    scan.rays = known == rays_.end() ? store_.addRays(*image.rays) : known->first;
  }
  scan.number = store_.addScan(image, scan.rays);
  return scan;
}

void SessionStates::remember(const StoredScan& scan, const std::shared_ptr<const RangeImage>& image) {
  if (scan.rays != 0) rays_[scan.rays] = image->rays;
  scans_[scan.number] = image;
}

std::shared_ptr<const Model> SessionStates::model(std::int64_t step, std::size_t views) {
  if (auto model = models_[step].lock()) return model;
  try {
    auto model = store_.model(step);
    const auto known = [&](std::uint32_t view) { return view < views; };
    if (model && !(std::all_of(model->vertexView.begin(), model->vertexView.end(), known) &&
                   std::all_of(model->triangleView.begin(), model->triangleView.end(), known)))
      throw InvalidInput(store_.path() + ": model " + std::to_string(step) + " is of other views");
    models_[step] = model;
    return model;
  } catch (const InvalidInput& e) {
    lose(std::string(e.what()) + "; it is made again");
    return nullptr;
  }
}

bool SessionStates::fits(const Plan& plan) const {
  return profile_ && plan.scores.size() == profile_->workspace.size();
}

std::shared_ptr<const Plan> SessionStates::plan(std::int64_t step) {
  if (step == 0) return nullptr;
  if (auto plan = plans_[step].lock()) return plan;
  try {
    auto plan = store_.plan(step);
    if (plan && !fits(*plan))
      throw InvalidInput(store_.path() + ": plan " + std::to_string(step) + " is of other positions");
    plans_[step] = plan;
    return plan;
  } catch (const InvalidInput& e) {
    lose(e.what());
    return nullptr;
  }
}

std::shared_ptr<const ViewMesh> SessionStates::meshOf(std::int64_t scan, const RangeImage& image,
                                                      const TriangulationOptions& triangulation) {
  if (auto mesh = meshes_[scan].lock()) return mesh;
  auto mesh = std::make_shared<const ViewMesh>(triangulate(image, triangulation));
  meshes_[scan] = mesh;
  return mesh;
}

std::optional<LeftOutView> SessionStates::viewOf(const OutlinedView& outlined,
                                                 const TriangulationOptions& triangulation) {
  try {
    LeftOutView found;
    found.view.image = scan(outlined.scan);
    found.view.mesh = meshOf(outlined.scan, *found.view.image, triangulation);
    found.view.T_object_scanner = outlined.T_object_scanner;
    found.record = *outlined.record;
    found.record.position = found.view.image->position;
    found.record.plan = plan(outlined.planStep);
    return found;
  } catch (const InvalidInput& e) {
    lose(e.what());
    return std::nullopt;
  }
}

void SessionStates::addViews(AcquisitionState& state, const StateOutline& outline) {
  const TriangulationOptions triangulation = stepOptionsFor(state).triangulation;
  for (const OutlinedView& o : outline.views) {
    auto found = viewOf(o, triangulation);
    if (!found) continue;
    state.views.push_back(std::move(found->view));
    state.records.push_back(std::move(found->record));
  }
  for (const OutlinedView& o : outline.leftOut)
    if (auto found = viewOf(o, triangulation)) state.leftOut.push_back(std::move(*found));
  for (const OutlinedView& o : outline.rejected)
    if (auto found = viewOf(o, triangulation))
      state.rejected.push_back({o.scan, found->view.image, o.record->registration});
}

AcquisitionState SessionStates::state(const History& history, const HistoryEntry& entry) {
  const StateOutline& outline = *entry.outline;
  AcquisitionState state;
  state.profile = profile_;
  state.settings = outline.settings;
  state.termination = outline.termination;
  state.chosenPosition = outline.chosenPosition;
  if (profile_)
    state.settings.firstView = std::min(state.settings.firstView, static_cast<int>(profile_->workspace.size()) - 1);
  addViews(state, outline);
  if (state.views.empty()) return state;

  const bool whole = state.views.size() == outline.views.size();
  state.model = whole ? modelOf(state, history, entry) : integrateViews(state.views, stepOptionsFor(state), {});
  std::shared_ptr<const Plan>& last = state.records.back().plan;
  if (last && (!whole || !vantage::fits(*last, *state.model, state.views.size()))) last = nullptr;
  return state;
}

std::shared_ptr<const Model> SessionStates::modelOf(const AcquisitionState& state, const History& history,
                                                    const HistoryEntry& entry) {
  const std::int64_t step = entry.outline->modelStep;
  if (auto kept = model(step, state.views.size())) {
    if (vantage::fits(*kept, state.views)) return kept;
    lose(store_.path() + ": model " + std::to_string(step) + " is of other samples; it is made again");
  }
  auto made = replayedModel(state, history, step);
  models_[step] = made;
  return made;
}

// Made as it was made the first time, by the command of its step on the state before; only where that is not known
// anew, of all views.
std::shared_ptr<const Model> SessionStates::replayedModel(const AcquisitionState& state, const History& history,
                                                          std::int64_t step) {
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history.entry(i).step != step) continue;
    try {
      const std::shared_ptr<const AcquisitionState> before = history.state(i - 1);
      const CommandInput input{[&](std::int64_t number) { return scan(number); }, nullptr};
      const AcquisitionState after = applyCommand(*before, history.entry(i).command, input, {});
      if (after.model && vantage::fits(*after.model, state.views)) return after.model;
    } catch (const InvalidInput&) {
      // Then not.
    }
  }
  return integrateViews(state.views, stepOptionsFor(state), {});
}

OutlinedView SessionStates::outlined(const ViewRecord& record, const Pose& pose, const StateOutline& before,
                                     std::int64_t step) {
  OutlinedView view{record.scan, pose, nullptr, step, 0};
  for (const auto* list : {&before.views, &before.rejected, &before.leftOut}) {
    const auto old = std::find_if(list->begin(), list->end(), [&](const auto& v) { return v.scan == record.scan; });
    if (old == list->end()) continue;
    view.record = old->record;
    view.recordStep = old->recordStep;
    view.planStep = record.plan ? old->planStep : 0;
    return view;
  }
  auto kept = std::make_shared<ViewRecord>(record);
  kept->plan = nullptr;
  view.record = std::move(kept);
  return view;
}

StateOutline SessionStates::outline(const AcquisitionState& state, const StateOutline& before, std::int64_t step) {
  StateOutline outline;
  outline.settings = state.settings;
  outline.chosenPosition = state.chosenPosition;
  outline.termination = state.termination;
  for (std::size_t i = 0; i < state.views.size(); ++i)
    outline.views.push_back(outlined(state.records[i], state.views[i].T_object_scanner, before, step));
  for (const LeftOutView& v : state.leftOut)
    outline.leftOut.push_back(outlined(v.record, v.view.T_object_scanner, before, step));
  for (const RejectedScan& scan : state.rejected) {
    ViewRecord record;
    record.scan = scan.scan;
    record.position = scan.image->position;
    record.samples = scan.image->sampleCount();
    record.registration = scan.registration;
    outline.rejected.push_back(outlined(record, scan.image->T_object_scanner, before, step));
  }
  // Only the last view's plan can be a new one.
  if (const auto plan = currentPlan(state)) {
    OutlinedView& last = outline.views.back();
    if (last.planStep == 0 || plans_[last.planStep].lock() != plan) last.planStep = step;
  }
  const bool sameModel = before.modelStep != 0 && models_[before.modelStep].lock() == state.model;
  outline.modelStep = !state.model ? 0 : sameModel ? before.modelStep : step;
  return outline;
}

void SessionStates::remember(const StateOutline& outline, const AcquisitionState& state) {
  for (std::size_t i = 0; i < state.views.size(); ++i) {
    scans_[outline.views[i].scan] = state.views[i].image;
    meshes_[outline.views[i].scan] = state.views[i].mesh;
  }
  models_[outline.modelStep] = state.model;
  if (const auto plan = currentPlan(state)) plans_[outline.views.back().planStep] = plan;
}

}  // namespace vantage
