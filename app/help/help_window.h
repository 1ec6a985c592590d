#pragma once

#include <QWidget>

#include "help/manual.h"

class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace vantage {

class ManualBrowser;

/// The manual in a window of its own, beside whatever else is open: contents or what a search found on the left, the
/// page on the right. Esc closes it, Alt+Left and Alt+Right go back and forward, Ctrl+F searches, F3 goes to the next
/// place of the words.
class HelpWindow final : public QWidget {
  Q_OBJECT

 public:
  /// @param folder that has the manual's contents.md
  explicit HelpWindow(const QString& folder);

  /// Opens the place, or the contents where there is no such topic, and comes to the front.
  void showTopic(const QString& topic);
  /// Lists the sections that have the words, and marks them; without words the contents.
  void search(const QString& words);

  [[nodiscard]] const Manual& manual() const { return manual_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void build();
  void addKeys();
  void listContents();
  void open(const QString& topic);
  void followList(const QListWidgetItem& item);

  Manual manual_;
  QLineEdit* words_;
  QListWidget* list_;
  ManualBrowser* page_;
};

}  // namespace vantage
