#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>

#include "docks/why_panel.h"
#include "session_views.h"
#include "settings/preferences.h"
#include "window/attention.h"
#include "window/notices.h"
#include "window/window_layout.h"
#include "wizard/wizard.h"

namespace vantage {

class Erasing;
class HelpDesk;
class JobPanel;
class LogPanel;
class RecentSessions;
class SessionDoor;
class StandDesk;
class TimeLine;
class ToolBar;
class ViewActions;

/// What the window is made with.
struct WindowParts {
  SessionController& controller;
  JobRunner& jobs;
  SurfaceMaker surfaces;
  QString resources;  ///< folder with scanners/ and objects/
};

/// The window: views in the middle and in docks, menus, and what the operator set for them. Knows no algorithm.
class MainWindow final : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const WindowParts& parts, const Preferences& preferences, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Wizard& wizard() { return *wizard_; }
  [[nodiscard]] SessionViews& views() { return *views_; }
  [[nodiscard]] HelpDesk& help() { return *help_; }
  [[nodiscard]] Erasing& erasing() { return *erasing_; }

  void applyPreferences(const Preferences& preferences);
  /// Shows how a stand that is not in place yet lies in the object; without a number that of the last of them.
  void compareStands(std::optional<int> stand = {});
  /// Opens a session instead of the one that is open, or says why that cannot be done now.
  void openSession(const QString& path);
  /// Docks as the operator left them.
  void restoreLayout();

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QDockWidget* addDock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area,
                       const QKeySequence& shortcut);
  void addDocks();
  void addMenus();
  void addSessionMenu();
  void addViewMenu();
  void addTools();
  void startNew();
  void handOver(void (FinishPage::*write)());
  QAction* addAction(QMenu& menu, const QString& text, const QKeySequence& shortcut, const std::function<void()>& run);
  QAction* addGuarded(QMenu& menu, const QString& text, const QKeySequence& shortcut, const std::function<void()>& run);
  void connectController();
  void refreshActions();
  void refreshTitle();
  void say(const QString& why);
  void startErasing();
  void editSettings();
  void writeReport(const QString& path);
  void showDiagnostics();
  void showAbout();

  WindowParts parts_;
  SessionController& controller_;
  Preferences preferences_;
  PositionInspector* inspector_;
  SessionViews* views_;
  StandDesk* standDesk_;
  Wizard* wizard_;
  WhyPanel* why_;
  TimeLine* timeLine_;
  JobPanel* jobs_;
  LogPanel* log_;
  RecentSessions* recent_;
  SessionDoor* door_;
  Attention* attention_;
  HelpDesk* help_;
  Erasing* erasing_;
  Notices notices_;
  ToolBar* tools_ = nullptr;
  ViewActions* viewTools_ = nullptr;
  std::unique_ptr<WindowLayout> layout_;
  QAction* new_ = nullptr;
  QAction* open_ = nullptr;
  QAction* look_ = nullptr;
  QAction* import_ = nullptr;
  QAction* export_ = nullptr;
  QAction* report_ = nullptr;
  QAction* run_ = nullptr;
  QAction* step_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* stop_ = nullptr;
  QAction* stands_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* erase_ = nullptr;
  QAction* close_ = nullptr;
  QAction* turnOver_ = nullptr;
  QAction* fit_ = nullptr;
};

}  // namespace vantage
