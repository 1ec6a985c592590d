#include "acquisition/stand_merging.h"

#include <algorithm>
#include <utility>

#include "acquisition/scan_placing.h"
#include "acquisition/stand_composites.h"
#include "acquisition/steps.h"
#include "geometry/measures.h"

namespace vantage {
namespace {

// A scan moves with the frame that its pose is in, and so does where it was registered.
void moveBy(KeptScan& scan, const Pose& T_new_old) {
  scan.view.T_object_scanner = T_new_old * scan.view.T_object_scanner;
  scan.record.registration.T_object_scanner = T_new_old * scan.record.registration.T_object_scanner;
}

// What an alignment says of the other of the two. How far the surfaces agree it says of both already.
StandAlignment seenFromOther(StandAlignment alignment) {
  for (StandPose& pose : alignment.candidates) pose.T_object_stand = pose.T_object_stand.inverse();
  return alignment;
}

// A stand that came before the reference is the reference from now on: what was found when the two were aligned is
// said of the one that was it before.
void handOverReference(AcquisitionState& state, int before, int now) {
  auto& alignment = state.stands[static_cast<std::size_t>(now)].alignment;
  if (alignment)
    state.stands[static_cast<std::size_t>(before)].alignment =
        std::make_shared<const StandAlignment>(seenFromOther(*alignment));
  alignment = nullptr;
}

// The object in the frame of the table in a stand that is known.
void expressIn(AcquisitionState& state, int stand) {
  const Pose T_new_old = state.stands[static_cast<std::size_t>(stand)].T_object_table->inverse();
  for (KeptScan& scan : state.scans)
    if (isOfObject(state, scan.station().stand) && scan.status != ScanStatus::Waiting) moveBy(scan, T_new_old);
  for (Stand& each : state.stands)
    if (each.T_object_table) each.T_object_table = T_new_old * *each.T_object_table;
  state.stands[static_cast<std::size_t>(stand)].T_object_table = Pose::Identity();
}

// The views of a stand that is set aside become views of the object. @return which scans they are
std::vector<std::size_t> takeIn(AcquisitionState& state, int stand, const Pose& T_object_table) {
  std::vector<std::size_t> views;
  for (std::size_t i = 0; i < state.scans.size(); ++i) {
    KeptScan& scan = state.scans[i];
    if (scan.station().stand != stand || scan.status == ScanStatus::Waiting) continue;
    moveBy(scan, T_object_table);
    if (scan.status != ScanStatus::Aside) continue;
    scan.status = ScanStatus::In;
    views.push_back(i);
  }
  state.stands[static_cast<std::size_t>(stand)].T_object_table = T_object_table;
  std::erase_if(state.aside, [&](const ModelAside& m) { return m.composite == stand; });
  return views;
}

// Where an aligner has the views: those of the object first.
void moveTo(AcquisitionState& state, const std::vector<std::size_t>& ofStand, const std::vector<Pose>& poses) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < state.scans.size(); ++i)
    if (state.scans[i].status == ScanStatus::In && !std::binary_search(ofStand.begin(), ofStand.end(), i))
      order.push_back(i);
  order.insert(order.end(), ofStand.begin(), ofStand.end());
  if (order.size() != poses.size()) return;
  for (std::size_t i = 0; i < order.size(); ++i) state.scans[order[i]].view.T_object_scanner = poses[i];
}

// Whether there is more of the object now to look for the place of a scan.
bool isToPlace(const KeptScan& scan, int stand) {
  return scan.station().stand == stand && (scan.status == ScanStatus::Waiting || scan.status == ScanStatus::Rejected);
}

// Looks for the place of the scans of a stand that have none: those that waited, and those that did not fit before.
void placeOthers(AcquisitionState& state, int stand, const StepOptions& options, const Progress& progress) {
  const auto count = static_cast<double>(std::count_if(state.scans.begin(), state.scans.end(),
                                                       [&](const KeptScan& scan) { return isToPlace(scan, stand); }));
  double done = 0.0;
  for (KeptScan& scan : state.scans) {
    if (!isToPlace(scan, stand)) continue;
    const Progress part = progress.part(done / count, (done + 1.0) / count);
    done += 1.0;
    KeptScan placed = scan;
    placed.view.mesh = std::make_shared<const ViewMesh>(triangulate(*scan.view.image, options.triangulation, part));
    if (placed.view.mesh->mesh.empty() && scan.status == ScanStatus::Rejected) continue;
    const bool found = findPlace(state, placed, options, part.part(0.0, 0.3, name(Phase::Register)));
    // What was known of one that fits no better stays.
    if (found || scan.status == ScanStatus::Waiting) scan = std::move(placed);
    if (!found) continue;
    const double before = state.model ? area(state.model->mesh) : 0.0;
    refineModelViews(state, options, part.part(0.3, 0.5, name(Phase::Register)));
    state.model = integrateViews(viewsOf(state), state.stands, options, part.part(0.5, 1.0));
    scan.record.newArea = std::max(0.0, area(state.model->mesh) - before);
    scan.record.overlapArea = std::max(0.0, area(scan.view.mesh->mesh) - scan.record.newArea);
  }
}

}  // namespace

AcquisitionState mergedStand(const AcquisitionState& state, int stand, const Pose& T_object_table,
                             const std::vector<Pose>& poses, const StepOptions& options, const Progress& progress) {
  AcquisitionState next = withObject(state);
  const int reference = referenceOf(next.stands);
  const std::vector<std::size_t> views = takeIn(next, stand, T_object_table);
  next.plan = nullptr;
  if (!views.empty()) {
    // The table of the stand goes where its first view goes.
    const Pose before = next.scans[views.front()].view.T_object_scanner;
    if (poses.empty())
      refineModelViews(next, options, progress.part(0.0, 0.4, name(Phase::Register)));
    else
      moveTo(next, views, poses);
    const Pose& after = next.scans[views.front()].view.T_object_scanner;
    if (after.matrix() != before.matrix())
      next.stands[static_cast<std::size_t>(stand)].T_object_table = after * before.inverse() * T_object_table;
  }
  if (referenceOf(next.stands) != reference) {
    handOverReference(next, reference, stand);
    expressIn(next, stand);
  }
  if (!views.empty()) next.model = integrateViews(viewsOf(next), next.stands, options, progress.part(0.4, 0.7));
  placeOthers(next, stand, options, progress.part(0.7, 1.0));
  return withComposite(next, compositeOf(next, next.stand()));
}

}  // namespace vantage
