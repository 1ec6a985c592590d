#include "wording.h"

#include <QCoreApplication>

#include "report/wording.h"
#include "why_card.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Wording)
};

}  // namespace

QString translated(const Phrase& phrase) {
  if (phrase.pattern == nullptr)
    return phrase.text.empty() ? figureText(phrase.number, phrase.decimals) : QString::fromStdString(phrase.text);
  const QString pattern = QCoreApplication::translate("Phrase", phrase.pattern);
  QString text;
  for (qsizetype i = 0; i < pattern.size(); ++i) {
    const int place = pattern[i] == u'%' && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : 0;
    if (place < 1 || place > static_cast<int>(phrase.values.size())) {
      text += pattern[i];
    } else {
      text += translated(phrase.values[static_cast<std::size_t>(place - 1)]);
      ++i;
    }
  }
  return text;
}

QString commandText(const Command& command) {
  const auto* finish = std::get_if<Finish>(&command);
  const bool ended = finish != nullptr && finish->termination != Termination::Running;
  return ended ? terminationText(finish->termination) : translated(phraseOf(command));
}

QString terminationText(Termination termination) {
  switch (termination) {
    case Termination::Running:
      return Text::tr("The acquisition is not ended yet.");
    case Termination::Finished:
      return Text::tr("Ended: no position would show more than is worth a scan.");
    case Termination::NoOverlap:
      return Text::tr("Ended: what is left overlaps the model too little from every position.");
    case Termination::MaxViews:
      return Text::tr("Ended: the greatest number of views was taken.");
    case Termination::RegistrationFailed:
      return Text::tr("Ended: scans could not be registered.");
    case Termination::Cancelled:
      return Text::tr("The run was stopped.");
    case Termination::EndedByOperator:
      return Text::tr("Ended by you.");
    case Termination::Imported:
      return Text::tr("Recorded scans, put together. No view was planned, so nothing is known of what is left.");
  }
  return {};
}

QString edgeReasonText(EdgeReason reason, PlanOutcome outcome) {
  switch (reason) {
    case EdgeReason::OutOfReach:
      return Text::tr("No ray reaches it");
    case EdgeReason::TooSteep:
      return Text::tr("Too steep from everywhere");
    case EdgeReason::LightBlocked:
      return Text::tr("Light always blocked");
    case EdgeReason::ReceiverBlocked:
      return Text::tr("Receiver always blocked");
    case EdgeReason::BelowThreshold:
      return outcome == PlanOutcome::Found ? Text::tr("Not scanned yet") : Text::tr("Too little to be worth it");
    case EdgeReason::Answered:
      return Text::tr("Looked at, no surface");
    case EdgeReason::Erased:
      return Text::tr("Erased by you");
  }
  return {};
}

QString edgeClassText(EdgeClass edgeClass) {
  switch (edgeClass) {
    case EdgeClass::OuterJump:
      return Text::tr("edge against the background");
    case EdgeClass::InnerJump:
      return Text::tr("hidden behind the object");
    case EdgeClass::LineOfSightJump:
      return Text::tr("light or camera blocked");
    case EdgeClass::Regular:
      return Text::tr("open border");
    case EdgeClass::Rim:
      return Text::tr("rim of the scan");
  }
  return {};
}

}  // namespace vantage
