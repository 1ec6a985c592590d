// What the program can say is in the manual, and what the manual says of messages is said by the program.
#include <gtest/gtest.h>

#include <QDirIterator>
#include <QRegularExpression>
#include <algorithm>

#include "app/help/operator_manual.h"
#include "calibration/calibration_finding.h"
#include "composites/alignment_verdict.h"
#include "print_text.h"
#include "refusal_text.h"
#include "report/loss_wording.h"
#include "report/wording.h"
#include "wording.h"

namespace vantage {
namespace {

constexpr QChar kAnything(0x2026);        // the ellipsis
constexpr qsizetype kTellingLength = 12;  // a shorter piece of a message is in many

// The first column of tables that begin with "Message".
QStringList messagesIn(const QString& markdown) {
  QStringList messages;
  bool table = false;
  for (const QString& line : markdown.split(QLatin1Char('\n'))) {
    if (!line.startsWith(QLatin1Char('|'))) {
      table = false;
      continue;
    }
    const QString cell = line.section(QStringLiteral(" | "), 0, 0).mid(2).trimmed();
    if (table && !line.startsWith(QStringLiteral("|---"))) messages << cell;
    if (cell == QStringLiteral("Message")) table = true;
  }
  return messages;
}

QStringList allMessages() {
  QStringList messages;
  for (const QString& file : testing::manualFiles()) messages << messagesIn(testing::textOf(file));
  return messages;
}

QStringList piecesOf(const QString& message) {
  QStringList pieces;
  for (const QString& piece : message.split(kAnything)) pieces << piece.trimmed();
  pieces.removeAll(QString());
  return pieces;
}

bool isAbout(const QString& message, const QString& said) {
  qsizetype at = 0;
  for (const QString& piece : piecesOf(message)) {
    at = said.indexOf(piece, at);
    if (at < 0) return false;
    at += piece.size();
  }
  return message.size() > kTellingLength || said == message;
}

template <typename Reason>
std::vector<Reason> upTo(Reason last) {
  std::vector<Reason> all;
  for (int i = 0; i <= static_cast<int>(last); ++i) all.push_back(static_cast<Reason>(i));
  return all;
}

QStringList refusals() {
  QStringList said;
  for (const RefusalReason reason : upTo(kLastRefusalReason)) said << refusalText({reason, 7});
  return said;
}

QStringList verdicts() {
  QStringList said;
  for (const VerdictReason reason : upTo(kLastVerdictReason))
    for (const double value : {3.0, -3.0}) {
      Finding finding{reason, value};
      if (reason == VerdictReason::HeldByMechanics) finding.motions = {{WeakMotion::Kind::Slide, Vec3::UnitZ()}};
      said << translated(phraseOf(finding));
    }
  return said;
}

QStringList alignments() {
  QStringList said;
  for (const AlignmentReason reason : upTo(kLastAlignmentReason))
    for (const bool same : {false, true}) {
      StandAlignment alignment;
      alignment.reason = reason;
      alignment.value = 2.0;
      alignment.sameSurface = same;
      said << translated(phraseOf(alignment));
    }
  return said;
}

QStringList calibrations() {
  QStringList said;
  for (const CalibrationReason reason : upTo(kLastCalibrationReason))
    for (const double value : {3.0, -3.0})
      said << QString::fromStdString(describe(CalibrationFinding{reason, value, std::size_t{2}}));
  return said;
}

QStringList losses() {
  QStringList said;
  for (const LossKind kind : upTo(kLastLossKind)) {
    // Of these the reader's own sentence is shown.
    if (kind == LossKind::RowDamaged || kind == LossKind::ScanDamaged || kind == LossKind::PlanDamaged) continue;
    for (const char* name : {"", "scans"}) said << translated(phraseOf(Loss{kind, 4, name, "cell 3"}, "/s.vantage"));
  }
  return said;
}

QStringList printFaults() {
  QStringList said;
  for (const PrintFault fault : upTo(PrintFault::Pieces)) {
    PrintCheck check;
    check.faults = {fault};
    said << whyNotPrintable(check);
  }
  return said;
}

QStringList endings() {
  QStringList said;
  for (const Termination termination : upTo(kLastTermination)) said << terminationText(termination);
  return said;
}

QStringList edges() {
  QStringList said;
  for (int i = 0; i < kEdgeReasons; ++i)
    for (const PlanOutcome outcome : {PlanOutcome::Found, PlanOutcome::Finished})
      said << edgeReasonText(static_cast<EdgeReason>(i), outcome);
  return said;
}

QStringList saidByReason() {
  return refusals() + verdicts() + alignments() + calibrations() + losses() + printFaults() + endings() + edges();
}

// What sources hold in quotes; pieces that follow each other are one text.
QString quotedInSources() {
  QString all;
  static const QRegularExpression kTogether(QStringLiteral("\"\\s*\\n\\s*\""));
  for (const char* folder : {"app", "core"})
    for (QDirIterator it(QString::fromStdString((testing::sourceFolder() / folder).string()), {QStringLiteral("*.cpp")},
                         QDir::Files, QDirIterator::Subdirectories);
         it.hasNext();)
      all += testing::textOf(it.next()).remove(kTogether);
  return all;
}

void expectEntries(const QStringList& said, const char* page) {
  const QStringList messages = messagesIn(testing::textOf(testing::manualFolder() + QLatin1Char('/') + page));
  ASSERT_FALSE(messages.isEmpty()) << page;
  for (const QString& sentence : said) {
    ASSERT_FALSE(sentence.isEmpty()) << page;
    EXPECT_TRUE(std::any_of(messages.begin(), messages.end(),
                            [&](const QString& message) { return isAbout(message, sentence); }))
        << page << " does not say what to do about: " << sentence.toStdString();
  }
}

TEST(Messages, OfTheManualAreReadFromItsTables) {
  EXPECT_EQ(messagesIn("| Message | Means |\n|---|---|\n| a … b | c |\n\n| Key | d |\n|---|---|\n| e | f |\n"),
            QStringList{"a … b"});
  EXPECT_TRUE(isAbout("only … points overlap", "only 12 points overlap with the model"));
  EXPECT_FALSE(isAbout("only … points overlap", "only 12 % of the overlap fits"));
  EXPECT_FALSE(isAbout("points … only some of it", "only some of it has points"));
}

TEST(Messages, EveryReasonHasAnEntry) {
  expectEntries(refusals(), "messages_refused.md");
  expectEntries(verdicts(), "messages_scans.md");
  expectEntries(endings(), "messages_scans.md");
  expectEntries(alignments(), "messages_stands.md");
  expectEntries(calibrations(), "messages_calibration.md");
  expectEntries(losses(), "messages_files.md");
  expectEntries(printFaults(), "finish.md");
  expectEntries(edges(), "review.md");
}

TEST(Messages, EveryEntryIsSomethingThatTheProgramSays) {
  const QStringList reasons = saidByReason();
  const QString quoted = quotedInSources();
  const QStringList messages = allMessages();
  EXPECT_GT(messages.size(), 150);
  for (const QString& message : messages) {
    if (std::any_of(reasons.begin(), reasons.end(), [&](const QString& said) { return isAbout(message, said); }))
      continue;
    bool telling = false;
    for (const QString& piece : piecesOf(message)) {
      if (piece.size() < kTellingLength) continue;
      telling = true;
      EXPECT_TRUE(quoted.contains(piece)) << "nowhere in the program: " << piece.toStdString();
    }
    EXPECT_TRUE(telling || quoted.contains(QLatin1Char('"') + message)) << message.toStdString();
  }
}

TEST(Messages, NoneIsExplainedTwice) {
  QStringList messages = allMessages();
  messages.sort();
  for (qsizetype i = 1; i < messages.size(); ++i) EXPECT_NE(messages[i].toStdString(), messages[i - 1].toStdString());
}

}  // namespace
}  // namespace vantage
