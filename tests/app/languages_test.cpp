#include "settings/languages.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_table.h"
#include "app/in_language.h"
#include "docks/job_panel.h"
#include "look/figures.h"
#include "report/loss_wording.h"
#include "report/wording.h"
#include "settings/preferences.h"
#include "settings/settings_dialog.h"
#include "settings/settings_form.h"
#include "wording.h"

namespace vantage {
namespace {

using testing::InLanguage;

// Those that are translated.
std::vector<Language> translatedLanguages() {
  std::vector<Language> all = languages();
  all.erase(all.begin());
  return all;
}

TEST(Languages, AreThoseThatWereTranslatedByTheirOwnNames) {
  const std::vector<Language> all = languages();
  const auto nameOf = [&](const char* code) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& l) { return l.code == code; });
    return found == all.end() ? QString() : found->name;
  };
  EXPECT_EQ(all.front().code, "en");
  EXPECT_EQ(nameOf("en"), "English");
  EXPECT_EQ(nameOf("de"), "Deutsch");
  EXPECT_EQ(nameOf("zh_CN"), QStringLiteral("简体中文"));
}

TEST(Languages, TheDesktopIsAnsweredInTheFirstThatTheWindowSpeaks) {
  EXPECT_EQ(languageFor({"de-AT", "en"}), "de");
  EXPECT_EQ(languageFor({"tlh", "zh-CN", "de"}), "zh_CN");
  EXPECT_EQ(languageFor({"en-GB", "de"}), "en");
  EXPECT_EQ(languageFor({"zh-TW"}), "en");
  EXPECT_EQ(languageFor({}), "en");
}

TEST(Languages, HoldWhileTheyLive) {
  const auto ended = [] { return terminationText(Termination::EndedByOperator).toStdString(); };
  const QString before = QLocale().decimalPoint();
  EXPECT_EQ(ended(), "Ended by you.");
  {
    const Translation german("de");
    EXPECT_EQ(german.code(), "de");
    EXPECT_EQ(ended(), "Von Ihnen beendet.");
    EXPECT_EQ(QLocale().decimalPoint(), ",");
  }
  {
    const Translation unknown("tlh");
    EXPECT_EQ(unknown.code(), "en");
    EXPECT_EQ(ended(), "Ended by you.");
  }
  EXPECT_EQ(QLocale().decimalPoint(), before);
}

TEST(Languages, QtSpeaksThemToo) {
  const Translation german("de");
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel").toStdString(), "Abbrechen")
      << "install the translations of Qt, see packaging/dependencies";
}

// Steps are named in the engine by codes.
TEST(Languages, NameEveryStepOfWork) {
  const Translation german("de");
  for (const char* step : {"scan",
                           "register",
                           "prepare_views",
                           "refine",
                           "integrate",
                           "void_patches",
                           "project_void",
                           "project_seen",
                           "choose",
                           "zippering",
                           "consensus",
                           "prepare",
                           "search",
                           "check",
                           "calibrate",
                           "close openings",
                           "simplify",
                           "read profile",
                           "read object",
                           "read session",
                           "read scan",
                           "read scans",
                           "positional space of the scanner"})
    EXPECT_NE(stepText(step), step);
  EXPECT_EQ(stepText("reading scan_07.ply"), QStringLiteral("scan_07.ply wird gelesen"));
}

TEST(Languages, CountOneAndMany) {
  const char* text = "%n opening(s) stayed open.";
  const auto said = [&](int n) { return QCoreApplication::translate("PrintText", text, nullptr, n).toStdString(); };
  const Translation german("de");
  EXPECT_EQ(said(1), "1 Öffnung blieb offen.");
  EXPECT_EQ(said(3), "3 Öffnungen blieben offen.");
}

// What core says by codes and tables, in every language: nothing of it is in the window's own sources.
class CoreTexts : public ::testing::TestWithParam<Language> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(translator_.load(QStringLiteral("vantage_") + GetParam().code, QStringLiteral(":/translations")));
  }
  void expectKnown(const char* context, std::string_view text) const {
    const std::string key(text);
    if (key.empty()) return;
    EXPECT_FALSE(translator_.translate(context, key.c_str()).isEmpty()) << context << ": " << key;
  }
  void expectKnown(const Phrase& phrase) const {
    if (phrase.pattern == nullptr) return;
    expectKnown("Phrase", phrase.pattern);
    for (const Phrase& value : phrase.values) expectKnown(value);
  }

 private:
  QTranslator translator_;
};
INSTANTIATE_TEST_SUITE_P(In, CoreTexts, ::testing::ValuesIn(translatedLanguages()),
                         [](const auto& p) { return p.param.code.toStdString(); });

