#include "session/session_states.h"

#include <algorithm>
#include <utility>

#include "acquisition/apply_command.h"
#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "session/state_hash.h"

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

bool hasMesh(ScanStatus status) {
  return status == ScanStatus::In || status == ScanStatus::LeftOut || status == ScanStatus::Aside;
}

// The views of a composite that is set aside, in the order in which its model counts them.
std::vector<View> viewsAside(const AcquisitionState& state, int composite) {
  std::vector<View> views;
  for (const KeptScan& scan : state.scans)
    if (scan.status == ScanStatus::Aside && compositeOf(state, scan.station().stand) == composite)
      views.push_back(scan.view);
  return views;
}

// Whether the patches of a plan lie on a model.
bool fits(const Plan& plan, const Model& model, std::size_t views) {
  return std::all_of(plan.voids->patches.begin(), plan.voids->patches.end(), [&](const VoidPatch& p) {
    return p.from < model.mesh.vertices.size() && p.to < model.mesh.vertices.size() &&
           p.triangle < model.mesh.triangles.size() && p.view < views;
  });
}

// Whether nothing of a state is lost that it had when it was written.
bool isWhole(const AcquisitionState& state, const StateOutline& outline) {
  if (state.scans.size() != outline.scans.size() || (outline.planStep != 0) != (state.plan != nullptr)) return false;
  for (std::size_t i = 0; i < state.scans.size(); ++i)
    if ((outline.scans[i].planStep != 0) != (state.scans[i].record.planAfter != nullptr)) return false;
  return true;
}

// Whether a scan was registered in the same way, and in the same frame.
bool sameRegistration(const RegistrationResult& a, const RegistrationResult& b) {
  return a.verdict == b.verdict && a.T_object_scanner.matrix() == b.T_object_scanner.matrix();
}

}  // namespace

void SessionStates::lose(Loss loss) {
  if (std::find(losses_.begin(), losses_.end(), loss) == losses_.end()) losses_.push_back(std::move(loss));
}

std::shared_ptr<const ScannerProfile> SessionStates::parsed(const std::optional<ProfileSource>& source) {
  return source ? std::make_shared<const ScannerProfile>(parseProfile(*source)) : nullptr;
}

void SessionStates::dropImpossible(StoredHistory& history) {
  for (std::size_t i = history.entries.size(); i-- > 0;) {
    const StateOutline& outline = *history.entries[i].outline;
    const auto known = [&](const OutlinedScan& scan) {
      return exists(scan.station.position) && scan.station.stand >= 0 &&
             scan.station.stand < static_cast<int>(outline.stands.size());
    };
    if (exists(outline.chosenPosition) && std::all_of(outline.scans.begin(), outline.scans.end(), known)) continue;
    lose({LossKind::StepImpossible, history.entries[i].step, {}, {}});
    history.entries.erase(history.entries.begin() + static_cast<std::ptrdiff_t>(i));
    if (history.cursor > 0 && history.cursor >= i) --history.cursor;
  }
}

bool SessionStates::exists(std::optional<int> position) const {
  return !position || (profile_ && *position >= 0 && *position < static_cast<int>(profile_->workspace.size()));
}

std::shared_ptr<const RayGrid> SessionStates::raysOf(std::int64_t id) {
  if (id == 0) return profile_ ? profile_->rays : nullptr;
  std::shared_ptr<const RayGrid> rays = rays_[id].lock();
  if (!rays) rays_[id] = rays = std::make_shared<const RayGrid>(store_.rays(id));
  return rays;
}

