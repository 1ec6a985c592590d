#include "settings/settings_form.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTranslator>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_table.h"

namespace vantage {
namespace {

QString complaintOf(const SettingsForm& form) {
  return form.findChild<QLabel*>("settings_complaint")->text();
}

// A language in which the texts of the context Settings are in angle brackets.
class Brackets final : public QTranslator {
 public:
  Brackets() { QCoreApplication::installTranslator(this); }
  ~Brackets() override { QCoreApplication::removeTranslator(this); }
  Brackets(const Brackets&) = delete;
  Brackets& operator=(const Brackets&) = delete;

  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* context, const char* text, const char* /*disambiguation*/,
                                  int /*n*/) const override {
    return QLatin1String(context) == QLatin1String("Settings") ? QStringLiteral("<%1>").arg(text) : QString();
  }
};

// The label beside an editor.
QString labelBeside(const SettingsForm& form, QWidget* editor) {
  for (const auto* layout : form.findChildren<QFormLayout*>())
    if (const auto* label = qobject_cast<const QLabel*>(layout->labelForField(editor))) return label->text();
  return {};
}

void type(const SettingsForm& form, const char* key, const QString& text) {
  auto* line = form.findChild<QLineEdit*>(key);
  line->selectAll();
  QTest::keyClicks(line, text);
}

TEST(SettingsForm, HasAnEditorForEverySettingButThoseOfOneSession) {
  const SettingsForm form;
  for (const SettingField& field : settingFields()) {
    const auto* editor = form.findChild<QWidget*>(QString::fromStdString(std::string(field.key)));
    EXPECT_EQ(editor != nullptr, field.audience != SettingAudience::Session) << field.key;
    if (editor == nullptr) continue;
    EXPECT_FALSE(editor->accessibleName().isEmpty()) << field.key;
    EXPECT_FALSE(editor->toolTip().isEmpty()) << field.key;
  }
}

TEST(SettingsForm, SpeaksTheOperatorsLanguage) {
  const Brackets language;
  const SettingsForm form;
  for (const SettingField& field : settingFields()) {
    auto* editor = form.findChild<QWidget*>(QString::fromStdString(std::string(field.key)));
    if (editor == nullptr) continue;
    const QString label = QStringLiteral("<%1>").arg(QString::fromStdString(std::string(field.label)));
    EXPECT_TRUE(labelBeside(form, editor).startsWith(label)) << field.key;
    EXPECT_EQ(editor->accessibleName(), label);
    EXPECT_EQ(editor->toolTip(), QStringLiteral("<%1>").arg(QString::fromStdString(std::string(field.help))));
  }
}

TEST(SettingsForm, ExpertsOptionsAreFoldedAway) {
  SettingsForm form;
  form.show();
  EXPECT_TRUE(form.findChild<QWidget*>("max_views")->isVisible());
  EXPECT_FALSE(form.findChild<QWidget*>("registration.coarse_gate")->isVisible());
  form.findChild<QToolButton*>("expert_settings")->setChecked(true);
  EXPECT_TRUE(form.findChild<QWidget*>("registration.coarse_gate")->isVisible());
}

TEST(SettingsForm, WhatIsOfTheSimulatedScannerIsOutOfSightBeforeARealOne) {
  SettingsForm form;
  form.show();
  const auto visible = [&form](const char* key) { return form.findChild<QWidget*>(key)->isVisible(); };
  const char* keys[] = {"simulation.placement", "simulation.unit", "simulation.seed", "simulation.ideal"};
  for (const char* key : keys) EXPECT_TRUE(visible(key)) << key;
  form.setSimulated(false);
  for (const char* key : keys) EXPECT_FALSE(visible(key)) << key;
  EXPECT_TRUE(visible("max_views"));
  form.setSimulated(true);
  for (const char* key : keys) EXPECT_TRUE(visible(key)) << key;
}

TEST(SettingsForm, TheSeedOfPositionsAtRandomIsThatOfRealScannersToo) {
  SettingsForm form;
  form.show();
  form.setSimulated(false);
  type(form, "strategy", "random");
  EXPECT_TRUE(form.findChild<QWidget*>("simulation.seed")->isVisible());
  EXPECT_FALSE(form.findChild<QWidget*>("simulation.ideal")->isVisible());
  type(form, "strategy", "ps");
  EXPECT_FALSE(form.findChild<QWidget*>("simulation.seed")->isVisible());
}

TEST(SettingsForm, EveryKindOfEditorWritesItsSetting) {
  SettingsForm form;
  const QSignalSpy edited(&form, &SettingsForm::edited);
  form.findChild<QSpinBox*>("max_views")->setValue(7);
  form.findChild<QCheckBox*>("simulation.ideal")->setChecked(true);
  form.findChild<QComboBox*>("simulation.placement")->setCurrentIndex(1);
  EXPECT_EQ(edited.count(), 3);
  type(form, "planner.overlap_share", "0.25");
  type(form, "registration.final_angle", "30");
  type(form, "planner.least_overlap", "12.5");
  type(form, "strategy", "uniform:8");
  EXPECT_EQ(form.settings().maxViews, 7);
  EXPECT_TRUE(form.settings().simulation.ideal);
  EXPECT_EQ(form.settings().simulation.placement, Placement::Fit);
  EXPECT_EQ(form.settings().planner.overlapShare, 0.25);
  EXPECT_EQ(form.settings().registration.finalAngle, radians(30.0));
  EXPECT_EQ(form.settings().planner.leastOverlap, 12.5);
  EXPECT_EQ(name(form.settings().strategy), "uniform:8");
  EXPECT_EQ(complaintOf(form), "");
}

TEST(SettingsForm, ShowsTheSettingsThatItIsGiven) {
  SettingsForm form;
  AcquisitionSettings settings;
  settings.maxViews = 9;
  settings.zipper.clearance = 0.5;
  form.setSettings(settings);
  EXPECT_EQ(form.findChild<QSpinBox*>("max_views")->value(), 9);
  EXPECT_EQ(form.findChild<QLineEdit*>("zipper.clearance")->text(), "0.5");
  EXPECT_EQ(form.settings(), settings);
}

TEST(SettingsForm, RefusedValueIsToldAndTakenBack) {
  SettingsForm form;
  type(form, "planner.overlap_share", "7");
  EXPECT_EQ(complaintOf(form), "planner.overlap_share is 7, expected a number from 0 to 1");
  EXPECT_EQ(form.settings(), AcquisitionSettings());
  auto* line = form.findChild<QLineEdit*>("planner.overlap_share");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_EQ(line->text(), "0.1");
  EXPECT_EQ(complaintOf(form), "");
}

TEST(SettingsForm, ContradictionIsToldUntilItIsResolved) {
  SettingsForm form;
  EXPECT_TRUE(form.consistent());
  type(form, "registration.coarse_gate", "10");
  type(form, "registration.final_gate", "12");
  EXPECT_FALSE(form.consistent());
  EXPECT_TRUE(complaintOf(form).contains("registration.coarse_gate"));
  type(form, "registration.coarse_gate", "20");
  EXPECT_TRUE(form.consistent());
  EXPECT_EQ(complaintOf(form), "");
}

TEST(SettingsForm, ProfileOfOptionsIsSavedAndLoaded) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("options.json");
  SettingsForm saved;
  type(saved, "planner.overlap_share", "0.25");
  saved.save(path);
  SettingsForm loaded;
  loaded.load(path);
  EXPECT_EQ(loaded.settings(), saved.settings());
  loaded.load(folder.filePath("nothing.json"));
  EXPECT_TRUE(complaintOf(loaded).contains("nothing.json"));
  EXPECT_EQ(loaded.settings(), saved.settings());
}

TEST(SettingsForm, ShowsChoicesInWordsAndKeepsTheirCodes) {
  const SettingsForm form;
  for (const SettingField& field : settingFields()) {
    if (field.kind != SettingField::Kind::Choice) continue;
    const auto* box = form.findChild<QComboBox*>(QString::fromStdString(std::string(field.key)));
    ASSERT_TRUE(box != nullptr) << field.key;
    for (int i = 0; i < box->count(); ++i) {
      EXPECT_EQ(box->itemData(i).toString().toStdString(), field.choices[static_cast<std::size_t>(i)]);
      EXPECT_NE(box->itemText(i), box->itemData(i).toString()) << field.key;
    }
  }
}

}  // namespace
}  // namespace vantage