TEST_P(CoreTexts, EveryOptionIsTranslated) {
  for (const SettingField& field : settingFields()) {
    expectKnown("Settings", field.label);
    expectKnown("Settings", field.unit);
    expectKnown("Settings", field.help);
    expectKnown("Settings", groupLabel(groupOf(field)));
  }
}

TEST_P(CoreTexts, WhatWasFoundDoneAndLostIsTranslated) {
  const WeakMotions motions{{WeakMotion::Kind::Slide, Vec3(0.7, 0.7, 0.0)}, {WeakMotion::Kind::Turn, Vec3::UnitZ()}};
  for (int i = 0; i <= static_cast<int>(kLastVerdictReason); ++i)
    expectKnown(phraseOf(Finding{static_cast<VerdictReason>(i), 0.87, motions}));
  for (const Command& command :
       std::vector<Command>{ChangeSettings{}, AddScan{3, {}}, ImportScans{{1, 2}}, ChoosePosition{5}, ChoosePosition{},
                            LeaveOutView{4}, TakeBackView{4}, Finish{Termination::Running}, TakeOver{}, TurnObject{},
                            PlaceStand{1, Pose::Identity()}, AlignStand{1}, ChangeMode{Mode::Assisted}})
    expectKnown(phraseOf(command));
  for (int i = 0; i <= static_cast<int>(kLastLossKind); ++i)
    expectKnown(phraseOf(Loss{static_cast<LossKind>(i), 4, "/data/a.vantage", "a"}, "/data/a.vantage"));
}

TEST(Figures, AreWrittenAsTheLanguageWritesThem) {
  const QString thin(QChar(0x202F));
  {
    const Translation german("de");
    EXPECT_EQ(figureText(-1234567.25, 1), "-1" + thin + "234" + thin + "567,3");
    EXPECT_EQ(figureText(1234.5, 1), "1234,5");
    EXPECT_EQ(translated(figure(0.25, 2)), "0,25");
  }
  const Translation english("en");
  EXPECT_EQ(figureText(0.25, 2), "0.25");
  EXPECT_EQ(figureText(12345.0), "12" + thin + "345");
}

// What is typed in an option is understood as the language writes it, and a point always is.
TEST(Figures, AreTypedAsTheLanguageWritesThem) {
  const Translation german("de");
  SettingsForm form;
  auto* line = form.findChild<QLineEdit*>("planner.overlap_share");
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->text(), "0,1");
  for (const QString typed : {"0,25", "0.25"}) {
    line->selectAll();
    QTest::keyClicks(line, typed);
    EXPECT_EQ(form.settings().planner.overlapShare, 0.25) << typed.toStdString();
  }
}

TEST(LanguageOfTheWindow, IsChosenInTheSettingsAndKept) {
  Preferences preferences;
  SettingsDialog dialog(preferences);
  auto* box = dialog.findChild<QComboBox*>("language");
  ASSERT_NE(box, nullptr);
  ASSERT_EQ(box->currentData().toString(), "");
  QObject::connect(&dialog, &SettingsDialog::edited, [&](const Preferences& edited) { preferences = edited; });
  const auto* later = dialog.findChild<QLabel*>("languageLater");
  EXPECT_TRUE(later->isHidden());
  box->setCurrentIndex(box->findData(QStringLiteral("de")));
  EXPECT_FALSE(later->isHidden());
  EXPECT_EQ(preferences.language, "de");
  savePreferences(preferences);
  EXPECT_EQ(loadPreferences().language, "de");
  QSettings().setValue(QStringLiteral("preferences/language"), QStringLiteral("tlh"));
  EXPECT_EQ(loadPreferences().language, "");
  QSettings().remove(QStringLiteral("preferences"));
}

TEST(PseudoLanguage, IsLongerAndKeepsPlacesKeysAndTags) {
  EXPECT_EQ(testing::pseudoText("Ctrl+Shift+O"), "Ctrl+Shift+O");
  EXPECT_EQ(testing::pseudoText("Sessions (*.vantage)"), "Sessions (*.vantage)");
  const QString text = testing::pseudoText("&Open %1 of %n in <a href=\"%2\">there</a>…");
  for (const char* part : {"%1", "%n", "<a href=\"%2\">", "</a>", "&"}) EXPECT_TRUE(text.contains(part)) << part;
  EXPECT_GE(testing::pseudoText("Ranging rays").size(), 16);
  const InLanguage pseudo("pseudo");
  EXPECT_NE(terminationText(Termination::EndedByOperator), "Ended by you.");
}

}  // namespace
}  // namespace vantage
