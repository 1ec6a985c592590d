#include "recent/session_digest.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <algorithm>
#include <optional>

#include "geometry/measures.h"
#include "scenes/model_scene.h"
#include "scenes/ray_picture.h"
#include "session/session.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(SessionDigest)
};

constexpr QSize kPicture(192, 144);  // [px]
const QString kStamp = QStringLiteral("stamp");
const QString kTermination = QStringLiteral("termination");
const QString kScans = QStringLiteral("scans");
const QString kDrawn = QStringLiteral("drawn");

// What was written lately may be in the log beside the session. Who only reads leaves an empty one.
QStringList filesOf(const QString& session) {
  const QString log = session + QStringLiteral("-wal");
  return QFileInfo(log).size() > 0 ? QStringList{session, log} : QStringList{session};
}

// Another after every change of the session. The first word: how it is made, for when that changes.
QString stampOf(const QString& session) {
  QStringList parts{QStringLiteral("1")};
  for (const QString& name : filesOf(session)) {
    const QFileInfo file(name);
    parts << QString::number(file.size()) << QString::number(file.lastModified().toMSecsSinceEpoch());
  }
  return parts.join(QLatin1Char('/'));
}

QString keptFile(const QString& session, const std::string& cacheFolder) {
  const QByteArray name =
      QCryptographicHash::hash(QFileInfo(session).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1).toHex();
  return QString::fromStdString(cacheFolder) + QStringLiteral("/recent/") + QString::fromLatin1(name) +
         QStringLiteral(".png");
}

std::optional<SessionDigest> kept(const QString& session, const QString& stamp, const std::string& cacheFolder) {
  const QImage image(keptFile(session, cacheFolder));
  if (image.isNull() || image.text(kStamp) != stamp) return std::nullopt;
  SessionDigest digest;
  digest.termination =
      static_cast<Termination>(std::clamp(image.text(kTermination).toInt(), 0, static_cast<int>(kLastTermination)));
  digest.scans = image.text(kScans).toInt();
  if (!image.text(kDrawn).isEmpty()) digest.picture = image;
  return digest;
}

// One file with all of it, whole or not at all. Where it cannot be kept it is made again the next time.
void keep(const SessionDigest& digest, const QString& session, const QString& stamp, const std::string& cacheFolder) {
  QImage image = digest.picture;
  if (image.isNull()) {
    image = QImage(1, 1, QImage::Format_RGB32);
    image.fill(Qt::black);
  }
  image.setText(kStamp, stamp);
  image.setText(kTermination, QString::number(static_cast<int>(digest.termination)));
  image.setText(kScans, QString::number(digest.scans));
  if (!digest.picture.isNull()) image.setText(kDrawn, QStringLiteral("1"));
  const QString path = keptFile(session, cacheFolder);
  QDir().mkpath(QFileInfo(path).absolutePath());
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly) && image.save(&file, "PNG")) file.commit();
}

QImage drawn(const Mesh& mesh, const Progress& progress) {
  const Theme& theme = lightTheme();
  const RayCaster caster(mesh);
  const std::vector<PicturedSurface> surfaces{
      {&caster, Pose::Identity(), [rgb = toRgb(theme.surface)](std::uint32_t) { return rgb; }}};
  const Camera camera = presetCamera(CameraPreset::Oblique, boundingBox(mesh), {}, std::nullopt,
                                     static_cast<double>(kPicture.width()) / kPicture.height());
  return rayPicture(surfaces, camera, kPicture, theme, progress);
}

SessionDigest readDigest(const QString& path, const Progress& progress) {
  const Session session = Session::open(path.toStdString(), SessionAccess::Read, progress.part(0.0, 0.5));
  const History& history = session.history();
  const StateOutline& outline = *history.current().outline;
  SessionDigest digest;
  digest.termination = outline.termination;
  digest.scans = static_cast<int>(countScans(outline, ScanStatus::In));
  const auto model = session.model(history.cursor());
  if (model && !model->mesh.triangles.empty()) digest.picture = drawn(model->mesh, progress.part(0.5, 1.0));
  return digest;
}

}  // namespace

QDateTime changeOf(const QString& session) {
  if (!QFileInfo::exists(session)) return {};
  QDateTime last;
  for (const QString& name : filesOf(session))
    if (const QFileInfo file(name); file.exists() && (!last.isValid() || file.lastModified() > last))
      last = file.lastModified();
  return last;
}

SessionDigest digestOf(const QString& session, const std::string& cacheFolder, const Progress& progress) {
  const QDateTime changed = changeOf(session);
  // Of before it is read: what changes meanwhile is read the next time.
  const QString stamp = stampOf(session);
  std::optional<SessionDigest> digest = cacheFolder.empty() ? std::nullopt : kept(session, stamp, cacheFolder);
  if (!digest) {
    digest = readDigest(session, progress);
    if (!cacheFolder.empty()) keep(*digest, session, stamp, cacheFolder);
  }
  digest->changed = changed;
  return *digest;
}

void forgetDigest(const QString& session, const std::string& cacheFolder) {
  if (!cacheFolder.empty()) QFile::remove(keptFile(session, cacheFolder));
}

QString sessionName(const QString& session) {
  const QFileInfo file(session);
  const QString folder = file.absoluteDir().dirName();
  const QString name = file.completeBaseName();
  if (folder.isEmpty()) return name;
  return name == QLatin1String("session") ? folder : QStringLiteral("%1/%2").arg(folder, name);
}

QString progressText(const SessionDigest& digest) {
  if (digest.scans == 0) return Text::tr("no scan yet");
  const QString scans = digest.scans == 1 ? Text::tr("1 scan") : Text::tr("%1 scans").arg(digest.scans);
  switch (digest.termination) {
    case Termination::Running:
    case Termination::Cancelled:
      return Text::tr("not ended, %1").arg(scans);
    case Termination::Finished:
      return Text::tr("finished, %1").arg(scans);
    case Termination::EndedByOperator:
      return Text::tr("ended by you, %1").arg(scans);
    case Termination::Imported:
      return Text::tr("imported, %1").arg(scans);
    case Termination::NoOverlap:
    case Termination::MaxViews:
    case Termination::RegistrationFailed:
      break;
  }
  return Text::tr("ended before all was seen, %1").arg(scans);
}

}  // namespace vantage
