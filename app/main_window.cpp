#include "main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <algorithm>

#include "acquisition/stand_composites.h"
#include "diagnostics_dialog.h"
#include "docks/job_panel.h"
#include "docks/log_panel.h"
#include "docks/time_line.h"
#include "report_pictures.h"
#include "settings/settings_dialog.h"
#include "stand_desk.h"
#include "stand_text.h"
#include "stands/stand_dialog.h"
#include "window_theme.h"
#include "wizard/import_dialog.h"
#include "wizard/next_view_box.h"

namespace vantage {
namespace {

constexpr int kLayoutVersion = 1;

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
      log_(new LogPanel) {
  connect(standDesk_, &StandDesk::comparisonWanted, this, [this] { compareStands(standDesk_->stand()); });
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setCentralWidget(&views_->model());
  setAcceptDrops(true);
  addDocks();
  addMenus();
  connectController();
  statusBar()->addWidget(jobs_, 1);
  statusBar()->setSizeGripEnabled(false);
  firstLayout_ = saveState(kLayoutVersion);
  applyPreferences(preferences);
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
  auto* guide = addDock(tr("Session"), QStringLiteral("wizardDock"), wizard_, Qt::LeftDockWidgetArea, tr("Ctrl+1"));
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
  resizeDocks({guide, objective}, {340, 350}, Qt::Horizontal);
  resizeDocks({objective, why}, {300, 340}, Qt::Vertical);
  resizeDocks({line}, {96}, Qt::Vertical);
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
  addAction(edit, tr("&Settings…"), tr("Ctrl+,"), [this] { editSettings(); });
  addViewMenu();
  QMenu& help = *menuBar()->addMenu(tr("&Help"));
  addAction(help, tr("Copy &diagnostics…"), {}, [this] { showDiagnostics(); });
  addAction(help, tr("&About Vantage"), {}, [this] { showAbout(); });
}

void MainWindow::addSessionMenu() {
  QMenu& session = *menuBar()->addMenu(tr("&Session"));
  session.setToolTipsVisible(true);
  open_ = addGuarded(session, tr("&Open…"), QKeySequence::Open, [this] { openSession(); });
  import_ = addGuarded(session, tr("&Import or add scans…"), tr("Ctrl+I"), [this] { importScans({}); });
  close_ = addGuarded(session, tr("&Close"), QKeySequence::Close, [this] {
    if (const QString why = controller_.permissions().whyNotClose(); !why.isEmpty()) return say(why);
    controller_.close();
    wizard_->goTo(0);
  });
  session.addSeparator();
  run_ = addGuarded(session, tr("&Run or go on"), tr("F5"), [this] { controller_.run(); });
  step_ = addGuarded(session, tr("One &scan"), tr("F6"), [this] { controller_.step(); });
  pause_ = addGuarded(session, tr("&Pause"), tr("F7"), [this] { controller_.pause(); });
  stop_ = addGuarded(session, tr("S&top"), tr("Shift+F5"), [this] { controller_.stop(); });
  turnOver_ = addGuarded(session, tr("&Turn the object over…"), tr("Ctrl+T"), [this] {
    if (const QString why = standDesk_->whyNotTurn(); !why.isEmpty()) return say(why);
    wizard_->goTo(QStringLiteral("turn_over"));
  });
  session.addSeparator();
  stands_ = addGuarded(session, tr("How the stan&ds lie in each other…"), tr("Ctrl+D"), [this] { compareStands(); });
  session.addSeparator();
  addAction(session, tr("Next pa&ge"), tr("Alt+Right"), [this] { wizard_->goOn(); });
  addAction(session, tr("Page &before"), tr("Alt+Left"), [this] { wizard_->goBack(); });
  session.addSeparator();
  addAction(session, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::addViewMenu() {
  QMenu& view = *menuBar()->addMenu(tr("&View"));
  const std::pair<QString, CameraPreset> presets[] = {{tr("&Fit"), CameraPreset::Fit},
                                                      {tr("Fr&ont"), CameraPreset::Front},
                                                      {tr("&Top"), CameraPreset::Top},
                                                      {tr("Scanner's &eye"), CameraPreset::ScannersEye}};
  int key = 1;
  for (const auto& [text, preset] : presets)
    addAction(view, text, QKeySequence(QStringLiteral("Alt+%1").arg(key++)),
              [this, chosen = preset] { views_->model().view().lookFrom(chosen); });
  view.addSeparator();
  addAction(view, tr("Objective as &bars or dial"), tr("Ctrl+B"), [this] {
    ObjectiveView& objective = views_->objective();
    objective.setChartStyle(objective.chartStyle() == ObjectiveStyle::Dial ? ObjectiveStyle::Bars
                                                                           : ObjectiveStyle::Dial);
  });
  addAction(view, tr("&Now"), tr("Ctrl+End"), [this] { controller_.showNow(); });
  view.addSeparator();
  for (auto* dock : findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly)) view.addAction(dock->toggleViewAction());
  addAction(view, tr("&Usual layout"), {}, [this] { resetLayout(); });
}

void MainWindow::connectController() {
  connect(&controller_, &SessionController::activityChanged, this, &MainWindow::refreshActions);
  connect(&controller_, &SessionController::stateChanged, this, &MainWindow::refreshActions);
  connect(&controller_, &SessionController::sessionChanged, this, &MainWindow::refreshTitle);
  connect(&controller_, &SessionController::message, log_, &LogPanel::add);
  connect(&controller_, &SessionController::failed, log_, &LogPanel::addError);
  connect(&controller_, &SessionController::failed, this, [this](const QString& what) {
    // What ended a scan stands on its page, with the ways on.
    if (what == controller_.scanFailure() && wizard_->acquirePage().isVisible()) return;
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Vantage"), what, QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
  connect(&controller_, &SessionController::refused, this, &MainWindow::say);
  connect(&controller_, &SessionController::setUpChanged, this, &MainWindow::refreshActions);
  connect(&controller_, &SessionController::written, log_,
          [this](const QString& path) { log_->add(tr("Written: %1").arg(path)); });
  connect(&controller_, &SessionController::stateChanged, log_, [this] {
    if (controller_.present().cursor() < static_cast<int>(controller_.present().moments().size()))
      log_->add(controller_.present().moments()[static_cast<std::size_t>(controller_.present().cursor())].text);
  });
  connect(&wizard_->choosePage(), &ChoosePage::openRequested, this, [this] { openSession(); });
  connect(&wizard_->choosePage(), &ChoosePage::importRequested, this, [this] { importScans({}); });
  connect(&wizard_->finishPage(), &FinishPage::reportRequested, this, &MainWindow::writeReport);
  connect(&wizard_->acquirePage().nextView(), &NextViewBox::considered, views_, &SessionViews::examine);
  connect(views_, &SessionViews::positionExamined, &wizard_->acquirePage().nextView(), &NextViewBox::offer);
}

void MainWindow::refreshActions() {
  const Permissions may = controller_.permissions();
  allow(*undo_, may.whyNotUndo());
  allow(*redo_, may.whyNotRedo());
  allow(*run_, may.whyNotRun());
  allow(*step_, may.whyNotScan());
  allow(*pause_, controller_.activity() == Activity::Running ? QString() : tr("Nothing runs that could pause."));
  allow(*stop_, controller_.idle() ? tr("Nothing runs that could be stopped.") : QString());
  allow(*close_, may.whyNotClose());
  allow(*open_, may.whyNotOpen());
  allow(*import_, may.whyNotOpen());
  allow(*turnOver_, standDesk_->whyNotTurn());
  allow(*stands_, may.whyNotCompareStands());
}

// The session of last time is found again by its path.
void MainWindow::refreshTitle() {
  const QString path = controller_.sessionPath();
  setWindowTitle(path.isEmpty() ? tr("Vantage") : tr("%1 – Vantage").arg(QFileInfo(path).absoluteFilePath()));
  QSettings file;
  file.setValue(QStringLiteral("lastSession"), path);
  file.sync();
  refreshActions();
}

void MainWindow::say(const QString& why) {
  log_->add(why);
  statusBar()->showMessage(why, 8000);
}

void MainWindow::openSession() {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return say(why);
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a session"), {}, tr("Sessions (*.vantage)"));
  if (!path.isEmpty()) openSession(path);
}

void MainWindow::openSession(const QString& path) {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return say(why);
  if (controller_.hasSession() && QFileInfo(path) == QFileInfo(controller_.sessionPath()))
    return say(tr("%1 is open already.").arg(path));
  controller_.open(path);
}

// Into the session that is open, where it can have more; else into a new one.
void MainWindow::importScans(const QStringList& files) {
  if (const QString why = controller_.permissions().whyNotOpen(); !why.isEmpty()) return say(why);
  const bool intoOpen = controller_.permissions().whyNotAddScans().isEmpty();
  auto* dialog =
      new ImportDialog(controller_, intoOpen ? ImportDialog::Into::OpenSession : ImportDialog::Into::NewSession, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->suggest(wizard_->choosePage().importChoice());
  dialog->addFiles(files);
  dialog->open();
}

void MainWindow::compareStands(std::optional<int> stand) {
  if (const QString why = controller_.permissions().whyNotCompareStands(); !why.isEmpty()) return say(why);
  const std::vector<int> waiting = standsToAlign(*controller_.now());
  const bool waits = stand && std::find(waiting.begin(), waiting.end(), *stand) != waiting.end();
  const StandLook look{parts_.surfaces, preferences_.theme == 1 ? darkTheme() : lightTheme(),
                       static_cast<NavigationScheme>(preferences_.navigation)};
  auto* dialog = new StandDialog(controller_, parts_.jobs, look, waits ? *stand : waiting.back(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowModality(Qt::WindowModal);
  dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

// A session is opened; everything else is taken for scans.
void MainWindow::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) files << url.toLocalFile();
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  if (files.size() == 1 && files.front().endsWith(QStringLiteral(".vantage"))) return openSession(files.front());
  importScans(files);
}

void MainWindow::applyPreferences(const Preferences& preferences) {
  preferences_ = preferences;
  const Theme& theme = preferences.theme == 1 ? darkTheme() : lightTheme();
  applyTheme(*qApp, theme);
  views_->setTheme(theme);
  views_->setNavigation(static_cast<NavigationScheme>(preferences.navigation));
  why_->setTheme(theme);
  wizard_->setTheme(theme);
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
  const QSettings file;
  restoreGeometry(file.value(QStringLiteral("window/geometry")).toByteArray());
  restoreState(file.value(QStringLiteral("window/layout")).toByteArray(), kLayoutVersion);
}

void MainWindow::resetLayout() {
  restoreState(firstLayout_, kLayoutVersion);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  QSettings file;
  file.setValue(QStringLiteral("window/geometry"), saveGeometry());
  file.setValue(QStringLiteral("window/layout"), saveState(kLayoutVersion));
  if (!controller_.idle()) controller_.stop();
  event->accept();
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
                        "\"A Solution to the Next Best View Problem for Automated Surface Acquisition\", 1999.")
                         .arg(QCoreApplication::applicationVersion()));
}

}  // namespace vantage
