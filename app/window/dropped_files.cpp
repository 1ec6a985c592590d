#include "window/dropped_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <vector>

#include "io/file_kind.h"
#include "io/ply_header.h"
#include "wizard/scan_list.h"

namespace vantage {
namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(DroppedFiles)
};

struct Judged {
  DropKind kind = DropKind::Refused;
  QString path;
  QString whyNot;
};

QString dropName(const QString& path) {
  const QFileInfo file(path);
  return file.fileName().isEmpty() ? QDir(path).dirName() : file.fileName();
}

// Of a mesh only the faces tell it from a cloud of points.
DropKind kindOfPly(const QString& path) {
  const PlyHeader header = readPlyHeader(path.toStdString());
  const auto filled = [&](const char* element) {
    const PlyElement* found = header.find(element);
    return found != nullptr && found->count > 0;
  };
  if (header.find("range_grid") != nullptr || header.info("num_cols")) return DropKind::Scans;
  return filled("face") || filled("tristrips") ? DropKind::Mesh : DropKind::Scans;
}

Judged judgeFile(const QString& path) {
  switch (detectFileKind(path.toStdString())) {
    case FileKind::Session:
      return {DropKind::Session, path, {}};
    case FileKind::Ply:
      return {kindOfPly(path), path, {}};
    case FileKind::Stl:
    case FileKind::Obj:
    case FileKind::Off:
    case FileKind::ThreeMf:
    case FileKind::OtherMesh:
      return {DropKind::Mesh, path, {}};
    case FileKind::Pcd:
    case FileKind::Ptx:
    case FileKind::TextPoints:
    case FileKind::DepthPng:
      return {DropKind::Scans, path, {}};
    case FileKind::ScanPoses:
      return {DropKind::Refused, path,
              Text::tr("%1 is a list of poses: it is chosen where scans are imported.").arg(dropName(path))};
    case FileKind::Profile:
      break;
  }
  return {DropKind::Refused, path,
          Text::tr("%1 is a profile or a file of settings: it is chosen on the first page.").arg(dropName(path))};
}

Judged judgeFolder(const QString& path) {
  const QDir folder(path);
  const QStringList sessions = folder.entryList({QStringLiteral("*.vantage")}, QDir::Files, QDir::Name);
  if (sessions.size() == 1) return {DropKind::Session, folder.filePath(sessions.front()), {}};
  if (sessions.size() > 1)
    return {DropKind::Refused, path,
            Text::tr("The folder %1 holds %2 sessions: drop the one that you mean.")
                .arg(dropName(path))
                .arg(sessions.size())};
  if (!rangeFilesIn({path}).isEmpty()) return {DropKind::Scans, path, {}};
  return {DropKind::Refused, path, Text::tr("The folder %1 holds no session and no scans.").arg(dropName(path))};
}

Dropped refused(const QString& whyNot) {
  return {DropKind::Refused, {}, whyNot};
}

QString kindText(const Judged& judged) {
  switch (judged.kind) {
    case DropKind::Session:
      return Text::tr("%1 is a session").arg(dropName(judged.path));
    case DropKind::Mesh:
      return Text::tr("%1 is a mesh").arg(dropName(judged.path));
    case DropKind::Scans:
    case DropKind::Refused:
      break;
  }
  return Text::tr("%1 is a scan").arg(dropName(judged.path));
}

}  // namespace

Dropped judgeDrop(const QStringList& paths, const Progress& progress) {
  std::vector<Judged> all;
  for (qsizetype i = 0; i < paths.size(); ++i) {
    progress.checkpoint(static_cast<double>(i) / static_cast<double>(paths.size()));
    all.push_back(QFileInfo(paths[i]).isDir() ? judgeFolder(paths[i]) : judgeFile(paths[i]));
    if (all.back().kind == DropKind::Refused) return refused(all.back().whyNot);
  }
  if (all.empty()) return refused(Text::tr("Nothing that was dropped is a file of this computer."));
  const auto other = std::find_if(all.begin(), all.end(), [&](const Judged& j) { return j.kind != all.front().kind; });
  if (other != all.end())
    return refused(Text::tr("%1, %2: drop one kind at a time.").arg(kindText(all.front()), kindText(*other)));
  if (all.size() > 1 && all.front().kind != DropKind::Scans)
    return refused(all.front().kind == DropKind::Session ? Text::tr("%1 and %2 are sessions: one is opened at a time.")
                                                               .arg(dropName(all[0].path), dropName(all[1].path))
                                                         : Text::tr("%1 and %2 are meshes: one is taken at a time.")
                                                               .arg(dropName(all[0].path), dropName(all[1].path)));
  Dropped dropped{all.front().kind, {}, {}};
  for (const Judged& judged : all) dropped.files << judged.path;
  return dropped;
}

QString droppableText() {
  return Text::tr("A session or its folder, scans, or one mesh can be dropped here.");
}

}  // namespace vantage
