#pragma once

#include <QGroupBox>

class QLabel;
class QProgressBar;

namespace vantage {

class FigureTable;
struct CompletenessCard;

/// How complete the model is, and what to do about what is missing.
class CompletenessBox final : public QGroupBox {
  Q_OBJECT

 public:
  explicit CompletenessBox(QWidget* parent = nullptr);

  void show(const CompletenessCard& card);

 private:
  QLabel* headline_;
  QProgressBar* reached_;
  QLabel* advice_;
  FigureTable* figures_;
};

}  // namespace vantage
