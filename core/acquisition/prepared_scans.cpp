#include "acquisition/prepared_scans.h"

#include <optional>
#include <utility>

#include "base/parallel.h"

namespace vantage {
namespace {

bool isPrepared(const KeptScan& scan) {
  return scan.prepared && scan.prepared->mesh == scan.view.mesh && scan.prepared->image == scan.view.image;
}

}  // namespace

void prepareScans(AcquisitionState& state, KeptScan& added, const Progress& progress) {
  std::vector<KeptScan*> open;
  for (KeptScan& scan : state.scans)
    if (scan.status == ScanStatus::In && !isPrepared(scan)) open.push_back(&scan);
  if (!isPrepared(added)) open.push_back(&added);
  parallelChunks(open.size(), 1, progress,
                 [&](std::size_t i, std::size_t) { open[i]->prepared.emplace(open[i]->view); });
}

std::vector<PreparedView> preparedViews(const std::vector<const KeptScan*>& scans, const Progress& progress) {
  std::vector<View> views;
  views.reserve(scans.size());
  for (const KeptScan* scan : scans) views.push_back(scan->view);
  return preparedViews(scans, views, progress);
}

std::vector<PreparedView> preparedViews(const std::vector<const KeptScan*>& scans, const std::vector<View>& views,
                                        const Progress& progress) {
  std::vector<std::optional<PreparedView>> slots(scans.size());
  parallelChunks(scans.size(), 1, progress, [&](std::size_t i, std::size_t) {
    if (isPrepared(*scans[i]) && views[i].mesh == scans[i]->view.mesh)
      slots[i] = scans[i]->prepared;
    else
      slots[i].emplace(views[i]);
  });
  std::vector<PreparedView> prepared;
  prepared.reserve(slots.size());
  for (auto& slot : slots) prepared.push_back(*std::move(slot));
  return prepared;
}

}  // namespace vantage
