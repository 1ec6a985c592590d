#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "wizard/acquire_page.h"
#include "wizard/calibrate_page.h"
#include "wizard/check_page.h"
#include "wizard/choose_page.h"
#include "wizard/finish_page.h"
#include "wizard/review_page.h"
#include "wizard/turn_over_page.h"

class QStackedWidget;

namespace vantage {

/// The way through a session, page by page: where one is, what the page asks, and what happens next. Going back loses
/// nothing; the page is kept in the session.
class Wizard final : public QWidget {
  Q_OBJECT

 public:
  Wizard(SessionController& controller, StandDesk& stands, const SurfaceMaker& surfaces, const QString& resources,
         QWidget* parent = nullptr);

  void setTheme(const Theme& theme);

  void goTo(int index);
  void goTo(const QString& key);
  [[nodiscard]] int pageCount() const { return static_cast<int>(pages_.size()); }
  [[nodiscard]] int index() const { return index_; }
  [[nodiscard]] const WizardPage& page() const { return *pages_[static_cast<std::size_t>(index_)]; }

  [[nodiscard]] ChoosePage& choosePage() { return *choose_; }
  [[nodiscard]] AcquirePage& acquirePage() { return *acquire_; }
  [[nodiscard]] ReviewPage& reviewPage() { return *review_; }
  [[nodiscard]] FinishPage& finishPage() { return *finish_; }

 public slots:
  /// What the button below the page does: from the last one it ends the session.
  void goOn();
  /// The keyboard goes to the first thing on the page that takes it.
  void takeKeyboard();
  /// To the next page where there is one: a key that was pressed once too often ends nothing.
  void turnPage();
  void goBack();

 private:
  void build();
  void addPage(WizardPage* page);
  /// The next page that applies from there in steps of one; nothing when there is none.
  [[nodiscard]] std::optional<int> pageFrom(int index, int step) const;
  void refresh();
  void reopen();

  SessionController& controller_;
  ChoosePage* choose_;
  AcquirePage* acquire_;
  TurnOverPage* turnOver_;
  ReviewPage* review_;
  FinishPage* finish_;
  std::vector<WizardPage*> pages_;
  int index_ = 0;
  bool hadSession_ = false;

  QLabel* where_;
  QLabel* title_;
  QLabel* whatNext_;
  QStackedWidget* stack_;
  QPushButton* back_;
  QPushButton* next_;
};

}  // namespace vantage
