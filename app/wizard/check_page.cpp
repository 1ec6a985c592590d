#include "wizard/check_page.h"

#include <QVBoxLayout>
#include <cmath>

#include "form_parts.h"
#include "help/help_topic.h"
#include "planning/turn_spread.h"
#include "report/wording.h"
#include "why_card.h"
#include "wizard/device_box.h"
#include "wizard/test_scan_box.h"
#include "wizard/volume_sketch.h"
#include "wording.h"

namespace vantage {
namespace {

QString unreadText(const QString& failure) {
  return CheckPage::tr("Scanner and object could not be read: %1.").arg(failure);
}

}  // namespace

CheckPage::CheckPage(SessionController& controller, QWidget* parent)
    : WizardPage(controller, parent),
      devicesTitle_(makeLabel(tr("Devices"), "section")),
      devices_(new DeviceBox(controller)),
      memory_(makeLabel({})),
      verdict_(makeLabel({})),
      sketch_(new VolumeSketch),
      figures_(new FigureTable),
      fit_(makeButton(tr("&Fit the object into the volume"), QStringLiteral("fit"),
                      tr("Scale and centre the object so that it stands inside the viewing volume."))),
      testScan_(new TestScanBox(controller)),
      turn_(makeButton(
          tr("Make a &test turn"), QStringLiteral("testTurn"),
          tr("Scan twice, a few positions apart, and compare the turn with the profile. Neither scan is kept."))),
      turnVerdict_(makeLabel({})),
      turnFigures_(new FigureTable) {
  setHelpTopic(*this, QStringLiteral("check"));
  column().addWidget(memory_);
  column().addWidget(devicesTitle_);
  column().addWidget(devices_);
  addSection(tr("Viewing volume"));
  column().addWidget(verdict_);
  column().addWidget(sketch_);
  column().addWidget(figures_);
  column().addWidget(fit_);
  addSection(tr("What a scan sees"));
  column().addWidget(testScan_);
  addSection(tr("Test turn"));
  column().addWidget(turn_);
  column().addWidget(turnVerdict_);
  column().addWidget(turnFigures_);
  column().addStretch();
  connect(fit_, &QPushButton::clicked, this, &CheckPage::fit);
  connect(turn_, &QPushButton::clicked, &controller, &SessionController::testTurn);
  connect(&controller, &SessionController::setUpChanged, this, &CheckPage::refresh);
  connect(&controller, &SessionController::activityChanged, this, &CheckPage::refresh);
  connect(&controller.testScans(), &TestScans::turnChanged, this, &CheckPage::refreshTestTurn);
  connect(&controller, &SessionController::setUpChanged, this, &CheckPage::connectDevices);
  refresh();
  refreshTestTurn();
}

QString CheckPage::whatNext() const {
  if (!controller().setUpFailure().isEmpty())
    return tr("Go back and choose something else. Nothing has been scanned yet.");
  if (!controller().setUp()) return tr("Scanner and object are being read.");
  if (calibrates()) return tr("Where the table stands before the scanner can be measured, or is taken as it is known.");
  return tr("The acquisition page opens. Scanning begins when you say so.");
}

QString CheckPage::nextText() const {
  return calibrates() ? tr("&Next: calibrate") : tr("&Next: acquire");
}

// See CalibratePage::applies.
bool CheckPage::calibrates() const {
  return !controller().hasSession() && controller().bench().hasTable();
}

bool CheckPage::complete() const {
  return controller().setUp() && (controller().setUp()->devices || controller().hasSession());
}

QString CheckPage::whyNotNext() const {
  if (!complete() && !controller().setUpFailure().isEmpty()) return unreadText(controller().setUpFailure());
  return WizardPage::whyNotNext();
}

void CheckPage::entered() {
  controller().prepare();
  connectDevices();
  emit changed();
}

// Whoever looks at this page wants to know how they are. What fails stands beside the button that tries again.
void CheckPage::connectDevices() {
  const DeviceBench& bench = controller().bench();
  if (!isVisible() || controller().hasSession() || !bench.real() || bench.connected() || !bench.failure().isEmpty())
    return;
  controller().bench().connectDevices();
}

void CheckPage::fit() {
  SetUpChoice choice = controller().choice();
  choice.settings.simulation.placement = Placement::Fit;
  controller().setChoice(choice);
  controller().prepare();
}

void CheckPage::refresh() {
  const SharedSetUp& setUp = controller().setUp();
  sketch_->show(setUp);
  figures_->clear();
  memory_->setText(controller().memoryNote());
  memory_->setVisible(!memory_->text().isEmpty());
  const bool outside = setUp && setUp->object && !setUp->object->insideVolume;
  fit_->setVisible(outside && !controller().hasSession());
  const bool real = controller().bench().real() && !controller().hasSession();
  devicesTitle_->setVisible(real);
  devices_->setVisible(real);
  allow(*turn_, controller().permissions().whyNotTestTurn());
  if (!setUp) {
    const QString& failure = controller().setUpFailure();
    verdict_->setText(!failure.isEmpty()                               ? unreadText(failure)
                      : controller().activity() == Activity::Preparing ? tr("Reading…")
                                                                       : tr("Nothing is chosen yet."));
  } else if (!setUp->object) {
    const QString why = controller().permissions().whyNoDevices();
    verdict_->setText(why.isEmpty() ? tr("What stands before the scanner is seen by its first scan.") : why);
  } else {
    verdict_->setText(outside ? tr("The object reaches out of the viewing volume: what is outside cannot be scanned.")
                              : tr("The object stands inside the viewing volume."));
    figures_->add(tr("Object, radius about the axis"), figureText(setUp->object->radius, 1) + tr(" mm"));
    figures_->add(tr("Object, height"), figureText(setUp->object->height, 1) + tr(" mm"));
    figures_->add(tr("Object, lowest point"), figureText(setUp->object->lowest, 1) + tr(" mm"), tr("0 is the table"));
  }
  setRole(*verdict_, outside || !controller().setUpFailure().isEmpty() ? "warning" : "");
  if (setUp && setUp->profile) {
    figures_->add(tr("Positions of the scanner"), countText(setUp->profile->workspace.size()));
    figures_->add(tr("Ranging rays per scan"), countText(setUp->profile->rays->size()));
  }
  emit changed();
}

void CheckPage::refreshTestTurn() {
  turnFigures_->clear();
  const auto& result = controller().testScans().turnResult();
  if (!result) {
    turnVerdict_->setText(tr("A test turn tells whether the table turns about its axis as the profile says."));
    return;
  }
  turnFigures_->add(tr("Turn by the profile"), angleText(result->expected));
  turnFigures_->add(tr("Turn measured"), figureText(degrees(result->measured), 2) + QStringLiteral("°"),
                    tr("%1° off, up to %2° are as expected")
                        .arg(figureText(degrees(std::abs(result->measured - result->expected)), 2),
                             figureText(degrees(result->angleLimit()), 2)));
  turnFigures_->add(tr("Axis moved by"), figureText(result->axisOffset, 2) + tr(" mm"),
                    tr("up to %1 mm are as expected").arg(figureText(result->offsetLimit(), 2)));
  const bool failed = result->registration.verdict == Verdict::Failed;
  const bool byHand = isGuess(result->errors);
  const bool off = !failed && !result->asExpected();
  turnVerdict_->setText(
      failed ? tr("The scans do not fit: %1").arg(translated(phraseOf(result->registration.finding)))
      : off && byHand
          ? tr("The scans fit, but the table was turned farther off than is expected of a person: turn it once more.")
      : off ? tr("The scans fit, but not where the profile expects the table after its turn: compare the figures, and "
                 "calibrate the table or mend its profile.")
      : result->registration.verdict == Verdict::Doubtful
          ? tr("The scans fit, but hold on to each other too little to measure the turn: %1")
                .arg(translated(phraseOf(result->registration.finding)))
      : byHand
          ? tr("The scans fit. The person turned the table by %1° where %2° were asked for, as the scans tell to about "
               "%3° and %4 mm. How well the table itself turns, a turn by hand does not tell.")
                .arg(figureText(degrees(result->measured), 1), figureText(degrees(result->expected), 1),
                     figureText(degrees(TestTurn::kScanAngle * TestTurn::kSigmas), 1),
                     figureText(TestTurn::kScanOffset * TestTurn::kSigmas, 1))
          : tr("The scans fit. The table turns as expected."));
  setRole(*turnVerdict_, failed || off ? "warning" : result->asExpected() ? "good" : "");
}

}  // namespace vantage
