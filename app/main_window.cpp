#include "main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "acquisition/stand_composites.h"
#include "diagnostics_dialog.h"
#include "docks/job_panel.h"
#include "docks/log_panel.h"
#include "docks/session_log.h"
#include "docks/time_line.h"
#include "docks/view_actions.h"
#include "erase/erasing.h"
#include "help/help_desk.h"
#include "help/help_topic.h"
#include "outlook_text.h"
#include "recent/recent_list.h"
#include "report_pictures.h"
#include "settings/settings_dialog.h"
#include "stand_desk.h"
#include "stand_text.h"
#include "stands/stand_dialog.h"
#include "window/fitting.h"
#include "window/session_door.h"
#include "window/stop_keys.h"
#include "window/tool_bar.h"
#include "window_theme.h"
#include "wizard/next_view_box.h"

namespace vantage {
namespace {

// What the model is given at least; docks on the right make room for it [px].
constexpr int kLeastModelWidth = 240;

// An action that cannot be had now says why.
void allow(QAction& action, const QString& whyNot) {
  action.setEnabled(whyNot.isEmpty());
  action.setToolTip(whyNot);
  action.setStatusTip(whyNot);
}

// The sides from which a report shows the model.
const std::vector kReportSides{CameraPreset::Oblique, CameraPreset::Front, CameraPreset::Top};

}  // namespace

MainWindow::MainWindow(const WindowParts& parts, const Preferences& preferences, QWidget* parent)
    : QMainWindow(parent),
      parts_(parts),
      controller_(parts.controller),
      preferences_(preferences),
      inspector_(new PositionInspector(parts.jobs, this)),
      views_(new SessionViews(parts.controller, *inspector_, parts.jobs, parts.surfaces, this)),
      standDesk_(new StandDesk(parts.controller, parts.jobs, this)),
      wizard_(new Wizard(parts.controller, *standDesk_, parts.surfaces, parts.resources)),
      why_(new WhyPanel(*inspector_)),
      timeLine_(new TimeLine(parts.controller)),
      jobs_(new JobPanel(parts.jobs)),
      log_(new LogPanel),
      recent_(new RecentSessions(parts.controller, parts.jobs, parts.controller.cacheFolder(), this)),
      door_(new SessionDoor(parts.controller, parts.jobs, wizard_->choosePage(), *this)),
      attention_(new Attention(parts.controller, *this)),
      help_(new HelpDesk(parts.resources + QStringLiteral("/manual/operator"), *this)),
      erasing_(new Erasing(parts.controller, parts.jobs, views_->model(), this)),
      notices_(*this) {
  connect(standDesk_, &StandDesk::comparisonWanted, this, [this] { compareStands(standDesk_->stand()); });
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  new StopKeys(controller_, this);
  setAcceptDrops(true);
  addDocks();
  addMenus();
  addTools();
  connectController();
  statusBar()->addWidget(jobs_, 1);
  statusBar()->setSizeGripEnabled(false);
  applyPreferences(preferences);
  layout_->setLeastSize();
  refreshActions();
  refreshTitle();
}

MainWindow::~MainWindow() = default;

QDockWidget* MainWindow::addDock(const QString& title, const QString& name, QWidget* content, Qt::DockWidgetArea area,
                                 const QKeySequence& shortcut) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setAccessibleName(title);
  dock->setWidget(content);
  addDockWidget(area, dock);
  dock->toggleViewAction()->setShortcut(shortcut);
  return dock;
}

