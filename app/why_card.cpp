#include "why_card.h"

#include <QCoreApplication>
#include <cmath>

#include "report/wording.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(WhyCard)
};

// What the acquisition makes of the position; the plan's verdict follows.
QString roleText(PositionRole role) {
  switch (role) {
    case PositionRole::OperatorsChoice:
      return Text::tr("Your choice: the next scan is taken from here. ");
    case PositionRole::AfterFailure:
      return Text::tr("Next, as the scan before did not fit: this one overlaps the model clearly more. ");
    case PositionRole::Further:
      return Text::tr("The acquisition has ended; if it went on, this would be next. ");
    case PositionRole::Failed:
      return Text::tr("A scan from here did not fit. ");
    case PositionRole::None:
    case PositionRole::Proposed:
      break;
  }
  return {};
}

QString planVerdict(const Explanation& why, bool planHolds) {
  switch (why.constraint) {
    case Constraint::Chosen:
      if (why.tableAlone && planHolds)
        return Text::tr(
            "It shows the most unseen surface. Nothing that is left overlaps the model enough to register with it: the "
            "table alone will say where this scan belongs.");
      return planHolds ? Text::tr(
                             "Proposed: of all positions that overlap the model enough it shows the most unseen "
                             "surface.")
                       : Text::tr(
                             "Of all positions that overlap the model enough it shows the most unseen surface; "
                             "after a scan that did not fit another one comes next.");
    case Constraint::Outscored:
      return planHolds ? Text::tr("Allowed, but the proposed position shows more.") : Text::tr("Allowed.");
    case Constraint::BelowThreshold:
      return Text::tr("Rejected: what it would show is %1 short of the least that is worth a scan.")
                 .arg(areaText(why.shortBy)) +
             (why.overlapArea <= why.leastOverlap ? Text::tr(" It overlaps the model too little to be registered, too.")
                                                  : QString());
    case Constraint::OverlapShort:
      return Text::tr("Rejected: the overlap with the model is short by %1, so the scan could not be registered.")
          .arg(areaText(why.shortBy));
    case Constraint::PoseUncertain:
      return Text::tr("Rejected: registration would be uncertain, by %1 mm more than allowed.")
          .arg(figureText(why.shortBy, 3));
  }
  return {};
}

void addVoid(WhyCard& card, const Explanation& why) {
  const bool probe = why.forecast && why.forecast->probing && why.constraint == Constraint::Chosen;
  const QString threshold = areaText(why.terminationThreshold);
  card.figures.push_back(
      {why.forecast ? Text::tr("New surface, as forecast (o_v)") : Text::tr("Would show (void, o_v)"),
       areaText(why.promise),
       probe ? Text::tr("less than F = %1: a probe, as the last scan showed more").arg(threshold)
             : Text::tr("more than F = %1 is worth a scan").arg(threshold)});
  if (why.tracedVoidArea)
    card.figures.push_back(
        {Text::tr("by positional space"), areaText(why.voidArea), Text::tr("before following the scanner's rays")});
  card.figures.push_back(
      {Text::tr("Rank"), countText(why.rank), Text::tr("by what positions promise, ruled out or not")});
}

void addRegistration(WhyCard& card, const Explanation& why) {
  card.figures.push_back({Text::tr("Overlap (o_s)"), areaText(why.overlapArea),
                          why.tableAlone ? Text::tr("too little to register with")
                                         : Text::tr("more than t = %1 is needed").arg(areaText(why.leastOverlap))});
  if (!why.poseSigma) return;
  const QString sigma =
      std::isfinite(*why.poseSigma) ? figureText(*why.poseSigma, 3) + Text::tr(" mm") : Text::tr("unbounded");
  card.figures.push_back(
      {Text::tr("Registration error"), sigma, Text::tr("weakest: %1").arg(translated(phraseOf(why.weakMotions)))});
}

void addPatches(WhyCard& card, const Explanation& why) {
  if (why.patches == 0) return;
  QStringList parts;
  for (std::size_t i = 0; i < kEdgeClasses; ++i)
    if (why.patchesByClass[i] > 0)
      parts << QStringLiteral("%1 × %2").arg(why.patchesByClass[i]).arg(edgeClassText(static_cast<EdgeClass>(i)));
  card.figures.push_back({Text::tr("Unseen edges it wins"), countText(why.patches), parts.join(QStringLiteral(", "))});
}

QString patchesText(std::size_t count) {
  return count == 1 ? Text::tr("1 edge") : Text::tr("%1 edges").arg(count);
}

void addSights(WhyCard& card, const PositionSight& sight) {
  const std::pair<Visibility, const char*> rows[] = {
      {Visibility::Seen, QT_TRANSLATE_NOOP("WhyCard", "in sight")},
      {Visibility::LightBlocked, QT_TRANSLATE_NOOP("WhyCard", "light blocked by the object")},
      {Visibility::ReceiverBlocked, QT_TRANSLATE_NOOP("WhyCard", "receiver blocked by the object")},
      {Visibility::TooSteep, QT_TRANSLATE_NOOP("WhyCard", "too steep")},
      {Visibility::OutOfReach, QT_TRANSLATE_NOOP("WhyCard", "outside the sampling area")}};
  for (const auto& [visibility, text] : rows)
    card.sights.push_back({Text::tr(text), areaText(sight.area(visibility)), patchesText(sight.count(visibility))});
}

QString difference(double value, double other, const QString& more, const QString& less) {
  return areaText(std::abs(value - other)) + QStringLiteral(" ") + (value >= other ? more : less);
}

QString comparisonOf(const Explanation& why, bool planHolds) {
  if (!why.rival) return why.constraint == Constraint::Chosen ? Text::tr("No other position is allowed.") : QString();
  const QString who = why.constraint == Constraint::Chosen ? Text::tr("The runner-up, position %1,").arg(*why.rival)
                      : planHolds                          ? Text::tr("The proposed position %1").arg(*why.rival)
                                  : Text::tr("Position %1, which the plan had proposed,").arg(*why.rival);
  return Text::tr("%1 shows %2 and overlaps %3.")
      .arg(who, difference(why.rivalPromise, why.promise, Text::tr("more"), Text::tr("less")),
           difference(why.rivalOverlap, why.overlapArea, Text::tr("more"), Text::tr("less")));
}

}  // namespace

QString countText(std::size_t count) {
  return figureText(static_cast<double>(count));
}

QString areaText(double squareMillimetres) {
  const double size = std::abs(squareMillimetres);
  return figureText(squareMillimetres, size > 0.0 && size < 100.0 ? 1 : 0) + QChar(QChar::Nbsp) + QStringLiteral("mm²");
}

QString angleText(double radians) {
  return figureText(degrees(radians), 1) + QStringLiteral("°");
}

WhyCard makeWhyCard(const PositionInsight& insight) {
  const Explanation& why = insight.why;
  WhyCard card;
  card.title = Text::tr("Position %1").arg(why.position);
  card.verdict = roleText(insight.role) + planVerdict(why, insight.planHolds);
  if (insight.composite > 0)
    card.verdict +=
        Text::tr(" The model here is that of stand %1 alone, which is not put together with the object yet.")
            .arg(insight.composite);
  addVoid(card, why);
  addRegistration(card, why);
  addPatches(card, why);
  if (insight.sight) addSights(card, *insight.sight);
  card.comparison = comparisonOf(why, insight.planHolds);
  return card;
}

}  // namespace vantage
