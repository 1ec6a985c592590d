#include "ending_text.h"

#include <QCoreApplication>

#include "acquisition/further_scan.h"
#include "planning/choice.h"
#include "report/wording.h"
#include "why_card.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Ending)
};

// What a further view would show.
QString stillShown(const AcquisitionState& state) {
  const auto further = furtherScan(state);
  if (!further || !further->predicted) return {};
  return Text::tr(" Position %1 would still show %2.")
      .arg(QString::number(further->position), areaText(promise(*further->predicted)));
}

// What an operator can do about a scan that did not fit.
QString remedy(const AcquisitionState& state) {
  const auto next = nextPosition(state);
  const auto failed = state.scans.back().station().position;
  if (!failed) return {};
  if (!next) return Text::tr("If the table stood wrong, turn it to position %1 and take that once more.").arg(*failed);
  return Text::tr("If the table stood wrong, take position %1 once more; else go on from position %2.")
      .arg(QString::number(*failed), QString::number(*next));
}

}  // namespace

QString endingText(const AcquisitionState& state) {
  if (state.termination == Termination::Finished && !state.plan)
    return Text::tr("Ended: the views that were asked for are taken.");
  const bool running = state.termination == Termination::Running;
  return terminationText(state.termination) + (running ? QString() : stillShown(state));
}

QString failedScanText(std::int64_t number, std::optional<int> position, const Finding& finding) {
  const QString where = position ? Text::tr(" from position %1").arg(*position) : QString();
  return Text::tr("Scan %1%2 did not fit: %3.").arg(QString::number(number), where, translated(phraseOf(finding)));
}

QString failedScanText(const AcquisitionState& state) {
  if (state.scans.empty() || state.scans.back().status != ScanStatus::Rejected) return {};
  const KeptScan& scan = state.scans.back();
  if (scan.station().stand != state.stand()) return {};
  return failedScanText(scan.number, scan.station().position, scan.record.registration.finding) +
         Text::tr(" It is kept, but not part of the model. ") + remedy(state);
}

}  // namespace vantage
