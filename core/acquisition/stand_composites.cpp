#include "acquisition/stand_composites.h"

#include <algorithm>

#include "acquisition/erased_regions.h"
#include "acquisition/scan_placing.h"

namespace vantage {
namespace {

bool isOf(const AcquisitionState& state, const KeptScan& scan, int composite) {
  return compositeOf(state, scan.station().stand) == composite;
}

std::shared_ptr<const Model> takeModel(std::vector<ModelAside>& aside, int composite) {
  const auto found =
      std::find_if(aside.begin(), aside.end(), [&](const ModelAside& m) { return m.composite == composite; });
  if (found == aside.end()) return nullptr;
  auto model = std::move(found->model);
  aside.erase(found);
  return model;
}

void putModel(std::vector<ModelAside>& aside, int composite, std::shared_ptr<const Model> model) {
  if (!model) return;
  const auto behind =
      std::find_if(aside.begin(), aside.end(), [&](const ModelAside& m) { return m.composite > composite; });
  aside.insert(behind, {composite, std::move(model)});
}

// The composite of the views of the model; nothing without any.
std::optional<int> compositeOfViews(const AcquisitionState& state) {
  for (const KeptScan& scan : state.scans)
    if (scan.status == ScanStatus::In) return compositeOf(state, scan.station().stand);
  return std::nullopt;
}

}  // namespace

int referenceOf(const std::vector<Stand>& stands) {
  const auto known = std::find_if(stands.begin(), stands.end(), [](const Stand& s) { return !!s.T_object_table; });
  return known == stands.end() ? 0 : static_cast<int>(known - stands.begin());
}

bool isOfObject(const AcquisitionState& state, int stand) {
  return state.stands[static_cast<std::size_t>(stand)].T_object_table.has_value();
}

int compositeOf(const AcquisitionState& state, int stand) {
  return isOfObject(state, stand) ? referenceOf(state.stands) : stand;
}

std::optional<Vec3> sideMeant(const AcquisitionState& state, int stand) {
  const Stand& of = state.stands[static_cast<std::size_t>(stand)];
  const auto& toldIn = state.stands[static_cast<std::size_t>(of.reference)].T_object_table;
  if (!of.down || !toldIn) return std::nullopt;
  return toldIn->linear() * *of.down;
}

int compositeInWork(const AcquisitionState& state) {
  return compositeOfViews(state).value_or(compositeOf(state, state.stand()));
}

Pose tableOf(const AcquisitionState& state, int stand) {
  return state.stands[static_cast<std::size_t>(stand)].T_object_table.value_or(Pose::Identity());
}

AcquisitionState withComposite(const AcquisitionState& state, int composite) {
  const std::optional<int> now = compositeOfViews(state);
  if (now == composite) return state;
  AcquisitionState next = state;
  for (KeptScan& scan : next.scans) {
    if (scan.status == ScanStatus::In)
      scan.status = ScanStatus::Aside;
    else if (scan.status == ScanStatus::Aside && isOf(next, scan, composite))
      scan.status = ScanStatus::In;
  }
  if (now) putModel(next.aside, *now, std::move(next.model));
  next.model = takeModel(next.aside, composite);
  next.plan = nullptr;
  return next;
}

AcquisitionState withObject(const AcquisitionState& state) {
  return withComposite(state, referenceOf(state.stands));
}

std::vector<int> standsToAlign(const AcquisitionState& state) {
  std::vector<int> stands;
  for (int stand = 0; stand <= state.stand(); ++stand) {
    const bool hasViews = std::any_of(state.scans.begin(), state.scans.end(), [&](const KeptScan& scan) {
      return (scan.status == ScanStatus::In || scan.status == ScanStatus::Aside) && scan.station().stand == stand;
    });
    if (hasViews && !isOfObject(state, stand)) stands.push_back(stand);
  }
  return stands;
}

Composite compositeForAligner(const AcquisitionState& state, const StepOptions& options) {
  // A holder does not move with the object: of another stand it says nothing.
  const ErasedSpace erased = erasedSpaceOf(state.stands);
  Composite composite{{}, state.model, {}, tiesOf(state, options)};
  for (const View& view : viewsOf(state)) composite.views.push_back(withoutErased(view, erased));
  const int inWork = compositeInWork(state);
  for (int stand = 0; stand <= state.stand(); ++stand) {
    if (compositeOf(state, stand) != inWork) continue;
    const Pose T = tableOf(state, stand);
    const Vec3 up = T.linear().col(2);
    composite.tables.push_back({up, up.dot(T.translation())});
  }
  return composite;
}

}  // namespace vantage
