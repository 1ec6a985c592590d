#include "acquisition/import_scans.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

// Differences from the list of poses up to so many spacings are what a list always has.
constexpr double kListFaultSpacings = 2.0;

std::vector<KeptScan> keptScans(const std::vector<NumberedScan>& scans, const ImportOptions& options,
                                const Progress& progress) {
  std::vector<KeptScan> kept;
  for (const NumberedScan& scan : scans) {
    const double done = static_cast<double>(kept.size()) / static_cast<double>(scans.size());
    const double then = static_cast<double>(kept.size() + 1) / static_cast<double>(scans.size());
    kept.push_back(keepAsView(scan, {options.cut, options.thinning}, options.triangulation, raysOfLast(kept),
                              progress.part(done, then)));
  }
  return kept;
}

std::vector<View> viewsOf(const std::vector<KeptScan>& scans) {
  std::vector<View> views;
  views.reserve(scans.size());
  for (const KeptScan& scan : scans) views.push_back(scan.view);
  return views;
}

// What the alignment found of one scan.
void enter(KeptScan& scan, const Pose& T_object_scanner, const ViewAlignment& alignment) {
  const bool failed = alignment.verdict == Verdict::Failed || scan.view.mesh->mesh.empty();
  scan.status = failed ? ScanStatus::Rejected : ScanStatus::In;
  scan.view.T_object_scanner = T_object_scanner;
  if (failed) scan.view.mesh = nullptr;
  RegistrationResult& registration = scan.record.registration;
  registration.T_object_scanner = T_object_scanner;
  registration.verdict = alignment.verdict;
  registration.finding = alignment.finding;
  registration.rms = alignment.rms;
  registration.inlierShare = alignment.inlierShare;
}

}  // namespace

std::optional<PoseListFinding> poseListFault(const AcquisitionState& state) {
  std::vector<Pose> given;
  std::vector<Pose> found;
  double spacing = 0.0;
  for (const KeptScan& scan : state.scans) {
    if (scan.status != ScanStatus::In || scan.view.image->poseKnownBy == PoseSource::Unknown) continue;
    given.push_back(scan.view.image->T_table_scanner);
    found.push_back(scan.view.T_object_scanner);
    spacing = std::max(spacing, scan.view.mesh->spacing);
  }
  return commonFault(given, found, kListFaultSpacings * spacing);
}

AcquisitionState importScans(const AcquisitionState& state, const std::vector<NumberedScan>& scans,
                             const ImportOptions& options, const Progress& progress) {
  if (scans.empty()) throw InvalidInput("nothing to import: expected at least one range image");
  const Progress registering = progress.part(0.0, 0.6, name(Phase::Register));
  AcquisitionState next = state;
  next.scans = keptScans(scans, options, registering.part(0.0, 0.1));
  if (next.scans.front().view.mesh->mesh.empty())
    throw InvalidInput("the first range image has no surface to register the others with");
  const AlignmentResult alignment = registerViews(viewsOf(next.scans), options.alignment, registering.part(0.1, 1.0));
  for (std::size_t i = 0; i < next.scans.size(); ++i) enter(next.scans[i], alignment.poses[i], alignment.views[i]);

  const Progress integrating = progress.part(0.6, 1.0, name(Phase::Integrate));
  const std::vector<View> views = vantage::viewsOf(next);
  const Integration integration = zipper(views, options.zipper, integrating.part(0.0, 0.8));
  next.model = std::make_shared<const Model>(
      applyConsensus(integration.model, views, options.consensus, integrating.part(0.8, 1.0)));
  next.termination = Termination::Imported;
  return next;
}

}  // namespace vantage
