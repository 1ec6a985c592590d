#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QSettings>
#include <csignal>
#include <cstdio>
#include <optional>

#include "crash_notice.h"
#include "main_window.h"
#include "program/crash_trace.h"
#include "program/installed_files.h"
#include "program/user_folders.h"
#include "program/version.h"
#include "settings/languages.h"

namespace {

constexpr int kWrongUse = 2;
constexpr const char* kProgram = "vantage";

// A session that was not ended: the window comes back to it.
QString lastSession(const vantage::Preferences& preferences) {
  const QString path = QSettings().value(QStringLiteral("lastSession")).toString();
  return preferences.reopen && QFileInfo::exists(path) ? path : QString();
}

std::filesystem::path crashFolder() {
  const std::string state = vantage::stateDirectory();
  return state.empty() ? std::filesystem::path() : std::filesystem::path(state) / "crashes";
}

void describeArguments(QCommandLineParser& parser) {
  parser.setApplicationDescription(
      QStringLiteral("The scanning workstation: scans an object from positions that it chooses itself."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("session"), QStringLiteral("Session to open, a .vantage file."),
                               QStringLiteral("[S.vantage]"));
}

// What needs no display. @return the exit code, nothing when the window is to be opened
std::optional<int> answerWithoutWindow(int& argc, char** argv) {
  const QCoreApplication application(argc, argv);
  QCommandLineParser parser;
  describeArguments(parser);
  const bool understood = parser.parse(QCoreApplication::arguments());
  if (understood && parser.isSet(QStringLiteral("version")))
    return std::puts(vantage::versionText(kProgram).c_str()) < 0 ? 1 : 0;
  if (understood && parser.isSet(QStringLiteral("help")))
    return std::fputs(parser.helpText().toLocal8Bit().constData(), stdout) < 0 ? 1 : 0;
  return std::nullopt;
}

bool asksWithoutWindow(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    for (const char* option : {"-h", "--help", "--help-all", "-v", "--version"})
      if (std::string_view(argv[i]) == option) return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow is an error of writing, said like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  QCoreApplication::setOrganizationName(QStringLiteral("Vantage"));
  QCoreApplication::setApplicationName(QString::fromLatin1(kProgram));
  QCoreApplication::setApplicationVersion(QString::fromStdString(vantage::programVersion()));
  if (asksWithoutWindow(argc, argv))
    if (const auto answered = answerWithoutWindow(argc, argv)) return *answered;
  if (!crashFolder().empty()) vantage::leaveCrashTraces(kProgram, crashFolder());
  QApplication application(argc, argv);
  QGuiApplication::setDesktopFileName(QString::fromLatin1(kProgram));
  QCommandLineParser parser;
  describeArguments(parser);
  parser.process(application);
  if (parser.positionalArguments().size() > 1) {
    std::fprintf(stderr, "vantage: expected one session at most, see --help\n");
    return kWrongUse;
  }

  const vantage::Preferences preferences = vantage::loadPreferences();
  const vantage::Translation translation(preferences.language);
  vantage::ThreadedJobRunner jobs(preferences.threads > 0 ? preferences.threads : vantage::machineThreads());
  vantage::SessionController controller(jobs, vantage::cacheDirectory());
  const auto crash = vantage::untoldCrash(kProgram, crashFolder());
  // After a crash the session is offered, not opened by itself.
  const QString session = parser.positionalArguments().value(0, crash ? QString() : lastSession(preferences));
  QObject::connect(&controller, &vantage::SessionController::sessionChanged, &controller, [&controller] {
    vantage::nameSessionInCrashTraces(
        QFileInfo(controller.sessionPath()).absoluteFilePath().toLocal8Bit().toStdString());
  });
  vantage::MainWindow window(
      {controller, jobs, vantage::glSurfaces(), QString::fromStdString(vantage::resourceFolder({}))}, preferences);
  window.resize(1280, 800);
  window.restoreLayout();
  window.show();
  if (!session.isEmpty()) controller.open(session);
  if (crash) {
    vantage::tellCrashes(kProgram, crashFolder());
    auto* notice = new vantage::CrashNotice(*crash, &window);
    QObject::connect(notice, &vantage::CrashNotice::sessionWanted, &window, &vantage::MainWindow::openSession);
    notice->open();
  }
  return QApplication::exec();
}