std::shared_ptr<const RangeImage> SessionStates::scan(std::int64_t number) {
  if (auto image = scans_[number].lock()) return image;
  const std::string what = store_.path() + ": scan " + std::to_string(number);
  const std::shared_ptr<const RayGrid> rays = raysOf(store_.raysOf(number));
  if (!rays) throw InvalidInput(what + " has no rays: the profile is missing");
  RangeImage image = store_.scan(number, rays->size());
  image.rays = rays;
  if (!exists(image.station.position))
    throw InvalidInput(what + " is damaged: its position " + std::to_string(*image.station.position) +
                       " does not exist");
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
  if (!exists(image.station.position))
    throw InvalidInput(store_.path() + ": a scan of position " + std::to_string(*image.station.position) +
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
                   std::all_of(model->triangleView.begin(), model->triangleView.end(), known))) {
      lose({LossKind::ModelOfOtherViews, step, {}, {}});
      return nullptr;
    }
    models_[step] = model;
    return model;
  } catch (const InvalidInput& e) {
    lose({LossKind::ModelDamaged, step, {}, e.what()});
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
    if (plan && !fits(*plan)) {
      lose({LossKind::PlanOfOtherPositions, step, {}, {}});
      return nullptr;
    }
    plans_[step] = plan;
    return plan;
  } catch (const InvalidInput& e) {
    lose({LossKind::PlanDamaged, step, {}, e.what()});
    return nullptr;
  }
}

UsedImage SessionStates::used(std::int64_t number, const ScanUse& use, const Progress& progress) {
  KnownUse& known = uses_[number];
  UsedImage used = known.rest;
  used.image = known.image.lock();
  if (used.image && known.cut == use.cut.options && known.thinning == use.thinning) return used;
  used = usedImage(scan(number), use, thinnedRays_.lock(), progress);
  if (used.everyNth > 1) thinnedRays_ = used.image->rays;
  known = {use.cut.options, use.thinning, used.image, {nullptr, used.cut, used.samples, used.everyNth}};
  return used;
}

std::vector<View> SessionStates::piecesOf(const StateOutline& outline, const StepOptions& options) {
  std::vector<View> pieces;
  std::vector<std::int64_t> scans;
  for (const OutlinedScan& o : outline.scans) {
    if (!hasMesh(o.status) || meshes_[o.scan].mesh.lock()) continue;
    const auto share = [&](std::size_t i) {
      return 0.5 * static_cast<double>(i) / static_cast<double>(outline.scans.size());
    };
    const Progress one = progress_.part(share(scans.size()), share(scans.size() + 1));
    one.checkpoint(0.0);
    try {
      pieces.push_back({used(o.scan, {options.cut, options.thinning}, one).image, nullptr});
      scans.push_back(o.scan);
    } catch (const InvalidInput&) {
      // It is named when the scan is looked for.
    }
  }
  parallelChunks(scans.size(), 1, progress_.part(0.5, 1.0), [&](std::size_t i, std::size_t) {
    pieces[i].mesh = std::make_shared<const ViewMesh>(
        triangulate(*pieces[i].image, options.triangulation, progress_.part(0.5, 0.5).withThreads(1)));
  });
  for (std::size_t i = 0; i < scans.size(); ++i) meshes_[scans[i]] = {pieces[i].image, pieces[i].mesh};
  return pieces;
}

std::shared_ptr<const ViewMesh> SessionStates::meshOf(std::int64_t scan, const std::shared_ptr<const RangeImage>& image,
                                                      const TriangulationOptions& triangulation) {
  KnownMesh& known = meshes_[scan];
  if (auto mesh = known.mesh.lock(); mesh && known.image.lock() == image) return mesh;
  auto mesh = std::make_shared<const ViewMesh>(triangulate(*image, triangulation));
  known = {image, mesh};
  return mesh;
}

std::optional<KeptScan> SessionStates::keptScan(const OutlinedScan& outlined, const StepOptions& options) {
  try {
    KeptScan kept{outlined.scan, outlined.status, {}, *outlined.record};
    const UsedImage used = this->used(outlined.scan, {options.cut, options.thinning}, progress_.part(0.5, 0.5));
    kept.view.image = used.image;
    kept.record.cut = used.cut;
    kept.record.everyNth = used.everyNth;
    kept.view.T_object_scanner = outlined.T_object_scanner;
    if (hasMesh(outlined.status)) kept.view.mesh = meshOf(outlined.scan, kept.view.image, options.triangulation);
    kept.record.planAfter = plan(outlined.planStep);
    return kept;
  } catch (const InvalidInput& e) {
    lose({LossKind::ScanDamaged, outlined.scan, {}, e.what()});
    return std::nullopt;
  }
}