void MainWindow::addDocks() {
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  auto* guide = addDock(tr("Session"), QStringLiteral("wizardDock"), wizard_, Qt::LeftDockWidgetArea, {});
  guide->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  auto* objective = addDock(tr("Objective"), QStringLiteral("objectiveDock"), &views_->objective(),
                            Qt::RightDockWidgetArea, tr("Ctrl+2"));
  auto* space = addDock(tr("Positional space"), QStringLiteral("spaceDock"), &views_->space(), Qt::RightDockWidgetArea,
                        tr("Ctrl+3"));
  auto* map = addDock(tr("Map"), QStringLiteral("mapDock"), &views_->map(), Qt::RightDockWidgetArea, tr("Ctrl+4"));
  auto* why = addDock(tr("Why this view"), QStringLiteral("whyDock"), why_, Qt::RightDockWidgetArea, tr("Ctrl+5"));
  splitDockWidget(objective, why, Qt::Vertical);
  tabifyDockWidget(objective, space);
  tabifyDockWidget(space, map);
  objective->raise();
  auto* line =
      addDock(tr("Time line"), QStringLiteral("timeLineDock"), timeLine_, Qt::BottomDockWidgetArea, tr("Ctrl+6"));
  auto* log = addDock(tr("Log"), QStringLiteral("logDock"), log_, Qt::BottomDockWidgetArea, tr("Ctrl+7"));
  tabifyDockWidget(line, log);
  line->raise();
  setHelpTopic(*objective, QStringLiteral("why#where-to-look-next"));
  setHelpTopic(*space, QStringLiteral("why#positional-space"));
  setHelpTopic(*map, QStringLiteral("why#the-map"));
  setHelpTopic(*why, QStringLiteral("why"));
  setHelpTopic(*line, QStringLiteral("sessions#the-time-line"));
  setHelpTopic(*log, QStringLiteral("sessions#the-log"));
  setHelpTopic(views_->model(), QStringLiteral("window#the-model"));
  // After the docks: whoever goes by the keyboard comes by the page first.
  views_->model().setMinimumWidth(kLeastModelWidth);
  setCentralWidget(&views_->model());
  layout_ = std::make_unique<WindowLayout>(*this, *guide, QList{objective, space, map, why, line, log});
}

QAction* MainWindow::addAction(QMenu& menu, const QString& text, const QKeySequence& shortcut,
                               const std::function<void()>& run) {
  QAction* action = menu.addAction(text);
  action->setShortcut(shortcut);
  connect(action, &QAction::triggered, this, run);
  return action;
}

// What cannot always be done: its key works even then, and is told why not.
QAction* MainWindow::addGuarded(QMenu& menu, const QString& text, const QKeySequence& shortcut,
                                const std::function<void()>& run) {
  auto* key = new QShortcut(shortcut, this);
  connect(key, &QShortcut::activated, this, run);
  return addAction(menu, text + QLatin1Char('\t') + shortcut.toString(QKeySequence::NativeText), {}, run);
}

void MainWindow::addMenus() {
  addSessionMenu();
  QMenu& edit = *menuBar()->addMenu(tr("&Edit"));
  edit.setToolTipsVisible(true);
  undo_ = addGuarded(edit, tr("&Undo"), QKeySequence::Undo, [this] { controller_.undo(); });
  redo_ = addGuarded(edit, tr("&Redo"), QKeySequence::Redo, [this] { controller_.redo(); });
  edit.addSeparator();
  erase_ = addGuarded(edit, tr("&Erase from the model…"), tr("Ctrl+Shift+E"), [this] { startErasing(); });
  edit.addSeparator();
  addAction(edit, tr("&Settings…"), tr("Ctrl+,"), [this] { editSettings(); });
  addViewMenu();
  QMenu& help = *menuBar()->addMenu(tr("&Help"));
  help_->addTo(help);
  help.addSeparator();
  addAction(help, tr("Copy &diagnostics…"), {}, [this] { showDiagnostics(); });
  addAction(help, tr("&About Vantage"), {}, [this] { showAbout(); });
}

