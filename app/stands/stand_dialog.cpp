#include "stands/stand_dialog.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <utility>

#include "acquisition/stand_composites.h"
#include "docks/job_panel.h"
#include "form_parts.h"
#include "help/help_topic.h"
#include "session_controller.h"
#include "stands/point_picker.h"
#include "stands/pose_chooser.h"
#include "stands/pose_words.h"

namespace vantage {

StandDialog::StandDialog(SessionController& controller, JobRunner& jobs, const StandLook& look, int stand,
                         QWidget* parent)
    : QDialog(parent),
      controller_(controller),
      jobs_(jobs),
      theme_(look.theme),
      stand_(stand),
      inspector_(new StandInspector(jobs, this)),
      choice_(new QComboBox),
      verdict_(makeLabel({}, "section")),
      complaint_(makeLabel({}, "warning")),
      pages_(new QStackedWidget),
      poses_(new PoseChooser(look.surfaces, look.theme, look.navigation)),
      picker_(new PointPicker(look.surfaces, look.theme, look.navigation)),
      search_(makeButton(tr("&Look for poses"), QStringLiteral("searchPoses"),
                         tr("Searches all turns for poses of this stand, and checks them against the scans."))),
      pick_(makeButton(tr("&Pick points…"), QStringLiteral("pickPoints"),
                       tr("Click the same places on object and stand, where no pose is found without them."))),
      close_(makeButton(tr("Close"), QStringLiteral("closeStands"), tr("Closes this window."))) {
  setHelpTopic(*this, QStringLiteral("turn_over#how-the-stands-lie-in-each-other"));
  setWindowTitle(tr("How the stands lie in each other"));
  resize(1000, 660);
  build(jobs);
  connectParts();
  for (const int waiting : standsToAlign(*controller.now())) choice_->addItem(tr("Stand %1").arg(waiting), waiting);
  choice_->setVisible(choice_->count() > 1);
  {
    const QSignalBlocker quiet(choice_);
    choice_->setCurrentIndex(choice_->findData(stand));
  }
  showStand(stand);
}

void StandDialog::build(JobRunner& jobs) {
  auto* column = new QVBoxLayout(this);
  auto* top = new QHBoxLayout;
  choice_->setObjectName(QStringLiteral("standChoice"));
  choice_->setAccessibleName(tr("Stand that is not in place yet"));
  choice_->setToolTip(choice_->accessibleName());
  verdict_->setObjectName(QStringLiteral("standVerdict"));
  complaint_->setObjectName(QStringLiteral("standComplaint"));
  complaint_->hide();
  top->addWidget(choice_);
  top->addWidget(verdict_, 1);
  column->addLayout(top);
  column->addWidget(complaint_);
  pages_->addWidget(poses_);
  pages_->addWidget(picker_);
  column->addWidget(pages_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(new JobPanel(jobs), 1);
  for (QPushButton* button : {search_, pick_, close_}) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  column->addLayout(row);
}

void StandDialog::connectParts() {
  connect(choice_, &QComboBox::currentIndexChanged, this, [this] { showStand(choice_->currentData().toInt()); });
  connect(search_, &QPushButton::clicked, this, [this] { controller_.change(AlignStand{stand_}); });
  connect(pick_, &QPushButton::clicked, this, [this] { showPicking(pages_->currentWidget() != picker_); });
  connect(close_, &QPushButton::clicked, this, &StandDialog::reject);
  connect(poses_, &PoseChooser::useRequested, this, [this](int pose, bool despite) {
    controller_.change(ChooseStandPose{stand_, pose, despite});
  });
  connect(picker_, &PointPicker::alignRequested, this, &StandDialog::alignFrom);
  connect(inspector_, &StandInspector::loaded, this, [this] {
    poses_->showSurfaces(inspector_->stand());
    picker_->showSurfaces(inspector_->stand());
    showAlignment();
  });
  connect(inspector_, &StandInspector::looked, this,
          [this](int pose) { poses_->setLook(pose, inspector_->looks()[static_cast<std::size_t>(pose)]); });
  connect(inspector_, &StandInspector::ended, this, &StandDialog::refresh);
  connect(inspector_, &StandInspector::failed, this, [this](const QString& why) {
    complaint_->setText(why);
    complaint_->show();
  });
  connect(&controller_, &SessionController::activityChanged, this, &StandDialog::refresh);
  connect(&controller_, &SessionController::stateChanged, this, [this] {
    if (alignment() == shown_) return refresh();
    showPicking(false);
    showAlignment();
  });
}

bool StandDialog::isKnown() const {
  const SharedState& now = controller_.now();
  return now && stand_ <= now->stand() && isOfObject(*now, stand_);
}

std::shared_ptr<const StandAlignment> StandDialog::alignment() const {
  const SharedState& now = controller_.now();
  return now && stand_ <= now->stand() ? now->stands[static_cast<std::size_t>(stand_)].alignment : nullptr;
}

void StandDialog::showStand(int stand) {
  stand_ = stand;
  complaint_->hide();
  poses_->setAlignment(nullptr);
  poses_->showSurfaces({});
  inspector_->load(controller_.now(), stand);
  showPicking(false);
}

// The poses of the last alignment, also once one of them is in use.
void StandDialog::showAlignment() {
  shown_ = alignment();
  poses_->setAlignment(shown_);
  std::vector<Pose> poses;
  if (shown_)
    for (const StandPose& pose : shown_->candidates) poses.push_back(pose.T_object_stand);
  inspector_->lookAt(poses, theme_);
  refresh();
}

void StandDialog::showPicking(bool picking) {
  pages_->setCurrentWidget(picking ? static_cast<QWidget*>(picker_) : poses_);
  pick_->setText(picking ? tr("&Back to the poses") : tr("&Pick points…"));
  pick_->setAccessibleName(QString(pick_->text()).remove(QLatin1Char('&')));
  refresh();
}

// Points that fix no pose are told here, before a step is begun with them.
void StandDialog::alignFrom(const PickedPairs& pairs) {
  const QPointer<StandDialog> self(this);
  jobs_.run<Pose>(
      tr("Looking at the points"),
      [comparison = inspector_->stand().comparison, pairs](const Progress&) {
        return poseOfPairs(comparison->object, comparison->composite, pairs);
      },
      [self, pairs](const JobResult<Pose>& result) {
        if (!self) return;
        self->picker_->complain(result.error);
        if (result.value) self->controller_.change(AlignStand{self->stand_, pairs});
      });
}

void StandDialog::reject() {
  if (!controller_.idle()) return controller_.stop();
  if (pages_->currentWidget() == picker_) return showPicking(false);
  inspector_->stop();
  QDialog::reject();
}

QString StandDialog::whyNot() const {
  if (!controller_.idle()) return tr("Something else is under way.");
  if (isKnown()) return tr("The stand is in place already. Undo the step to choose again.");
  if (!inspector_->stand().comparison) return tr("The stand is not ready to be looked at yet.");
  return {};
}

void StandDialog::refresh() {
  const QString why = whyNot();
  const auto found = alignment();
  verdict_->setText(verdictText(stand_, found.get(), isKnown()));
  poses_->setWhyNot(why);
  picker_->setWhyNot(why);
  allow(*search_, why);
  allow(*pick_, why);
  allow(*choice_, controller_.idle() ? QString() : tr("Something else is under way."));
  close_->setText(controller_.idle() ? tr("Close") : tr("Stop"));
}

}  // namespace vantage