AcquisitionState SessionStates::state(const History& history, const HistoryEntry& entry) {
  AcquisitionState state = assembled(history, entry);
  if (entry.hash && isWhole(state, *entry.outline) && stateHash(state) != *entry.hash) {
    auto again = replayed(state, history, entry);
    const bool right = again && stateHash(*again) == *entry.hash;
    lose({right ? LossKind::StateMadeAgain : LossKind::StateUntrue, entry.step, {}, {}});
    if (right) {
      state = std::move(*again);
      models_[entry.outline->modelStep] = state.model;
    }
  }
  if (state.plan && !vantage::fits(*state.plan, *state.model, countScans(state, ScanStatus::In))) state.plan = nullptr;
  return state;
}

// What the command of an entry leads to from the state before it, with the plans that were kept.
std::optional<AcquisitionState> SessionStates::replayed(const AcquisitionState& state, const History& history,
                                                        const HistoryEntry& entry) {
  std::size_t i = 1;
  while (i < history.size() && history.entry(i).step != entry.step) ++i;
  if (i >= history.size()) return std::nullopt;
  try {
    const std::shared_ptr<const AcquisitionState> before = history.state(i - 1);
    const CommandInput input{[&](std::int64_t number) { return scan(number); }, nullptr};
    AcquisitionState after = applyCommand(*before, entry.command, input, progress_);
    if (after.scans.size() != state.scans.size()) return std::nullopt;
    after.plan = state.plan;
    after.termination = state.termination;
    for (std::size_t k = 0; k < after.scans.size(); ++k)
      after.scans[k].record.planAfter = state.scans[k].record.planAfter;
    return after;
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

AcquisitionState SessionStates::assembled(const History& history, const HistoryEntry& entry) {
  const StateOutline& outline = *entry.outline;
  AcquisitionState state;
  state.profile = profile_;
  state.settings = outline.settings;
  state.mode = outline.mode;
  state.stands = outline.stands;
  state.termination = outline.termination;
  state.chosenPosition = outline.chosenPosition;
  if (profile_)
    state.settings.firstView = std::min(state.settings.firstView, static_cast<int>(profile_->workspace.size()) - 1);
  const StepOptions options = stepOptionsFor(state);
  const std::vector<View> pieces = piecesOf(outline, options);
  for (const OutlinedScan& o : outline.scans)
    if (auto kept = keptScan(o, options)) state.scans.push_back(std::move(*kept));

  const bool whole = state.scans.size() == outline.scans.size();
  for (const OutlinedModel& aside : outline.aside)
    if (const auto views = viewsAside(state, aside.composite); !views.empty())
      state.aside.push_back({aside.composite, whole ? modelOf(state, aside.composite, history, aside.step)
                                                    : integrateViews(views, state.stands, options, progress_)});
  const std::vector<View> views = viewsOf(state);
  if (views.empty()) return state;
  const bool wholeModel = views.size() == countScans(outline, ScanStatus::In);
  state.model = wholeModel ? modelOf(state, compositeInWork(state), history, outline.modelStep)
                           : integrateViews(views, state.stands, stepOptionsFor(state), progress_);
  const auto held = plan(outline.planStep);
  if (held && wholeModel) state.plan = held;
  return state;
}

std::shared_ptr<const Model> SessionStates::modelOf(const AcquisitionState& state, int composite,
                                                    const History& history, std::int64_t step) {
  const bool inWork = composite == compositeInWork(state);
  const std::vector<View> views = inWork ? viewsOf(state) : viewsAside(state, composite);
  if (auto kept = model(step, views.size())) {
    if (vantage::fits(*kept, views)) return kept;
    lose({LossKind::ModelOfOtherSamples, step, {}, {}});
  }
  auto made = replayedModel(views, composite, history, step);
  if (!made) made = integrateViews(views, state.stands, stepOptionsFor(state), progress_);
  models_[step] = made;
  return made;
}

// Made as it was made the first time, by the command of its step on the state before; null where that is not known.
std::shared_ptr<const Model> SessionStates::replayedModel(const std::vector<View>& views, int composite,
                                                          const History& history, std::int64_t step) {
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history.entry(i).step != step) continue;
    try {
      const std::shared_ptr<const AcquisitionState> before = history.state(i - 1);
      const CommandInput input{[&](std::int64_t number) { return scan(number); }, nullptr};
      const AcquisitionState after = applyCommand(*before, history.entry(i).command, input, progress_);
      const auto made = withComposite(after, composite).model;
      if (made && vantage::fits(*made, views)) return made;
    } catch (const InvalidInput&) {
      // Then not.
    }
  }
  return nullptr;
}

