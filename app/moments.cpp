#include "moments.h"

#include <QCoreApplication>
#include <variant>

#include "ending_text.h"
#include "wording.h"

namespace vantage {
namespace {

Moment momentOf(const HistoryEntry& entry, bool undone) {
  Moment moment;
  moment.text = commandText(entry.command);
  moment.views = static_cast<int>(countScans(*entry.outline, ScanStatus::In));
  moment.stand = static_cast<int>(entry.outline->stands.size()) - 1;
  moment.outline = entry.outline;
  moment.undone = undone;
  const auto* added = std::get_if<AddScan>(&entry.command);
  if (added == nullptr) return moment;
  moment.scan = added->scan;
  for (const OutlinedScan& scan : entry.outline->scans) {
    if (scan.scan != added->scan) continue;
    moment.rejected = scan.status == ScanStatus::Rejected;
    moment.position = scan.station.position;
    moment.newArea = scan.record ? scan.record->newArea : 0.0;
    if (moment.rejected && scan.record)
      moment.text = failedScanText(added->scan, moment.position, scan.record->registration.finding);
  }
  return moment;
}

}  // namespace

std::vector<Moment> momentsOf(const History& history) {
  std::vector<Moment> moments;
  moments.reserve(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) moments.push_back(momentOf(history.entry(i), i > history.cursor()));
  const bool begun = !moments.empty() && std::holds_alternative<ChangeSettings>(history.entry(0).command);
  if (begun) moments.front().text = QCoreApplication::translate("Moments", "Session begun");
  return moments;
}

}  // namespace vantage
