#include "wizard/calibrate_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QSpinBox>
#include <QVBoxLayout>

#include "form_parts.h"
#include "geometry/measures.h"
#include "help/help_topic.h"
#include "report/wording.h"
#include "why_card.h"
#include "wording.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(CalibratePage)
};

QString verdictText(CalibrationVerdict verdict) {
  switch (verdict) {
    case CalibrationVerdict::Good:
      return Text::tr("The table is calibrated.");
    case CalibrationVerdict::Doubtful:
      return Text::tr("The table is calibrated, but something about it is in doubt.");
    case CalibrationVerdict::Failed:
      break;
  }
  return Text::tr("The table could not be calibrated.");
}

QString sentenceOf(const CalibrationFinding& finding) {
  QString text = QString::fromStdString(describe(finding));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text + QLatin1Char('.');
}

}  // namespace

CalibratePage::CalibratePage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      current_(makeLabel({})),
      scans_(new QSpinBox),
      calibrate_(makeButton(tr("&Calibrate"), QStringLiteral("calibrateTable"),
                            tr("Turn the table step by step, scan at every step, and find its axis from the scans."),
                            true)),
      stop_(makeButton(tr("S&top"), QStringLiteral("stopCalibration"), tr("Stop at once; nothing is changed."))),
      verdict_(makeLabel({})),
      figures_(new FigureTable),
      findings_(makeLabel({})),
      use_(makeButton(tr("&Use this calibration"), QStringLiteral("useCalibration"),
                      tr("Write it to a file in the folder of the session, and scan with it."))) {
  setHelpTopic(*this, QStringLiteral("calibrate"));
  column().addWidget(makeLabel(tr("Put any object on the table that looks different from every side, not round, and "
                                  "well in sight of the scanner. The table is turned through 60 to 200 degrees."),
                               "muted"));
  column().addWidget(current_);
  scans_->setObjectName(QStringLiteral("calibrationScans"));
  scans_->setAccessibleName(tr("Number of scans"));
  scans_->setToolTip(tr("More scans make the axis surer and take longer."));
  scans_->setRange(3, 12);
  scans_->setValue(6);
  scans_->setSuffix(tr(" scans"));
  auto* row = new QHBoxLayout;
  row->addWidget(scans_);
  row->addWidget(calibrate_, 1);
  row->addWidget(stop_);
  column().addLayout(row);
  verdict_->setObjectName(QStringLiteral("calibrationVerdict"));
  column().addWidget(verdict_);
  column().addWidget(findings_);
  column().addWidget(figures_);
  column().addWidget(use_);
  column().addStretch();
  TableCalibrating& calibrating = controller.calibrating();
  connect(calibrate_, &QPushButton::clicked, this,
          [this] { this->controller().calibrating().calibrate(scans_->value()); });
  connect(stop_, &QPushButton::clicked, &controller, &SessionController::stop);
  connect(use_, &QPushButton::clicked, this, [this] {
    this->controller().calibrating().keep(QString::fromStdString(this->controller().choice().folder));
  });
  connect(&calibrating, &TableCalibrating::changed, this, &CalibratePage::refreshResult);
  connect(&controller, &SessionController::setUpChanged, this, &CalibratePage::refresh);
  connect(&controller, &SessionController::activityChanged, this, &CalibratePage::refresh);
  refresh();
  refreshResult();
}

bool CalibratePage::applies() const {
  return !controller().hasSession() && controller().bench().hasTable();
}

QString CalibratePage::whatNext() const {
  return tr(
      "The acquisition page opens. Without a calibration the table is taken to stand and turn as the profile of "
      "the scanner says.");
}

bool CalibratePage::complete() const {
  return controller().idle() && controller().setUp();
}

void CalibratePage::entered() {
  controller().prepare();
  refresh();
  emit changed();
}

QString CalibratePage::current() const {
  const std::string& file = controller().choice().rig.calibration;
  const SharedSetUp& setUp = controller().setUp();
  if (!file.empty()) return tr("In use: %1").arg(QString::fromStdString(file));
  if (setUp && setUp->profile && setUp->profile->calibration) return tr("In use: the calibration in the profile.");
  return tr("The table is not calibrated.");
}

void CalibratePage::refresh() {
  current_->setText(current());
  const QString why = controller().calibrating().whyNot();
  allow(*calibrate_, why);
  allow(*scans_, why);
  const bool stoppable = !controller().idle() && controller().activity() != Activity::Stopping;
  allow(*stop_, stoppable ? QString() : tr("Nothing runs that could be stopped."));
  allow(*use_, controller().calibrating().usable() ? why : tr("There is nothing that could be used."));
  emit changed();
}

void CalibratePage::refreshResult() {
  const TableCalibrating& calibrating = controller().calibrating();
  const auto& result = calibrating.result();
  figures_->clear();
  findings_->clear();
  use_->setVisible(calibrating.usable());
  verdict_->setText(calibrating.failure());
  setRole(*verdict_, "warning");
  if (result) {
    const TableCalibration& c = result->calibration;
    verdict_->setText(verdictText(c.verdict));
    setRole(*verdict_, c.verdict == CalibrationVerdict::Good ? "section" : "warning");
    QStringList sentences;
    for (const CalibrationFinding& finding : result->findings) sentences << sentenceOf(finding);
    findings_->setText(sentences.join(QLatin1Char('\n')));
    if (c.verdict != CalibrationVerdict::Failed) {
      figures_->add(tr("Axis, sure to"), figureText(c.sigma, 3) + tr(" mm"),
                    figureText(degrees(c.angleSigma), 3) + tr("° in its direction"));
      figures_->add(tr("Turns, as it counts upwards"), c.sense > 0 ? tr("counter-clockwise") : tr("clockwise"),
                    tr("seen from above"));
      figures_->add(tr("Turned for every degree counted"),
                    figureText(c.degreesPerCommandedDegree, 4) + QStringLiteral("°"));
      for (const ScanResidual& scan : result->scans)
        figures_->add(
            tr("Scan at %1°").arg(figureText(scan.tableAngle, 2)),
            scan.used ? tr("off by %1°").arg(figureText(degrees(scan.off), 2)) : tr("not used"),
            scan.used ? tr("fits to %1 mm").arg(figureText(scan.rms, 3)) : tr("it shows too little that turns"));
    }
  }
  verdict_->setVisible(!verdict_->text().isEmpty());
  findings_->setVisible(!findings_->text().isEmpty());
  refresh();
}

}  // namespace vantage
