#include "help/manual.h"

#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFileInfo>
#include <QImage>
#include <QRegularExpression>

#include "app/help/operator_manual.h"

namespace vantage {
namespace {

constexpr qint64 kLargestPicture = 150'000;  // bytes
constexpr int kMostPictures = 8;

class MadeUpManual : public ::testing::Test {
 protected:
  MadeUpManual() {
    folder_.write("contents.md", "# All of it\n\n- [Second](b.md)\n- [First](a.md)\n- [Gone](c.md)\n");
    folder_.write("a.md", "# First\n\nThe table turns.\n\n## By hand: how?\n\nTurn it. `Ctrl+T`\n");
    folder_.write("b.md", "# Second\n\n```\n# no heading\n```\n\n## Turning\n\nA turntable.\n");
  }
  [[nodiscard]] Manual manual() const { return Manual(QString::fromStdString(folder_.file(""))); }

  testing::TemporaryFolder folder_;
};

TEST_F(MadeUpManual, HasThePagesThatTheContentsLeadToInTheirOrder) {
  const Manual manual = this->manual();
  QStringList titles;
  for (const ManualPage& page : manual.pages()) titles << page.key + QLatin1Char('=') + page.title;
  EXPECT_EQ(titles.join(' ').toStdString(), "contents=All of it b=Second a=First");
}

TEST_F(MadeUpManual, KnowsPagesAndHeadings) {
  const Manual manual = this->manual();
  EXPECT_TRUE(manual.has("a"));
  EXPECT_TRUE(manual.has("a#by-hand-how"));
  EXPECT_FALSE(manual.has("a#turning"));
  EXPECT_FALSE(manual.has("b#no-heading"));
  EXPECT_FALSE(manual.has("c"));
  EXPECT_EQ(manual.pageOf("c"), nullptr);
}

TEST_F(MadeUpManual, FindsSectionsWithAllWordsHeadingsFirst) {
  QStringList found;
  for (const ManualHit& hit : manual().find("TURN")) found << hit.topic;
  EXPECT_EQ(found.join(' ').toStdString(), "b#turning a#first a#by-hand-how");
  found.clear();
  for (const ManualHit& hit : manual().find("turns  table")) found << hit.topic;
  EXPECT_EQ(found.join(' ').toStdString(), "a#first");
  EXPECT_TRUE(manual().find("table turnip").empty());
  EXPECT_TRUE(manual().find("able").empty()) << "inside of a word";
  EXPECT_TRUE(manual().find("  ").empty());
}

TEST(Manual, IsEmptyWhereThereIsNone) {
  EXPECT_TRUE(Manual(QStringLiteral("/nowhere")).pages().empty());
}

TEST(OperatorManual, EveryPageIsInTheContents) {
  const Manual manual(testing::manualFolder());
  EXPECT_GT(manual.pages().size(), 15U);
  for (const QString& file : testing::manualFiles()) {
    const ManualPage* page = manual.pageOf(QFileInfo(file).baseName());
    ASSERT_NE(page, nullptr) << file.toStdString();
    EXPECT_FALSE(page->sections.empty()) << file.toStdString();
  }
}

TEST(OperatorManual, EveryLinkAndPictureIsThere) {
  const Manual manual(testing::manualFolder());
  static const QRegularExpression kLink(QStringLiteral("\\]\\(([^)#]*)(#[^)]*)?\\)"));
  int links = 0;
  for (const QString& file : testing::manualFiles())
    for (auto match = kLink.globalMatch(testing::textOf(file)); match.hasNext(); ++links) {
      const auto link = match.next();
      const QString name = link.captured(1).isEmpty() ? QFileInfo(file).fileName() : link.captured(1);
      const QFileInfo target(QFileInfo(file).dir().filePath(name));
      EXPECT_TRUE(target.isFile()) << file.toStdString() << ": " << name.toStdString();
      const QString topic = target.baseName() + link.captured(2);
      if (!link.captured(2).isEmpty())
        EXPECT_TRUE(manual.has(topic)) << file.toStdString() << ": " << topic.toStdString();
    }
  EXPECT_GT(links, 50);
}

TEST(OperatorManual, PicturesAreFewSmallAndShown) {
  QString all;
  for (const QString& file : testing::manualFiles()) all += testing::textOf(file);
  const QDir folder(testing::manualFolder() + QStringLiteral("/pictures"));
  const QFileInfoList pictures = folder.entryInfoList(QDir::Files);
  EXPECT_GT(pictures.size(), 0);
  EXPECT_LE(pictures.size(), kMostPictures);
  for (const QFileInfo& picture : pictures) {
    const std::string name = picture.fileName().toStdString();
    EXPECT_LT(picture.size(), kLargestPicture) << name;
    EXPECT_FALSE(QImage(picture.filePath()).isNull()) << name;
    EXPECT_TRUE(all.contains(QStringLiteral("(pictures/") + picture.fileName())) << name << " is on no page";
  }
}

// The topics that sources name, and the windows and pages of the wizard that name none.
TEST(HelpTopics, EveryDialogAndPageHasOneThatIsInTheManual) {
  const Manual manual(testing::manualFolder());
  static const QRegularExpression kTopic(QStringLiteral("setHelpTopic\\([^;]*QStringLiteral\\(\\s*\"([^\"]*)\""));
  static const QRegularExpression kWindow(
      QStringLiteral("class (\\w+)[^;{]*: public (QDialog|QMessageBox|WizardPage)\\b"));
  int topics = 0;
  int windows = 0;
  const QString app = QString::fromStdString((testing::sourceFolder() / "app").string());
  for (QDirIterator it(app, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                       QDirIterator::Subdirectories);
       it.hasNext();) {
    const QString file = it.next();
    const QString text = testing::textOf(file);
    for (auto match = kTopic.globalMatch(text); match.hasNext(); ++topics) {
      const QString topic = match.next().captured(1);
      EXPECT_TRUE(manual.has(topic)) << file.toStdString() << ": " << topic.toStdString();
    }
    for (auto match = kWindow.globalMatch(text); match.hasNext(); ++windows) {
      const QString name = match.next().captured(1);
      const QString source = testing::textOf(QString(file).replace(QStringLiteral(".h"), QStringLiteral(".cpp")));
      EXPECT_TRUE(source.contains(QStringLiteral("setHelpTopic(*this")))
          << name.toStdString() << " names no page of the manual";
    }
  }
  EXPECT_GE(topics, 20);
  EXPECT_GE(windows, 13);
}

}  // namespace
}  // namespace vantage