void MainWindow::addSessionMenu() {
  QMenu& session = *menuBar()->addMenu(tr("&Session"));
  session.setToolTipsVisible(true);
  new_ = addGuarded(session, tr("Ne&w session"), QKeySequence::New, [this] { startNew(); });
  open_ = addGuarded(session, tr("&Open…"), QKeySequence::Open, [this] { door_->openSession(); });
  look_ = addGuarded(session, tr("Open to &look at…"), tr("Ctrl+Shift+O"),
                     [this] { door_->openSession(SessionAccess::Read); });
  QMenu* recent = session.addMenu(tr("Recentl&y opened"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] {
    recent_->refresh();
    fillRecentMenu(*recent, *recent_, [this](const QString& path) { door_->openRecent(path, *recent_); });
  });
  import_ = addGuarded(session, tr("&Import or add scans…"), tr("Ctrl+I"), [this] { door_->importScans({}); });
  close_ = addGuarded(session, tr("&Close"), QKeySequence::Close, [this] {
    if (const QString why = controller_.permissions().whyNotClose(); !why.isEmpty()) return say(why);
    startNew();
  });
  session.addSeparator();
  export_ = addGuarded(session, tr("E&xport the model…"), tr("Ctrl+E"), [this] { handOver(&FinishPage::exportAs); });
  report_ = addGuarded(session, tr("Write t&he report"), tr("Ctrl+R"), [this] { handOver(&FinishPage::report); });
  session.addSeparator();
  run_ = addGuarded(session, tr("&Run or go on"), tr("F5"), [this] { controller_.run(); });
  step_ = addGuarded(session, tr("One &scan"), tr("F6"), [this] { controller_.step(); });
  pause_ = addGuarded(session, tr("&Pause"), tr("F7"), [this] { controller_.pause(); });
  stop_ = addGuarded(session, tr("S&top (also Esc)"), tr("Shift+F5"), [this] { controller_.stop(); });
  turnOver_ = addGuarded(session, tr("T&urn the object over…"), tr("Ctrl+T"), [this] {
    if (const QString why = standDesk_->whyNotTurn(); !why.isEmpty()) return say(why);
    wizard_->goTo(QStringLiteral("turn_over"));
  });
  session.addSeparator();
  stands_ = addGuarded(session, tr("How the stan&ds lie in each other…"), tr("Ctrl+D"), [this] { compareStands(); });
  session.addSeparator();
  addAction(session, tr("Next pa&ge"), tr("Alt+Right"), [this] { wizard_->turnPage(); });
  addAction(session, tr("Page &before"), tr("Alt+Left"), [this] { wizard_->goBack(); });
  session.addSeparator();
  addAction(session, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::addViewMenu() {
  QMenu& view = *menuBar()->addMenu(tr("&View"));
  const std::pair<QString, CameraPreset> presets[] = {
      {tr("&Fit"), CameraPreset::Fit},         {tr("Fr&ont"), CameraPreset::Front},
      {tr("&Top"), CameraPreset::Top},         {tr("Scanner's &eye"), CameraPreset::ScannersEye},
      {tr("Ob&lique"), CameraPreset::Oblique}, {tr("Fit with the ta&ble"), CameraPreset::Everything}};
  int key = 1;
  for (const auto& [text, preset] : presets) {
    QAction* action = addAction(view, text, QKeySequence(QStringLiteral("Alt+%1").arg(key++)),
                                [this, chosen = preset] { views_->model().view().lookFrom(chosen); });
    if (preset == CameraPreset::Fit) fit_ = action;
  }
  view.addSeparator();
  viewTools_ = new ViewActions(views_->model());
  viewTools_->addTo(*view.addMenu(tr("How the model is &drawn")));
  view.addSeparator();
  addAction(view, tr("Objective as bars o&r dial"), tr("Ctrl+B"), [this] {
    ObjectiveView& objective = views_->objective();
    objective.setChartStyle(objective.chartStyle() == ObjectiveStyle::Dial ? ObjectiveStyle::Bars
                                                                           : ObjectiveStyle::Dial);
  });
  addAction(view, tr("&Now"), tr("Ctrl+End"), [this] { controller_.showNow(); });
  view.addSeparator();
  addAction(view, tr("To the &page"), tr("Ctrl+1"), [this] { wizard_->takeKeyboard(); });
  for (QDockWidget* dock : layout_->docks()) view.addAction(dock->toggleViewAction());
  addAction(view, tr("&Usual layout"), {}, [this] { layout_->reset(); });
}

void MainWindow::addTools() {
  tools_ = new ToolBar(this);
  addToolBar(tools_);
  tools_->addTools({{new_, QStringLiteral("new")},
                    {open_, QStringLiteral("open")},
                    {export_, QStringLiteral("export")},
                    {report_, QStringLiteral("report")}});
  tools_->addTools({{undo_, QStringLiteral("undo")}, {redo_, QStringLiteral("redo")}});
  tools_->addTools({{run_, QStringLiteral("run"), ToolTint::Go},
                    {step_, QStringLiteral("scan")},
                    {pause_, QStringLiteral("pause")},
                    {stop_, QStringLiteral("stop"), ToolTint::Halt}});
  tools_->addTools({{fit_, QStringLiteral("fit")},
                    {viewTools_->wireframe, QStringLiteral("wireframe")},
                    {viewTools_->points, QStringLiteral("points")},
                    {viewTools_->backFaces, QStringLiteral("back_faces")},
                    {viewTools_->parallel, QStringLiteral("orthographic")},
                    {viewTools_->section, QStringLiteral("section")},
                    {viewTools_->measure, QStringLiteral("measure")}});
}

void MainWindow::handOver(void (FinishPage::*write)()) {
  if (const QString why = controller_.permissions().whyNotExport(); !why.isEmpty()) return say(why);
  (wizard_->finishPage().*write)();
}

// To the first page; the session that is open stays on the disk as it is.
void MainWindow::startNew() {
  if (controller_.hasSession() && !controller_.idle()) return say(controller_.permissions().whyNotClose());
  if (controller_.hasSession()) controller_.close();
  wizard_->goTo(0);
}

void MainWindow::connectController() {
  connect(&controller_, &SessionController::activityChanged, this, &MainWindow::refreshActions);
  connect(&controller_, &SessionController::stateChanged, this, &MainWindow::refreshActions);
  connect(&controller_, &SessionController::sessionChanged, this, &MainWindow::refreshTitle);
  new SessionLog(controller_, *log_);
  connect(&controller_, &SessionController::failed, this, [this](const QString& what) {
    // What ended a scan, or cannot be read, stands on its page, with the ways on.
    const QString page = wizard_->page().key();
    if (what == controller_.scanFailure() && page == QStringLiteral("acquire")) return;
    if (what == controller_.setUpFailure() && page == QStringLiteral("check")) return;
    notices_.show(what);
  });
  connect(&controller_, &SessionController::damaged, this, [this](const QStringList& losses) {
    for (const QString& loss : losses) log_->addError(loss);
    if (losses.size() == 1) return notices_.show(losses.front());
    notices_.show(
        tr("The session is damaged: %1 things in it could not be read. What is whole is shown.").arg(losses.size()),
        losses);
  });
  connect(door_, &SessionDoor::refused, this, &MainWindow::say);
  connect(&controller_, &SessionController::refused, this, &MainWindow::say);
  connect(&controller_, &SessionController::setUpChanged, this, &MainWindow::refreshActions);
  connect(&wizard_->choosePage(), &ChoosePage::openRequested, door_, [this] { door_->openSession(); });
  connect(&wizard_->choosePage(), &ChoosePage::importRequested, door_, [this] { door_->importScans({}); });
  wizard_->choosePage().showRecent(*recent_);
  connect(&wizard_->choosePage(), &ChoosePage::recentRequested, door_,
          [this](const QString& path) { door_->openRecent(path, *recent_); });
  connect(&wizard_->finishPage(), &FinishPage::reportRequested, this, &MainWindow::writeReport);
  connect(erasing_, &Erasing::refused, this, &MainWindow::say);
  for (WizardPage* page :
       {static_cast<WizardPage*>(&wizard_->reviewPage()), static_cast<WizardPage*>(&wizard_->finishPage())})
    connect(page, &WizardPage::eraseWanted, this, &MainWindow::startErasing);
  connect(&wizard_->acquirePage().nextView(), &NextViewBox::considered, views_, &SessionViews::examine);
  connect(&wizard_->reviewPage(), &ReviewPage::scanChosen, views_, &SessionViews::showScan);
  connect(&wizard_->reviewPage(), &ReviewPage::edgesWanted, views_, &SessionViews::showEdges);
  connect(views_, &SessionViews::positionExamined, &wizard_->acquirePage().nextView(), &NextViewBox::offer);
}

void MainWindow::refreshActions() {
  const Permissions may = controller_.permissions();
  const bool scans = controller_.activity() == Activity::Running && controller_.now();
  jobs_->setOutlook(scans ? outlookText(*controller_.now()) : QString());
  allow(*undo_, may.whyNotUndo());
  allow(*redo_, may.whyNotRedo());
  allow(*erase_, erasing_->desk().whyNot());
  allow(*run_, may.whyNotRun());
  allow(*step_, may.whyNotScan());
  allow(*pause_, controller_.activity() == Activity::Running ? QString() : tr("Nothing runs that could pause."));
  allow(*stop_, controller_.idle() ? tr("Nothing runs that could be stopped.") : QString());
  allow(*close_, may.whyNotClose());
  allow(*new_, controller_.hasSession() ? may.whyNotClose() : QString());
  allow(*open_, may.whyNotOpen());
  allow(*look_, may.whyNotOpen());
  allow(*import_, may.whyNotOpen());
  allow(*export_, may.whyNotExport());
  allow(*report_, may.whyNotExport());
  allow(*turnOver_, standDesk_->whyNotTurn());
  allow(*stands_, may.whyNotCompareStands());
}

// The session of last time is found again by its path.
void MainWindow::refreshTitle() {
  const QString path = controller_.sessionPath();
  const QString whole = QFileInfo(path).absoluteFilePath();
  setWindowTitle(path.isEmpty()           ? tr("Vantage")
                 : controller_.readOnly() ? tr("%1 (to be looked at only) – Vantage").arg(whole)
                                          : tr("%1 – Vantage").arg(whole));
  QSettings file;
  file.setValue(QStringLiteral("lastSession"), path);
  file.sync();
  refreshActions();
}

void MainWindow::startErasing() {
  if (const QString why = erasing_->start(); !why.isEmpty()) say(why);
}

void MainWindow::say(const QString& why) {
  log_->add(why);
  statusBar()->showMessage(why, 8000);
}

void MainWindow::compareStands(std::optional<int> stand) {
  if (const QString why = controller_.permissions().whyNotCompareStands(); !why.isEmpty()) return say(why);
  const std::vector<int> waiting = standsToAlign(*controller_.now());
  const bool waits = stand && std::find(waiting.begin(), waiting.end(), *stand) != waiting.end();
  const StandLook look{parts_.surfaces, themeOf(preferences_.theme),
                       static_cast<NavigationScheme>(preferences_.navigation)};
  auto* dialog = new StandDialog(controller_, parts_.jobs, look, waits ? *stand : waiting.back(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  door_->take(*event);
}

void MainWindow::applyPreferences(const Preferences& preferences) {
  preferences_ = preferences;
  const Theme& theme = themeOf(preferences.theme);
  applyTheme(*qApp, theme);
  views_->setTheme(theme);
  views_->setNavigation(static_cast<NavigationScheme>(preferences.navigation));
  why_->setTheme(theme);
  wizard_->setTheme(theme);
  tools_->setTheme(theme);
  timeLine_->setTheme(theme);
  attention_->setSound(preferences.sound);
}

void MainWindow::editSettings() {
  auto* dialog = new SettingsDialog(preferences_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SettingsDialog::edited, this, [this](const Preferences& edited) {
    applyPreferences(edited);
    savePreferences(edited);
  });
  dialog->open();
}

// With the model as the view shows it. Pictures are packed where the report is written: that takes longer than drawing.
void MainWindow::writeReport(const QString& path) {
  QStringList captions{tr("The model"), tr("From the front"), tr("From above")};
  if (const SharedState& shown = controller_.shown())
    for (QString& caption : captions) caption = pictureCaption(*shown, caption);
  views_->model().view().takePictures(kReportSides, [this, path, captions](const std::vector<QImage>& pictures) {
    controller_.writeReport(path, [pictures, captions](const AcquisitionState& state) {
      HtmlReportOptions options;
      options.version = QCoreApplication::applicationVersion().toStdString();
      for (std::size_t i = 0; i < pictures.size(); ++i)
        if (!pictures[i].isNull())
          options.pictures.push_back(toReportPicture(pictures[i], captions[static_cast<int>(i)]));
      options.viewPictures = scanPictures(state);
      options.standPictures = standPictures(state);
      return options;
    });
  });
}

void MainWindow::restoreLayout() {
  layout_->restore();
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    QMetaObject::invokeMethod(
        this, [this] { layout_->setLeastSize(); }, Qt::QueuedConnection);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  layout_->shown();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  layout_->keep();
  if (!controller_.idle()) controller_.stop();
  event->accept();
}

void MainWindow::openSession(const QString& path) {
  door_->openSession(path);
}

void MainWindow::showDiagnostics() {
  const QStringList log = log_->toPlainText().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  auto* dialog = new DiagnosticsDialog(diagnose(controller_, preferences_, log), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Vantage"),
                     tr("Vantage %1\n\nA scanning workstation that decides where to scan next, after R. Pito, "
                        "\"A Solution to the Next Best View Problem for Automated Surface Acquisition\", 1999.\n\n"
                        "Apache License 2.0. Made with Qt, VTK, Embree, Eigen, OpenMesh, assimp and SQLite.")
                         .arg(QCoreApplication::applicationVersion()));
}

}  // namespace vantage
