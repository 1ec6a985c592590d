#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <csignal>
#include <cstdio>

#include "cli/cache_directory.h"
#include "main_window.h"

namespace {

constexpr int kWrongUse = 2;

// Scanners and objects: beside the program when it is installed, in the source tree when it is not.
QString resourceFolder() {
  const QDir program(QCoreApplication::applicationDirPath());
  const QString installed = program.absoluteFilePath(QStringLiteral("../share/vantage"));
  return QFileInfo::exists(installed) ? QDir::cleanPath(installed) : QStringLiteral(VANTAGE_RESOURCES);
}

// A session that was not ended: the window comes back to it.
QString lastSession(const vantage::Preferences& preferences) {
  const QString path = QSettings().value(QStringLiteral("lastSession")).toString();
  return preferences.reopen && QFileInfo::exists(path) ? path : QString();
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may not grow is an error of writing, said like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  QCoreApplication::setOrganizationName(QStringLiteral("Vantage"));
  QCoreApplication::setApplicationName(QStringLiteral("vantage"));
  QCoreApplication::setApplicationVersion(QStringLiteral(VANTAGE_VERSION));
  QApplication application(argc, argv);
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QObject::tr("The scanning workstation: scans an object from positions that it chooses itself."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("session"), QObject::tr("Session to open, a .vantage file."),
                               QStringLiteral("[S.vantage]"));
  parser.process(application);
  if (parser.positionalArguments().size() > 1) {
    std::fprintf(stderr, "vantage: expected one session at most, see --help\n");
    return kWrongUse;
  }

  const vantage::Preferences preferences = vantage::loadPreferences();
  vantage::ThreadedJobRunner jobs(preferences.threads > 0 ? preferences.threads : vantage::machineThreads());
  vantage::SessionController controller(jobs, vantage::cacheDirectory());
  const QString session = parser.positionalArguments().value(0, lastSession(preferences));
  vantage::MainWindow window({controller, jobs, vantage::glSurfaces(), resourceFolder()}, preferences);
  window.resize(1280, 800);
  window.restoreLayout();
  window.show();
  if (!session.isEmpty()) controller.open(session);
  return QApplication::exec();
}
