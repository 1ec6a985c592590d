#include "completeness_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "acquisition/further_scan.h"
#include "planning/choice.h"
#include "report/edges_left.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Completeness)
};

// Never 100 % of what is not whole.
QString shareText(double share) {
  const double percent = 100.0 * share;
  const double shown = share < 1.0 ? std::min(percent, 99.9) : 100.0;
  return figureText(shown, shown < 99.0 ? 0 : 1) + QChar(QChar::Nbsp) + QLatin1Char('%');
}

// What no position of the scanner sees is known of a plan only that has nothing left to propose.
bool knowsWhatIsHidden(const AcquisitionState& state) {
  return state.plan && state.plan->voids && state.plan->outcome != PlanOutcome::Found;
}

double lengthLeft(const Plan& plan, EdgeReason reason) {
  for (const EdgesLeft& left : edgesLeft(plan))
    if (left.reason == reason) return left.length;
  return 0.0;
}

// Several heights of the scanner, or one.
bool tilts(const AcquisitionState& state) {
  return state.profile && state.profile->workspace.steps > 0 &&
         state.profile->workspace.size() > static_cast<std::size_t>(state.profile->workspace.steps);
}

QString adviceFor(const AcquisitionState& state, const Completeness& completeness) {
  if (completeness.closed) return Text::tr("Nothing has to be done: it can be printed and measured as it is.");
  const auto further = furtherScan(state);
  if (further && further->predicted && promise(*further->predicted) > 0.0)
    return Text::tr("Scan on: position %1 would show %2.")
        .arg(QString::number(further->position), areaText(promise(*further->predicted)));
  if (completeness.erasedHoles == completeness.holes)
    return Text::tr(
        "What is open is where you erased what is not the object: turn the object over to see what was hidden there, "
        "or "
        "close the openings when the model is used.");
  if (!state.profile)
    return Text::tr(
        "What is open was not seen by these scans: add scans that see it, or close the openings when the "
        "model is used.");
  if (knowsWhatIsHidden(state)) {
    const Plan& plan = *state.plan;
    const double below = lengthLeft(plan, EdgeReason::OutOfReach);
    const double steep = lengthLeft(plan, EdgeReason::TooSteep);
    const double blocked = lengthLeft(plan, EdgeReason::LightBlocked) + lengthLeft(plan, EdgeReason::ReceiverBlocked);
    if (below + steep + blocked > 0.0)
      return tilts(state) ? Text::tr("No position of this scanner sees the rest as the object stands: turn it over.")
                          : Text::tr(
                                "No position of this scanner sees the rest as the object stands: turn it over, or "
                                "tilt the scanner.");
    return Text::tr("Little is left that a view would show. Turn the object over to see its underside, or finish.");
  }
  return Text::tr("What is open was not seen: scan on, or turn the object over.");
}

QString headlineOf(const AcquisitionState& state, const Completeness& completeness) {
  if (completeness.closed) return Text::tr("The surface is closed.");
  if (knowsWhatIsHidden(state))
    return Text::tr("%1 of what the scanner reaches is covered.").arg(shareText(completeness.scannableCovered));
  return completeness.holes == 1 ? Text::tr("The surface has 1 opening.")
                                 : Text::tr("The surface has %1 openings.").arg(completeness.holes);
}

}  // namespace

CompletenessCard makeCompletenessCard(const AcquisitionState& state, const Completeness& completeness) {
  CompletenessCard card;
  const bool known = knowsWhatIsHidden(state);
  card.headline = headlineOf(state, completeness);
  card.good = completeness.closed || (known && completeness.scannableCovered > 0.99);
  if (known) card.reached = completeness.scannableCovered;
  if (!completeness.closed)
    card.figures.push_back({Text::tr("Of the whole surface, at most"), shareText(completeness.wholeCovered),
                            Text::tr("as far as its openings tell; behind them there may be more")});
  card.figures.push_back({Text::tr("Openings"), QString::number(completeness.holes),
                          completeness.erasedHoles > 0
                              ? Text::tr("%1 of them where you erased something").arg(completeness.erasedHoles)
                              : QString()});
  card.figures.push_back({Text::tr("Loose pieces"), QString::number(completeness.pieces),
                          completeness.pieces > 1 ? Text::tr("what joins them was not seen") : QString()});
  card.figures.push_back(
      {Text::tr("Closed, to be printed"), completeness.closed ? Text::tr("yes") : Text::tr("no"), {}});
  card.advice = adviceFor(state, completeness);
  return card;
}

}  // namespace vantage
