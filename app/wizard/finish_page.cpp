#include "wizard/finish_page.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QUrl>
#include <QVBoxLayout>

#include "acquisition/stand_composites.h"
#include "form_parts.h"
#include "help/help_topic.h"
#include "integration/colouring.h"
#include "stand_text.h"
#include "wizard/print_dialog.h"

namespace vantage {

QString withSuffix(const QString& path, const QString& filter) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  for (const char* known : {"stl", "ply", "obj", "3mf"})
    if (suffix == QLatin1String(known)) return path;
  for (const char* known : {"ply", "obj", "3mf"})
    if (filter.contains(QStringLiteral("*.") + QLatin1String(known)))
      return path + QLatin1Char('.') + QLatin1String(known);
  return path + QStringLiteral(".stl");
}

FinishPage::FinishPage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      place_(makeLabel({}, "muted")),
      missing_(makeLabel({}, "warning")),
      written_(makeLabel({})) {
  setHelpTopic(*this, QStringLiteral("finish"));
  addSection(tr("Export the model"));
  column().addWidget(place_);
  column().addWidget(missing_);
  const auto exportTo = [this](const QString& file) {
    return [this, file] {
      writeTo(inFolder(file), [this](const QString& path) { this->controller().exportModel(path); });
    };
  };
  connect(addExport(tr("Export ST&L"), QStringLiteral("exportStl"), QStringLiteral("model.stl"),
                    tr("Triangles only, for printing and CAD."), true),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.stl")));
  connect(addExport(tr("Export &PLY"), QStringLiteral("exportPly"), QStringLiteral("model.ply"),
                    tr("With a confidence per vertex and a view per face."), false),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.ply")));
  connect(addExport(tr("Export &OBJ"), QStringLiteral("exportObj"), QStringLiteral("model.obj"),
                    tr("Text that nearly every program reads."), false),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.obj")));
  connect(addExport(tr("Export &as…"), QStringLiteral("exportAs"), {}, tr("To a file of your choice."), false),
          &QPushButton::clicked, this, &FinishPage::exportAs);
  connect(addExport(tr("Rea&dy to print…"), QStringLiteral("exportPrintable"), {},
                    tr("Closed, in one piece, or you learn why not; also fewer triangles, inches, 3MF."), false),
          &QPushButton::clicked, this, &FinishPage::exportForPrint);
  addErase();
  addSection(tr("Report"));
  connect(addExport(tr("&Write the report"), QStringLiteral("report"), QStringLiteral("report.html"),
                    tr("One HTML page with pictures, figures, times and what is left."), false),
          &QPushButton::clicked, this, &FinishPage::report);
  column().addWidget(written_);
  column().addStretch();
  connect(&controller, &SessionController::written, this, [this](const QString& path) {
    const QUrl folder = QUrl::fromLocalFile(QFileInfo(path).absolutePath());
    const QString line =
        tr("Written: %1 (<a href=\"%2\">open</a>, <a href=\"%3\">show the folder</a>)")
            .arg(QFileInfo(path).fileName().toHtmlEscaped(), QString::fromLatin1(QUrl::fromLocalFile(path).toEncoded()),
                 QString::fromLatin1(folder.toEncoded()));
    if (!written_->text().contains(line)) addLine(line);
    emit changed();
  });
  written_->setTextFormat(Qt::RichText);
  written_->setOpenExternalLinks(true);
  written_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  written_->setFocusPolicy(Qt::StrongFocus);
  written_->hide();
  connect(&controller, &SessionController::sessionChanged, this, [this] {
    written_->clear();
    written_->hide();
  });
  const auto addText = [this](const QString& text) { addLine(text.toHtmlEscaped().replace(u'\n', u"<br>"_qs)); };
  connect(&controller, &SessionController::madeReady, this, addText);
  connect(&controller, &SessionController::printRefused, this, [addText](const QString& why) {
    addText(tr("Not written: the model cannot be printed as one piece.") + QStringLiteral("\n") + why);
  });
  connect(&controller, &SessionController::stateChanged, this, &FinishPage::refresh);
  connect(&controller, &SessionController::activityChanged, this, &FinishPage::refresh);
  connect(&controller, &SessionController::shownChanged, this, &FinishPage::refresh);
  refresh();
}

// Nothing that is there is written over without a word.
void FinishPage::writeTo(const QString& path, const std::function<void(const QString&)>& write) {
  if (!QFileInfo::exists(path)) return write(path);
  auto* box = new QMessageBox(QMessageBox::Question, tr("Vantage"),
                              tr("%1 is there already.").arg(QFileInfo(path).fileName()), QMessageBox::Cancel, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("overwrite"));
  box->setInformativeText(tr("In %1. If you replace it, what it holds now is gone.")
                              .arg(QDir::toNativeSeparators(QFileInfo(path).absolutePath())));
  QPushButton* replace = box->addButton(tr("&Replace"), QMessageBox::AcceptRole);
  replace->setObjectName(QStringLiteral("replaceFile"));
  connect(replace, &QPushButton::clicked, this, [path, write] { write(path); });
  box->open();
}

QPushButton* FinishPage::addExport(const QString& text, const QString& name, const QString& file, const QString& help,
                                   bool primary) {
  QPushButton* button = makeButton(text, name, help, primary);
  exports_ << button;
  column().addWidget(button);
  column().addWidget(makeLabel(file.isEmpty() ? help : file + QStringLiteral(": ") + help, "muted"));
  return button;
}

void FinishPage::exportAs() {
  QString filter;
  const QString path = QFileDialog::getSaveFileName(this, tr("Export the model"), inFolder(QStringLiteral("model.stl")),
                                                    tr("STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;3MF (*.3mf)"), &filter,
                                                    QFileDialog::DontConfirmOverwrite);
  if (!path.isEmpty()) writeTo(withSuffix(path, filter), [this](const QString& to) { controller().exportModel(to); });
}

void FinishPage::report() {
  writeTo(inFolder(QStringLiteral("report.html")), [this](const QString& path) { emit reportRequested(path); });
}

void FinishPage::exportForPrint() {
  PrintDialog dialog(this);
  if (dialog.exec() != QDialog::Accepted) return;
  QString filter;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export for printing"), inFolder(QStringLiteral("part.3mf")),
      tr("3MF (*.3mf);;STL (*.stl);;PLY (*.ply);;OBJ (*.obj)"), &filter, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  writeTo(withSuffix(path, filter),
          [this, choice = dialog.choice()](const QString& to) { controller().exportFinished(to, choice); });
}

void FinishPage::addLine(const QString& line) {
  written_->setText(written_->text() + (written_->text().isEmpty() ? "" : "<br>") + line);
  written_->show();
}

QString FinishPage::inFolder(const QString& file) const {
  const QDir folder(QString::fromStdString(controller().choice().folder));
  return folder.filePath(file);
}

QString FinishPage::whatNext() const {
  return tr("This session stays on the disk as it is. A new one begins with scanner and object.");
}

bool FinishPage::complete() const {
  return controller().idle();
}

void FinishPage::entered() {
  refresh();
}

void FinishPage::leaving() {
  controller().close();
}

void FinishPage::refresh() {
  const QString whyNot = controller().permissions().whyNotExport();
  for (QPushButton* button : exports_) allow(*button, whyNot);
  const SharedState& now = controller().now();
  const bool coloured = now && haveColours(viewsOf(withObject(*now)));
  const QString missing = now ? missingStandsText(*now) : QString();
  missing_->setText(missing);
  missing_->setVisible(!missing.isEmpty());
  place_->setText(
      tr("Into %1").arg(QDir::toNativeSeparators(inFolder({}))) +
      (controller().showsNow()
           ? QString()
           : QStringLiteral("\n") + tr("An earlier moment is shown; written is the session as it is now.")) +
      (coloured ? QStringLiteral("\n") + tr("The scans have colours: PLY and OBJ keep them, STL and 3MF do not.")
                : QString()));
  emit changed();
}

}  // namespace vantage
