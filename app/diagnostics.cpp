#include "diagnostics.h"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QRegularExpression>
#include <QScreen>
#include <QSysInfo>
#include <QThread>
#include <algorithm>

#include "acquisition/setting_field.h"
#include "acquisition/settings_table.h"
#include "devices/rig_description.h"
#include "devices/serial/port_list.h"
#include "program/version.h"

namespace vantage {
namespace {

constexpr int kLastLines = 200;

using Rows = std::vector<std::pair<QString, QString>>;

QString asText(GLenum name, QOpenGLFunctions& functions) {
  const auto* text = reinterpret_cast<const char*>(functions.glGetString(name));
  return text == nullptr ? QStringLiteral("?") : QString::fromLocal8Bit(text);
}

// What OpenGL says of itself, in a context of its own.
QString openGl() {
  QOpenGLContext context;
  QOffscreenSurface surface;
  surface.create();
  if (!context.create() || !context.makeCurrent(&surface)) return QStringLiteral("none");
  QOpenGLFunctions& functions = *context.functions();
  const QString text =
      asText(GL_VENDOR, functions) + ", " + asText(GL_RENDERER, functions) + ", " + asText(GL_VERSION, functions);
  context.doneCurrent();
  return text;
}

Rows machineRows() {
  Rows rows{{QStringLiteral("system"), QSysInfo::prettyProductName()},
            {QStringLiteral("kernel"), QSysInfo::kernelType() + " " + QSysInfo::kernelVersion()},
            {QStringLiteral("processor"),
             QSysInfo::currentCpuArchitecture() + ", " + QString::number(QThread::idealThreadCount()) + " threads"},
            {QStringLiteral("Qt"), QString::fromLatin1(qVersion())},
            {QStringLiteral("platform"), QGuiApplication::platformName()}};
  for (const QScreen* screen : QGuiApplication::screens())
    rows.emplace_back(QStringLiteral("screen"), QStringLiteral("%1x%2, scale %3")
                                                    .arg(screen->size().width())
                                                    .arg(screen->size().height())
                                                    .arg(screen->devicePixelRatio()));
  rows.emplace_back(QStringLiteral("OpenGL"), openGl());
  return rows;
}

Rows deviceRows(const RigDescription& rig) {
  Rows rows{{QStringLiteral("sensor"), QString::fromStdString(describe(rig.sensor))},
            {QStringLiteral("table"), QString::fromStdString(describe(rig.table))},
            {QStringLiteral("calibration"),
             rig.calibration.empty() ? QStringLiteral("none") : QString::fromStdString(rig.calibration)}};
  for (const PortDescription& port : serialPorts()) {
    // Serial numbers tell one machine from all others: they are nobody's business.
    PortDescription told = port;
    told.serialNumber.clear();
    rows.emplace_back(QStringLiteral("serial port"), QFileInfo(QString::fromStdString(port.path)).fileName() + " " +
                                                         QString::fromStdString(describe(told)));
  }
  return rows;
}

Rows settingRows(const AcquisitionSettings& settings, const Preferences& preferences) {
  Rows rows;
  for (const SettingField& field : settingFields())
    if (const std::string value = textOf(field, settings); value != textOf(field, {}))
      rows.emplace_back(QString::fromStdString(std::string(field.key)), QString::fromStdString(value));
  rows.emplace_back(QStringLiteral("theme"), preferences.theme == 1 ? QStringLiteral("dark") : QStringLiteral("light"));
  rows.emplace_back(QStringLiteral("threads"),
                    preferences.threads == 0 ? QStringLiteral("all") : QString::number(preferences.threads));
  return rows;
}

// Every name that the operator chose, and what they are named below.
QStringList filesOf(const SessionController& controller) {
  const SetUpChoice& choice = controller.choice();
  QStringList files{controller.sessionPath(), QString::fromStdString(choice.scanner),
                    QString::fromStdString(choice.folder), QString::fromStdString(choice.rig.calibration),
                    QString::fromStdString(choice.settings.simulation.object)};
  if (const SharedState& state = controller.now()) files << QString::fromStdString(state->settings.simulation.object);
  if (const auto* folder = std::get_if<FolderDevice>(&choice.rig.sensor))
    files << QString::fromStdString(folder->folder);
  if (const auto* replay = std::get_if<ReplayDevice>(&choice.rig.sensor))
    files << QString::fromStdString(replay->session);
  for (const QString& file : QStringList(files))
    if (!file.isEmpty()) files << QFileInfo(file).absoluteFilePath() << QFileInfo(file).fileName();
  files << QDir::homePath() << QDir::home().dirName();
  return files;
}

QString section(const QString& title, const Rows& rows) {
  QString text = "\n[" + title + "]\n";
  for (const auto& [name, value] : rows) text += name + ": " + value + "\n";
  return text;
}

}  // namespace

Diagnostics diagnose(const SessionController& controller, const Preferences& preferences, const QStringList& log) {
  const AcquisitionSettings& settings = controller.now() ? controller.now()->settings : controller.choice().settings;
  return {versionText("vantage"),
          machineRows(),
          deviceRows(controller.choice().rig),
          settingRows(settings, preferences),
          log.mid(std::max<qsizetype>(0, log.size() - kLastLines)),
          filesOf(controller)};
}

QString withoutFiles(QString text, const QStringList& files) {
  QStringList names = files;
  names.removeAll(QString());
  // Longer names first: they may have shorter ones in them.
  std::sort(names.begin(), names.end(), [](const QString& a, const QString& b) { return a.size() > b.size(); });
  for (const QString& name : names)
    if (name.size() > 1) text.replace(name, QStringLiteral("<file>"));
  static const QRegularExpression path(QStringLiteral(R"([^\s"'<>()]*/[^\s"'<>()]*)"));
  static const QRegularExpression ending(QStringLiteral(R"([^\s"'<>()/]*[^\W\d]\w*\.[A-Za-z]\w{1,7}\b)"));
  text.replace(path, QStringLiteral("<file>"));
  return text.replace(ending, QStringLiteral("<file>"));
}

QString textOf(const Diagnostics& diagnostics, bool withFiles) {
  const auto told = [&](const QString& text) { return withFiles ? text : withoutFiles(text, diagnostics.files); };
  Rows settings;
  // Keys have dots in them and are no names of files.
  for (const auto& [name, value] : diagnostics.settings) settings.emplace_back(name, told(value));
  return QString::fromStdString(diagnostics.version) + "\n" + section(QStringLiteral("machine"), diagnostics.machine) +
         told(section(QStringLiteral("devices"), diagnostics.devices)) + section(QStringLiteral("settings"), settings) +
         "\n[log]\n" + told(diagnostics.log.join('\n')) + "\n";
}

}  // namespace vantage
