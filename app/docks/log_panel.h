#pragma once

#include <QPlainTextEdit>

namespace vantage {

/// What happened, line by line with the time of day. Keeps the last few thousand lines.
class LogPanel final : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogPanel(QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override { return {400, 90}; }

 public slots:
  void add(const QString& line);
  void addError(const QString& line);
};

}  // namespace vantage
