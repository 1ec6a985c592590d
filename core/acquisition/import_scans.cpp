#include "acquisition/import_scans.h"

#include <utility>

#include "base/errors.h"

namespace vantage {
namespace {

std::vector<View> makeViews(const std::vector<NumberedScan>& scans, const TriangulationOptions& options,
                            const Progress& progress) {
  std::vector<View> views;
  for (const NumberedScan& scan : scans) {
    progress.checkpoint(static_cast<double>(views.size()) / static_cast<double>(scans.size()));
    View view;
    view.T_object_scanner = scan.image->T_object_scanner;
    view.image = scan.image;
    view.mesh = std::make_shared<const ViewMesh>(triangulate(*view.image, options));
    views.push_back(std::move(view));
  }
  return views;
}

ViewRecord recordOf(std::int64_t scan, const View& view, const ViewAlignment& alignment) {
  ViewRecord record;
  record.scan = scan;
  record.position = view.image->position;
  record.samples = view.image->sampleCount();
  record.triangles = view.mesh->mesh.triangles.size();
  record.registration.T_object_scanner = view.T_object_scanner;
  record.registration.verdict = alignment.verdict;
  record.registration.finding = alignment.finding;
  record.registration.rms = alignment.rms;
  record.registration.inlierShare = alignment.inlierShare;
  return record;
}

// Views that found their place; the others are kept as rejected.
AcquisitionState placedViews(const std::vector<NumberedScan>& scans, std::vector<View> views,
                             const AlignmentResult& alignment) {
  AcquisitionState state;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const bool failed = alignment.views[i].verdict == Verdict::Failed || views[i].mesh->mesh.empty();
    views[i].T_object_scanner = alignment.poses[i];
    ViewRecord record = recordOf(scans[i].number, views[i], alignment.views[i]);
    if (failed) {
      state.rejected.push_back({scans[i].number, views[i].image, record.registration});
    } else {
      state.views.push_back(views[i]);
      state.records.push_back(std::move(record));
    }
  }
  return state;
}

}  // namespace

ImportOptions importOptionsFor(const AcquisitionState& state) {
  ImportOptions options;
  if (!state.profile) return options;
  const StepOptions step = stepOptionsFor(state);
  options.triangulation = step.triangulation;
  options.zipper = step.zipper;
  options.consensus = step.consensus;
  options.voidSpace.breakdownAngle = state.profile->breakdownAngle;
  return options;
}

ImportResult importScans(const std::vector<NumberedScan>& scans, const ImportOptions& options,
                         const Progress& progress) {
  if (scans.empty()) throw InvalidInput("nothing to import: expected at least one range image");
  const Progress registering = progress.part(0.0, 0.6, name(Phase::Register));
  std::vector<View> views = makeViews(scans, options.triangulation, registering.part(0.0, 0.1));
  if (views.front().mesh->mesh.empty())
    throw InvalidInput("the first range image has no surface to register the others with");

  ImportResult result;
  const AlignmentResult alignment = registerViews(views, options.alignment, registering.part(0.1, 1.0));
  result.alignment = alignment.views;
  result.state = placedViews(scans, std::move(views), alignment);

  const Progress integrating = progress.part(0.6, 0.9, name(Phase::Integrate));
  Integration integration = zipper(result.state.views, options.zipper, integrating.part(0.0, 0.8));
  result.zippering = integration.statistics;
  result.state.model = std::make_shared<const Model>(
      applyConsensus(integration.model, result.state.views, options.consensus, integrating.part(0.8, 1.0)));
  result.voids = buildVoidPatches(*result.state.model, result.state.views, options.voidSpace,
                                  progress.part(0.9, 1.0, name(Phase::VoidPatches)));
  result.state.termination = Termination::Finished;
  return result;
}

}  // namespace vantage
