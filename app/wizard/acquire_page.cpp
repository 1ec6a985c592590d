#include "wizard/acquire_page.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QTabBar>
#include <QVBoxLayout>
#include <algorithm>

#include "docks/job_panel.h"
#include "ending_text.h"
#include "form_parts.h"
#include "geometry/measures.h"
#include "help/help_topic.h"
#include "outlook_text.h"
#include "report/areas_known.h"
#include "stand_desk.h"
#include "stand_text.h"
#include "why_card.h"
#include "wizard/next_view_box.h"
#include "wizard/object_figures.h"
#include "wizard/other_turn_box.h"
#include "wizard/stand_box.h"

namespace vantage {
namespace {

constexpr int kMoreViews = 10;

}  // namespace

AcquirePage::AcquirePage(SessionController& controller, StandDesk& stands, QWidget* parent)
    : WizardPage(controller, parent),
      mode_(new QTabBar),
      failure_(makeLabel({}, "warning")),
      again_(makeButton(tr("Tr&y again"), QStringLiteral("again"), tr("Scan from the same position once more."))),
      byHand_(makeButton(tr("Turn it &myself"), QStringLiteral("byHand"),
                         tr("Go on without the table: you turn the object as the dial says."))),
      status_(makeLabel({})),
      figures_(new FigureTable),
      nextView_(new NextViewBox(controller)),
      run_(makeButton(tr("&Run"), QStringLiteral("run"), tr("Scan until nothing is left to see."), true)),
      pause_(makeButton(tr("&Pause"), QStringLiteral("pause"), tr("Stop after the scan that is under way."))),
      step_(makeButton(tr("&One scan"), QStringLiteral("step"), tr("Take the next scan and stop."))),
      stop_(makeButton(tr("S&top"), QStringLiteral("stop"),
                       tr("Stop at once; the scan that is under way leaves no trace."))),
      scan_(makeButton(tr("The table &is turned: scan"), QStringLiteral("scan"), tr("Scan from the position shown."),
                       true)),
      more_(makeButton(tr("Allow %1 &further views").arg(kMoreViews), QStringLiteral("more"),
                       tr("Raise the greatest number of views, so that you can go on."))),
      end_(makeButton(tr("En&d here"), QStringLiteral("end"), tr("End the acquisition with what has been scanned."))),
      turnOver_(makeButton(tr("T&urn over…"), QStringLiteral("turnOver"),
                           tr("Put the object on another side, to scan what this stand hides."))),
      stands_(stands) {
  setHelpTopic(*this, QStringLiteral("acquire"));
  build();
  connect(mode_, &QTabBar::currentChanged, this,
          [this](int tab) { this->controller().setMode(tab == 1 ? Mode::Assisted : Mode::Automatic); });
  // Also what was not granted is shown as it is.
  connect(&controller, &SessionController::refused, this, &AcquirePage::refresh);
  connect(more_, &QPushButton::clicked, this, [this] { this->controller().allowMoreViews(kMoreViews); });
  connect(run_, &QPushButton::clicked, &controller, &SessionController::run);
  connect(step_, &QPushButton::clicked, &controller, &SessionController::step);
  connect(scan_, &QPushButton::clicked, &controller, &SessionController::step);
  connect(again_, &QPushButton::clicked, this,
          [this] { assisted() ? this->controller().step() : this->controller().run(); });
  connect(byHand_, &QPushButton::clicked, &controller, &SessionController::turnByHand);
  connect(pause_, &QPushButton::clicked, &controller, &SessionController::pause);
  connect(stop_, &QPushButton::clicked, &controller, &SessionController::stop);
  connect(end_, &QPushButton::clicked, this, [this] {
    this->controller().endHere();
    emit finished();
  });
  connect(&controller, &SessionController::activityChanged, this, &AcquirePage::refresh);
  connect(&controller, &SessionController::stateChanged, this, &AcquirePage::refresh);
  connect(&controller, &SessionController::stepChanged, this, [this] { status_->setText(status()); });
  connect(turnOver_, &QPushButton::clicked, this, [this] { emit wanted(QStringLiteral("turn_over")); });
  // A stand that is not put together with the object is first of all that.
  connect(&controller, &SessionController::runEnded, this, [this] {
    if (!stands_.isOpen()) emit finished();
  });
  refresh();
}

void AcquirePage::build() {
  mode_->addTab(tr("Automatic"));
  mode_->addTab(tr("Assisted"));
  mode_->setObjectName(QStringLiteral("mode"));
  mode_->setAccessibleName(tr("Who turns the table"));
  mode_->setExpanding(true);
  mode_->setDocumentMode(true);
  column().addWidget(mode_);
  column().addWidget(failure_);
  column().addWidget(new OtherTurnBox(controller()));
  auto* ways = new QHBoxLayout;
  ways->addWidget(again_);
  ways->addWidget(byHand_);
  column().addLayout(ways);
  column().addWidget(status_);
  auto* stand = new StandBox(controller(), stands_);
  connect(stand, &StandBox::turnWanted, this, [this] { emit wanted(QStringLiteral("turn_over")); });
  column().addWidget(stand);
  auto* buttons = new QGridLayout;
  buttons->addWidget(run_, 0, 0, 1, 3);
  buttons->addWidget(scan_, 1, 0, 1, 3);
  buttons->addWidget(pause_, 2, 0);
  buttons->addWidget(step_, 2, 1);
  buttons->addWidget(stop_, 2, 2);
  column().addLayout(buttons);
  column().addWidget(more_);
  column().addWidget(nextView_);
  addSection(tr("So far"));
  column().addWidget(figures_);
  column().addStretch();
  auto* ends = new QHBoxLayout;
  ends->addWidget(end_);
  ends->addWidget(turnOver_);
  column().addLayout(ends);
}

void AcquirePage::setAssisted(bool assisted) {
  controller().setMode(assisted ? Mode::Assisted : Mode::Automatic);
}

bool AcquirePage::assisted() const {
  return controller().mode() == Mode::Assisted;
}

void AcquirePage::entered() {
  controller().prepare();
  refresh();
}

QString AcquirePage::status() const {
  const SharedState& now = controller().now();
  const QString outlook = now ? outlookText(*now) : QString();
  return outlook.isEmpty()
             ? stage()
             : stage() + QLatin1Char('\n') + outlook.left(1).toUpper() + outlook.mid(1) + QLatin1Char('.');
}

QString AcquirePage::stage() const {
  switch (controller().activity()) {
    case Activity::Running:
      return stepText(controller().stepOfWork()).isEmpty()
                 ? tr("Scanning, registering, merging and planning; the bar below shows the step.")
                 : tr("Now: %1.").arg(stepText(controller().stepOfWork()));
    case Activity::Pausing:
      return tr("Stops after this scan.");
    case Activity::Stopping:
      return tr("Stopping.");
    case Activity::Preparing:
      return tr("Reading scanner and object.");
    default:
      break;
  }
  const SharedState& now = controller().now();
  if (!now || now->scans.empty()) return tr("Nothing has been scanned yet.");
  return now->termination == Termination::Running ? tr("Stopped. The next view is ready.") : endingText(*now);
}

QString AcquirePage::whatNext() const {
  if (stands_.isOpen())
    return tr("While this stand is scanned it is found out how the object was turned over; then both are one model.");
  if (controller().activity() == Activity::Running)
    return assisted() ? tr("After this scan the next position is shown.")
                      : tr("When nothing is left to see, the review opens by itself.");
  if (!complete())
    return assisted() ? tr("You turn the table as the dial says; after each scan the best next view is shown.")
                      : tr("Run scans from one position after the other, each chosen by what is still unseen.");
  return controller().permissions().whyNotScan().isEmpty() ? tr("Go on scanning, or look at what there is so far.")
                                                           : tr("The review shows what is covered and what is left.");
}

bool AcquirePage::complete() const {
  return controller().idle() && hasAnyModel(controller().now());
}

void AcquirePage::refresh() {
  const QSignalBlocker quiet(mode_);
  mode_->setCurrentIndex(assisted() ? 1 : 0);
  const SharedState& now = controller().now();
  nextView_->setAssisted(assisted());
  status_->setText(status());
  const bool failed = !controller().scanFailure().isEmpty();
  if (failed)
    failure_->setText(controller().scanFailure() + QStringLiteral("\n") + tr("No scan is lost."));
  else
    failure_->setText(controller().idle() && now ? failedScanText(*now) : QString());
  again_->setVisible(failed);
  byHand_->setVisible(failed && controller().canTurnByHand());
  failure_->setVisible(!failure_->text().isEmpty());
  const bool asTheyCome = controller().takesAsTheyCome();
  for (QPushButton* button : {run_, pause_}) button->setVisible(!assisted() || asTheyCome);
  step_->setVisible(!assisted());
  scan_->setVisible(assisted());
  const bool begun = now && !now->scans.empty();
  run_->setText(asTheyCome ? tr("Take scans as they &come") : begun ? tr("&Go on") : tr("&Run"));
  setHelp(*run_, asTheyCome ? tr("Turn the table as the dial says and scan with the scanner's own program: whatever it "
                                 "writes is taken, and the next position is shown.")
                            : tr("Scan until nothing is left to see."));
  allow(*run_, controller().permissions().whyNotRun());
  allow(*step_, controller().permissions().whyNotScan());
  allow(*scan_, controller().permissions().whyNotScan());
  allow(*pause_, controller().activity() == Activity::Running ? QString() : tr("Nothing runs that could pause."));
  const bool stoppable = !controller().idle() && controller().activity() != Activity::Stopping;
  allow(*stop_, stoppable ? QString() : tr("Nothing runs that could be stopped."));
  more_->setVisible(now && now->termination == Termination::MaxViews);
  allow(*turnOver_, stands_.whyNotTurn());
  allow(*end_, controller().permissions().whyNot(Finish{Termination::EndedByOperator}));
  refreshFigures();
  emit changed();
}

void AcquirePage::refreshFigures() {
  figures_->clear();
  const SharedState& now = controller().now();
  const std::size_t views = now ? countScans(*now, ScanStatus::In) : 0;
  const QString own = now ? ownModelText(*now) : QString();
  figures_->add(own.isEmpty() ? tr("Views in the model") : tr("Views in this stand"), QString::number(views), own);
  if (!own.isEmpty()) addObject(*figures_, *now);
  if (!now || now->scans.empty()) return;
  if (const std::size_t rejected = countScans(*now, ScanStatus::Rejected))
    figures_->add(tr("Scans that did not fit"), QString::number(rejected), tr("kept, but not part of the model"));
  const KeptScan& last = now->scans.back();
  const bool grown = last.status == ScanStatus::In && areasKnown(last.record);
  if (now->model)
    figures_->add(tr("Surface"), areaText(area(now->model->mesh)),
                  grown ? tr("%1 new by the last scan").arg(areaText(last.record.newArea)) : QString());
  const auto& plan = now->plan;
  if (!plan || !plan->voids) return;
  const auto open =
      std::count_if(plan->outlook.begin(), plan->outlook.end(), [](const auto& o) { return !o.answered; });
  figures_->add(tr("Unseen edges"), countText(plan->voids->patches.size()), tr("%1 still attract views").arg(open));
}

}  // namespace vantage
