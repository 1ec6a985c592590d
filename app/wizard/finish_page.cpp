#include "wizard/finish_page.h"

#include <QDir>
#include <QFileDialog>
#include <QVBoxLayout>

#include "acquisition/stand_composites.h"
#include "form_parts.h"
#include "integration/colouring.h"
#include "stand_text.h"
#include "wizard/print_dialog.h"

namespace vantage {

FinishPage::FinishPage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      place_(makeLabel({}, "muted")),
      missing_(makeLabel({}, "warning")),
      written_(makeLabel({})) {
  addSection(tr("Export the model"));
  column().addWidget(place_);
  column().addWidget(missing_);
  const auto exportTo = [this](const QString& file) {
    return [this, file] { this->controller().exportModel(inFolder(file)); };
  };
  connect(addExport(tr("Export &STL"), QStringLiteral("exportStl"), QStringLiteral("model.stl"),
                    tr("Triangles only, for printing and CAD."), true),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.stl")));
  connect(addExport(tr("Export &PLY"), QStringLiteral("exportPly"), QStringLiteral("model.ply"),
                    tr("With a confidence per vertex and a view per face."), false),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.ply")));
  connect(addExport(tr("Export &OBJ"), QStringLiteral("exportObj"), QStringLiteral("model.obj"),
                    tr("Text that nearly every program reads."), false),
          &QPushButton::clicked, this, exportTo(QStringLiteral("model.obj")));
  connect(addExport(tr("Export &as…"), QStringLiteral("exportAs"), {}, tr("To a file of your choice."), false),
          &QPushButton::clicked, this, [this] {
            const QString path =
                QFileDialog::getSaveFileName(this, tr("Export the model"), inFolder(QStringLiteral("model.stl")),
                                             tr("Models (*.stl *.ply *.obj *.3mf)"));
            if (!path.isEmpty()) this->controller().exportModel(path);
          });
  connect(addExport(tr("Rea&dy to print…"), QStringLiteral("exportPrintable"), {},
                    tr("Closed, in one piece, or you learn why not; also fewer triangles, inches, 3MF."), false),
          &QPushButton::clicked, this, &FinishPage::exportForPrint);
  addSection(tr("Report"));
  connect(addExport(tr("Write the &report"), QStringLiteral("report"), QStringLiteral("report.html"),
                    tr("One HTML page with pictures, figures, times and what is left."), false),
          &QPushButton::clicked, this, [this] { emit reportRequested(inFolder(QStringLiteral("report.html"))); });
  column().addWidget(written_);
  column().addStretch();
  connect(&controller, &SessionController::written, this, [this](const QString& path) {
    const QString line = tr("Written: %1").arg(QDir::toNativeSeparators(path));
    if (!written_->text().contains(line))
      written_->setText(written_->text() + (written_->text().isEmpty() ? "" : "\n") + line);
    emit changed();
  });
  connect(&controller, &SessionController::madeReady, this,
          [this](const QString& what) { written_->setText(written_->text() + QStringLiteral("\n") + what); });
  connect(&controller, &SessionController::printRefused, this, [this](const QString& why) {
    written_->setText(tr("Not written: the model cannot be printed as one piece.") + QStringLiteral("\n") + why);
  });
  connect(&controller, &SessionController::sessionChanged, written_, &QLabel::clear);
  connect(&controller, &SessionController::stateChanged, this, &FinishPage::refresh);
  connect(&controller, &SessionController::activityChanged, this, &FinishPage::refresh);
  refresh();
}

QPushButton* FinishPage::addExport(const QString& text, const QString& name, const QString& file, const QString& help,
                                   bool primary) {
  QPushButton* button = makeButton(text, name, help, primary);
  exports_ << button;
  column().addWidget(button);
  column().addWidget(makeLabel(file.isEmpty() ? help : file + QStringLiteral(": ") + help, "muted"));
  return button;
}

void FinishPage::exportForPrint() {
  PrintDialog dialog(this);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export for printing"), inFolder(QStringLiteral("part.3mf")), tr("Models (*.3mf *.stl *.ply *.obj)"));
  if (!path.isEmpty()) controller().exportFinished(path, dialog.choice());
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
  place_->setText(tr("Into %1").arg(QDir::toNativeSeparators(inFolder({}))) +
                  (coloured
                       ? QStringLiteral("\n") + tr("The scans have colours: PLY and OBJ keep them, STL and 3MF do not.")
                       : QString()));
  emit changed();
}

}  // namespace vantage
