#pragma once

#include <QMap>
#include <QWidget>

#include "job_runner.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace vantage {

/// What is being computed: the step, how far it is, and a button to cancel it. Shows the job that was started last;
/// work without a title is not shown.
class JobPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit JobPanel(JobRunner& jobs, QWidget* parent = nullptr);

 public slots:
  /// What is known of how long it still takes; empty for nothing.
  void setOutlook(const QString& outlook);

 private:
  void refresh();

  struct Shown {
    QString title;
    QString step;
    double fraction = 0.0;
  };
  JobRunner& jobs_;
  QMap<int, Shown> running_;
  QString outlook_;
  QLabel* text_;
  QProgressBar* bar_;
  QToolButton* cancel_;
};

/// The name of an engine's step for people: "project_seen" is "projecting what was seen".
[[nodiscard]] QString stepText(const QString& step);

}  // namespace vantage