// Says which steps made the record of a scan and the plan after it. A record is written again where a scan that waited
// was placed, where later scans have settled a verdict, and where the object's frame is another one.
void SessionStates::findSteps(OutlinedScan& scan, bool planned, const StateOutline& before, std::int64_t step) {
  const auto old = std::find_if(before.scans.begin(), before.scans.end(),
                                [&](const OutlinedScan& o) { return o.scan == scan.scan; });
  const bool known =
      old != before.scans.end() && (old->status != ScanStatus::Waiting || scan.status == ScanStatus::Waiting);
  const bool unchanged = known && sameRegistration(old->record->registration, scan.record->registration);
  if (unchanged) scan.record = old->record;
  scan.recordStep = unchanged ? old->recordStep : step;
  scan.planStep = !planned ? 0 : known ? old->planStep : step;
}

// The step that made a model: one of those that the state before had, else the one that is made now.
std::int64_t SessionStates::stepOf(const std::shared_ptr<const Model>& model, const StateOutline& before,
                                   std::int64_t step) const {
  if (!model) return 0;
  const auto made = [&](std::int64_t known) {
    const auto held = models_.find(known);
    return held != models_.end() && held->second.lock() == model;
  };
  if (before.modelStep != 0 && made(before.modelStep)) return before.modelStep;
  for (const OutlinedModel& aside : before.aside)
    if (made(aside.step)) return aside.step;
  return step;
}

StateOutline SessionStates::outline(const AcquisitionState& state, const StateOutline& before, std::int64_t step) {
  StateOutline outline = outlineOf(state);
  for (std::size_t i = 0; i < state.scans.size(); ++i)
    findSteps(outline.scans[i], state.scans[i].record.planAfter != nullptr, before, step);
  const bool samePlan = before.planStep != 0 && plans_[before.planStep].lock() == state.plan;
  outline.planStep = !state.plan ? 0 : samePlan ? before.planStep : step;
  outline.modelStep = stepOf(state.model, before, step);
  for (std::size_t i = 0; i < state.aside.size(); ++i)
    outline.aside[i].step = stepOf(state.aside[i].model, before, step);
  return outline;
}

void SessionStates::remember(const StateOutline& outline, const AcquisitionState& state) {
  for (const KeptScan& scan : state.scans) {
    uses_[scan.number] = {state.settings.cut,
                          state.settings.thinning,
                          scan.view.image,
                          {nullptr, scan.record.cut, scan.record.samples, scan.record.everyNth}};
    if (scan.record.everyNth > 1) thinnedRays_ = scan.view.image->rays;
    if (scan.view.mesh) meshes_[scan.number] = {scan.view.image, scan.view.mesh};
  }
  models_[outline.modelStep] = state.model;
  for (std::size_t i = 0; i < state.aside.size(); ++i) models_[outline.aside[i].step] = state.aside[i].model;
  if (state.plan) plans_[outline.planStep] = state.plan;
}

}  // namespace vantage
