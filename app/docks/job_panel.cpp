#include "docks/job_panel.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <utility>

namespace vantage {

QString stepText(const QString& step) {
  static constexpr std::pair<const char*, const char*> kTexts[] = {
      {"scan", QT_TRANSLATE_NOOP("JobPanel", "scanning")},
      {"register", QT_TRANSLATE_NOOP("JobPanel", "registering")},
      {"prepare_views", QT_TRANSLATE_NOOP("JobPanel", "preparing the views")},
      {"refine", QT_TRANSLATE_NOOP("JobPanel", "refining all views")},
      {"integrate", QT_TRANSLATE_NOOP("JobPanel", "merging")},
      {"void_patches", QT_TRANSLATE_NOOP("JobPanel", "finding what is unseen")},
      {"project_void", QT_TRANSLATE_NOOP("JobPanel", "projecting what is unseen")},
      {"project_seen", QT_TRANSLATE_NOOP("JobPanel", "projecting what was seen")},
      {"choose", QT_TRANSLATE_NOOP("JobPanel", "choosing the next view")},
      {"zippering", QT_TRANSLATE_NOOP("JobPanel", "joining surfaces")},
      {"consensus", QT_TRANSLATE_NOOP("JobPanel", "moving the surface to where the views agree")},
      {"prepare", QT_TRANSLATE_NOOP("JobPanel", "preparing")},
      {"search", QT_TRANSLATE_NOOP("JobPanel", "searching")},
      {"check", QT_TRANSLATE_NOOP("JobPanel", "checking")},
      {"calibrate", QT_TRANSLATE_NOOP("JobPanel", "finding the axis")},
      {"close openings", QT_TRANSLATE_NOOP("JobPanel", "closing openings")},
      {"simplify", QT_TRANSLATE_NOOP("JobPanel", "taking fewer triangles")},
      {"read profile", QT_TRANSLATE_NOOP("JobPanel", "reading the profile")},
      {"read object", QT_TRANSLATE_NOOP("JobPanel", "reading the object")},
      {"read session", QT_TRANSLATE_NOOP("JobPanel", "reading the session")},
      {"read scan", QT_TRANSLATE_NOOP("JobPanel", "reading the scan")},
      {"read scans", QT_TRANSLATE_NOOP("JobPanel", "reading the scans")},
      {"reading the scan", QT_TRANSLATE_NOOP("JobPanel", "reading the scan")},
      {"reading a recorded scan", QT_TRANSLATE_NOOP("JobPanel", "reading a recorded scan")},
      {"positional space of the scanner", QT_TRANSLATE_NOOP("JobPanel", "positional space of the scanner")}};
  for (const auto& [key, text] : kTexts)
    if (step == QLatin1String(key)) return QCoreApplication::translate("JobPanel", text);
  // "reading scan_07.ply", as a folder that is watched says.
  const QLatin1String reading("reading ");
  return step.startsWith(reading) ? QCoreApplication::translate("JobPanel", "reading %1").arg(step.mid(reading.size()))
                                  : step;
}

JobPanel::JobPanel(JobRunner& jobs, QWidget* parent)
    : QWidget(parent), jobs_(jobs), text_(new QLabel), bar_(new QProgressBar), cancel_(new QToolButton) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 0);
  row->addWidget(text_, 1);
  row->addWidget(bar_);
  row->addWidget(cancel_);
  // As high when it is idle, so that nothing jumps.
  setFixedHeight(cancel_->sizeHint().height() + 6);
  bar_->setRange(0, 1000);
  bar_->setFixedWidth(180);
  text_->setMinimumWidth(1);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setObjectName(QStringLiteral("cancelJob"));
  cancel_->setAccessibleName(tr("Cancel what is being computed"));
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (!running_.isEmpty()) jobs_.cancel(running_.lastKey());
  });
  connect(&jobs, &JobRunner::started, this, [this](int job, const QString& title) {
    if (!title.isEmpty()) running_[job] = {title, {}, 0.0};
    refresh();
  });
  connect(&jobs, &JobRunner::progressed, this, [this](int job, double fraction, const QString& step) {
    if (!running_.contains(job)) return;
    running_[job].fraction = fraction;
    running_[job].step = step;
    refresh();
  });
  connect(&jobs, &JobRunner::finished, this, [this](int job) {
    running_.remove(job);
    refresh();
  });
  refresh();
}

void JobPanel::setOutlook(const QString& outlook) {
  outlook_ = outlook;
  refresh();
}

void JobPanel::refresh() {
  const bool busy = !running_.isEmpty();
  bar_->setVisible(busy);
  cancel_->setVisible(busy);
  if (!busy) return text_->setText(tr("Ready"));
  const Shown& shown = running_.last();
  const QString what = shown.step.isEmpty() ? shown.title : tr("%1: %2").arg(shown.title, stepText(shown.step));
  text_->setText(outlook_.isEmpty() ? what : tr("%1; %2").arg(what, outlook_));
  bar_->setValue(static_cast<int>(1000.0 * shown.fraction));
}

}  // namespace vantage
