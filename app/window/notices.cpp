#include "window/notices.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "help/help_topic.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(Notices)
};

QString ended(const QString& text) {
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

QString asSentence(const QString& text) {
  return ended(text.left(1).toUpper() + text.mid(1));
}

}  // namespace

FailureText readableFailure(const QString& what) {
  const qsizetype colon = what.indexOf(QStringLiteral(": "));
  const QString path = what.left(colon);
  if (colon < 0 || !QDir::isAbsolutePath(path)) return {asSentence(what), {}};
  const QFileInfo file(path);
  return {ended(QStringLiteral("%1 %2").arg(file.fileName(), what.mid(colon + 2))),
          Text::tr("In the folder %1.").arg(QDir::toNativeSeparators(file.absolutePath()))};
}

void Notices::show(const QString& what, const QStringList& details) {
  const FailureText text = readableFailure(what);
  if (!box_) {
    said_ = details;
    box_ = new QMessageBox(QMessageBox::Warning, Text::tr("Vantage"), text.sentence, QMessageBox::Ok, &window_);
    box_->setAttribute(Qt::WA_DeleteOnClose);
    setHelpTopic(*box_, QStringLiteral("messages"));
    box_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box_->setInformativeText(text.place);
    if (!said_.isEmpty()) box_->setDetailedText(said_.join(QLatin1Char('\n')));
    box_->open();
    return;
  }
  if (text.sentence == box_->text() || said_.contains(what)) return;
  said_ << what << details;
  box_->setInformativeText(Text::tr("More happened meanwhile, see the details."));
  box_->setDetailedText(said_.join(QLatin1Char('\n')));
}

}  // namespace vantage
