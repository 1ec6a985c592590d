#pragma once

#include <QObject>
#include <memory>

class QKeyEvent;
class QMenu;
class QWidget;

namespace vantage {

class HelpWindow;

/// Opens the manual: F1 anywhere in the program, also in a dialog, at the page that is about what has the keyboard.
class HelpDesk final : public QObject {
  Q_OBJECT

 public:
  /// @param folder that has the manual's contents.md
  /// @param window whose topic counts where nothing has the keyboard
  HelpDesk(QString folder, QWidget& window);
  ~HelpDesk() override;

  /// Adds the manual, what messages mean, and the keys.
  void addTo(QMenu& menu);
  void showTopic(const QString& topic);
  /// The window of the manual; made when it is first asked for.
  [[nodiscard]] HelpWindow& window();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QString topicOfNow() const;

  QString folder_;
  QWidget& mainWindow_;
  std::unique_ptr<HelpWindow> window_;
};

}  // namespace vantage
