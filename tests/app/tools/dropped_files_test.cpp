#include "window/dropped_files.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "base/errors.h"
#include "io/mesh_writer.h"
#include "io/range_files.h"
#include "support/scenes/small_scene.h"
#include "support/simulation.h"

namespace vantage {
namespace {

class DroppedFiles : public ::testing::Test {
 protected:
  DroppedFiles() {
    exportMesh(testing::smallObject(), at("body.ply").toStdString());
    exportMesh(testing::smallObject(), at("body.stl").toStdString());
    exportMesh(testing::smallObject(), at("body.obj").toStdString());
    const auto profile = testing::smallProfile();
    for (const int position : {0, 5})
      writeRangeFile(scanFrom(testing::simulation(testing::smallObject(), profile, {}), position, {}),
                     at(QStringLiteral("scan_%1.ply").arg(position)).toStdString());
    write("cloud.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "end_header\n1 2 3\n");
    write("cloud.xyz", "1 2 3\n4 5 6\n");
    write("scanner.json", "{}");
    write("letter.doc", "Dear all");
    QDir(folder_.path()).mkpath("mug");
    static_cast<void>(testing::importSmallScans(at("mug/session.vantage").toStdString()));
  }
  [[nodiscard]] QString at(const QString& name) const { return folder_.filePath(name); }
  [[nodiscard]] Dropped judged(const QStringList& names) const {
    QStringList paths;
    for (const QString& name : names) paths << at(name);
    return judgeDrop(paths);
  }
  void write(const QString& name, const QByteArray& text) const {
    QFile file(at(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
  }

  QTemporaryDir folder_;
};

TEST_F(DroppedFiles, AreToldByWhatIsInThem) {
  EXPECT_EQ(judged({"body.stl"}).kind, DropKind::Mesh);
  EXPECT_EQ(judged({"body.obj"}).kind, DropKind::Mesh);
  EXPECT_EQ(judged({"body.ply"}).kind, DropKind::Mesh) << "a PLY with faces";
  EXPECT_EQ(judged({"scan_0.ply"}).kind, DropKind::Scans);
  EXPECT_EQ(judged({"cloud.ply"}).kind, DropKind::Scans) << "a PLY without";
  EXPECT_EQ(judged({"cloud.xyz"}).kind, DropKind::Scans);
  QFile::copy(at("mug/session.vantage"), at("renamed"));
  EXPECT_EQ(judged({"renamed"}).kind, DropKind::Session);
}

TEST_F(DroppedFiles, AFolderStandsForWhatItHolds) {
  const Dropped session = judged({"mug"});
  EXPECT_EQ(session.kind, DropKind::Session);
  EXPECT_EQ(session.files, QStringList{at("mug/session.vantage")});
  QFile::copy(at("mug/session.vantage"), at("mug/session-2.vantage"));
  EXPECT_EQ(judged({"mug"}).whyNot, "The folder mug holds 2 sessions: drop the one that you mean.");
  QDir(folder_.path()).mkpath("scans");
  EXPECT_EQ(judged({"scans"}).whyNot, "The folder scans holds no session and no scans.");
  QFile::copy(at("scan_0.ply"), at("scans/a.ply"));
  EXPECT_EQ(judged({"scans"}).kind, DropKind::Scans);
}

TEST_F(DroppedFiles, SeveralAreTakenTogetherOnlyWhereTheyAreScans) {
  const Dropped scans = judged({"scan_0.ply", "scan_5.ply"});
  EXPECT_EQ(scans.kind, DropKind::Scans);
  EXPECT_EQ(scans.files.size(), 2);
  EXPECT_EQ(judged({"body.stl", "body.ply"}).whyNot, "body.stl and body.ply are meshes: one is taken at a time.");
  EXPECT_EQ(judged({"scan_0.ply", "body.stl"}).whyNot,
            "scan_0.ply is a scan, body.stl is a mesh: drop one kind at a time.");
  EXPECT_EQ(judged({"mug", "scan_0.ply"}).whyNot,
            "session.vantage is a session, scan_0.ply is a scan: drop one kind at a time.");
  QFile::copy(at("mug/session.vantage"), at("b.vantage"));
  EXPECT_EQ(judged({"mug", "b.vantage"}).whyNot,
            "session.vantage and b.vantage are sessions: one is opened at a time.");
}

TEST_F(DroppedFiles, ThatAreNothingOfTheKindAreNamed) {
  EXPECT_EQ(judged({"scanner.json"}).whyNot,
            "scanner.json is a profile or a file of settings: it is chosen on the first page.");
  for (const char* name : {"letter.doc", "missing.stl"}) {
    try {
      static_cast<void>(judged({name}));
      ADD_FAILURE() << name << " was taken";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(name), std::string::npos) << e.what();
    }
  }
  EXPECT_EQ(judgeDrop({}).kind, DropKind::Refused);
}

TEST_F(DroppedFiles, AreNotChanged) {
  const auto bytes = [&](const char* name) {
    QFile file(at(name));
    static_cast<void>(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  const QByteArray before = bytes("mug/session.vantage");
  static_cast<void>(judged({"mug"}));
  EXPECT_EQ(bytes("mug/session.vantage"), before);
}

}  // namespace
}  // namespace vantage
