#include "stand_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "acquisition/stand_composites.h"
#include "report/wording.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Stands)
};

QString found(const StandAlignment& alignment) {
  return translated(phraseOf(alignment));
}

}  // namespace

StandRole standRoleOf(const std::vector<Stand>& stands, int stand) {
  if (stand == referenceOf(stands)) return StandRole::Reference;
  const Stand& of = stands[static_cast<std::size_t>(stand)];
  if (!of.T_object_table) return StandRole::NotAligned;
  if (!of.alignment || !of.alignment->used) return StandRole::Aligned;
  if (of.alignment->choice == PoseChoice::Despite) return StandRole::Despite;
  return of.alignment->choice == PoseChoice::Operator && !of.alignment->sameSurface ? StandRole::Doubtful
                                                                                    : StandRole::Aligned;
}

QString standRoleText(StandRole role) {
  switch (role) {
    case StandRole::Reference:
      return Text::tr("reference");
    case StandRole::Aligned:
      return Text::tr("aligned");
    case StandRole::Doubtful:
      return Text::tr("doubtful");
    case StandRole::Despite:
      return Text::tr("used all the same");
    case StandRole::NotAligned:
      break;
  }
  return Text::tr("not aligned");
}

QString trialSentence(int stand, const StandAlignment& alignment) {
  const QString number = QString::number(stand);
  switch (alignment.verdict) {
    case AlignmentVerdict::Good:
      return Text::tr("Stand %1 is aligned: %2.").arg(number, found(alignment));
    case AlignmentVerdict::Ambiguous:
      return Text::tr("Stand %1 is not aligned, the scans leave it open: %2.").arg(number, found(alignment));
    case AlignmentVerdict::Failed:
      break;
  }
  return Text::tr("Stand %1 could not be aligned: %2.").arg(number, found(alignment));
}

QString standSentence(const std::vector<Stand>& stands, int stand) {
  const auto& alignment = stands[static_cast<std::size_t>(stand)].alignment;
  const QString number = QString::number(stand);
  switch (standRoleOf(stands, stand)) {
    case StandRole::Reference:
      return Text::tr("Stand %1 is the reference: the object stands in the model as it stood here.").arg(number);
    case StandRole::Aligned:
      return alignment ? Text::tr("Stand %1 is aligned: %2.").arg(number, found(*alignment))
                       : Text::tr("Stand %1 is where the operator placed it.").arg(number);
    case StandRole::Doubtful:
      return Text::tr("Stand %1 is in the model by a pose that was chosen: %2.").arg(number, found(*alignment));
    case StandRole::Despite:
      return Text::tr("Stand %1 is in the model although something speaks against it: %2.")
          .arg(number, found(*alignment));
    case StandRole::NotAligned:
      break;
  }
  return alignment
             ? trialSentence(stand, *alignment)
             : Text::tr("Stand %1 is a model of its own: it is not put together with the object yet.").arg(number);
}

QString ownModelText(const AcquisitionState& state) {
  const int composite = compositeInWork(state);
  return composite == referenceOf(state.stands)
             ? QString()
             : Text::tr("Stand %1, not put together with the object yet").arg(composite);
}

QString pictureCaption(const AcquisitionState& state, const QString& caption) {
  const QString own = ownModelText(state);
  return own.isEmpty() ? caption : own + QStringLiteral(": ") + caption;
}

QString missingStandsText(const AcquisitionState& state) {
  QStringList numbers;
  for (const int stand : standsToAlign(state)) numbers << QString::number(stand);
  if (numbers.isEmpty()) return {};
  return numbers.size() == 1
             ? Text::tr("Stand %1 is not in it: it is not put together with the object.").arg(numbers.front())
             : Text::tr("Stands %1 are not in it: they are not put together with the object.")
                   .arg(numbers.join(QStringLiteral(", ")));
}

QString standsText(const AcquisitionState& state) {
  QStringList lines;
  for (int stand = 0; stand <= state.stand() && state.stand() > 0; ++stand) lines << standSentence(state.stands, stand);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace vantage
