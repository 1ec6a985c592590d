#include "settings/setting_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <limits>

#include "base/errors.h"

namespace vantage {
namespace {

using Edited = std::function<void(const QString&)>;

// Decimals as the language writes them; names and codes as they are.
QString inLanguage(const SettingField& field, QString text) {
  return field.kind == SettingField::Kind::Number ? text.replace(QLatin1Char('.'), QLocale().decimalPoint()) : text;
}

QString inFile(const SettingField& field, QString text) {
  return field.kind == SettingField::Kind::Number ? text.replace(QLocale().decimalPoint(), QStringLiteral(".")) : text;
}

void take(const SettingField& field, AcquisitionSettings& settings, const QString& text, const Edited& edited) {
  try {
    setText(field, settings, text.trimmed().toStdString());
  } catch (const InvalidInput& e) {
    return edited(QString::fromUtf8(e.what()));
  }
  edited({});
}

QString shown(const SettingField& field, const AcquisitionSettings& settings) {
  return QString::fromStdString(textOf(field, settings));
}

SettingEditor makeSwitch(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  auto* box = new QCheckBox;
  QObject::connect(box, &QCheckBox::toggled, box, [&field, &settings, edited](bool on) {
    setValue(field, settings, on);
    edited({});
  });
  return {box, [box, &field, &settings] {
            const QSignalBlocker blocker(box);
            box->setChecked(std::get<bool>(valueOf(field, settings)));
          }};
}

SettingEditor makeWhole(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  constexpr double kMost = std::numeric_limits<int>::max();
  auto* box = new QSpinBox;
  box->setRange(static_cast<int>(field.least), static_cast<int>(std::min(field.most, kMost)));
  QObject::connect(box, &QSpinBox::valueChanged, box, [&field, &settings, edited](int value) {
    setValue(field, settings, static_cast<std::uint64_t>(value));
    edited({});
  });
  return {box, [box, &field, &settings] {
            const QSignalBlocker blocker(box);
            const auto value = std::get<std::uint64_t>(valueOf(field, settings));
            box->setValue(static_cast<int>(std::min(value, static_cast<std::uint64_t>(box->maximum()))));
          }};
}

// What a choice means, for people; files have its code.
QString choiceWords(std::string_view choice) {
  static constexpr std::pair<std::string_view, const char*> kWords[] = {
      {"as-is", QT_TRANSLATE_NOOP("Settings", "As it is")},
      {"fit", QT_TRANSLATE_NOOP("Settings", "Fitted")},
      {"spacing", QT_TRANSLATE_NOOP("Settings", "Spacing")},
      {"triangle", QT_TRANSLATE_NOOP("Settings", "Triangle")}};
  for (const auto& [code, words] : kWords)
    if (code == choice) return settingWords(words);
  return settingWords(choice);
}

SettingEditor makeChoice(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  auto* box = new QComboBox;
  for (const std::string_view choice : field.choices)
    box->addItem(choiceWords(choice), QString::fromUtf8(choice.data(), static_cast<qsizetype>(choice.size())));
  QObject::connect(box, &QComboBox::currentIndexChanged, box,
                   [box, &field, &settings, edited] { take(field, settings, box->currentData().toString(), edited); });
  return {box, [box, &field, &settings] {
            const QSignalBlocker blocker(box);
            box->setCurrentIndex(box->findData(shown(field, settings)));
          }};
}

// Numbers too: what was typed is taken to the last digit, and a setting may be automatic.
SettingEditor makeText(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  auto* line = new QLineEdit;
  const auto refresh = [line, &field, &settings] { line->setText(inLanguage(field, shown(field, settings))); };
  QObject::connect(line, &QLineEdit::textEdited, line, [&field, &settings, edited](const QString& text) {
    take(field, settings, inFile(field, text), edited);
  });
  QObject::connect(line, &QLineEdit::editingFinished, line, [refresh, edited] {
    refresh();
    edited({});
  });
  return {line, refresh};
}

SettingEditor makeEditor(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  switch (field.kind) {
    case SettingField::Kind::Switch:
      return makeSwitch(field, settings, edited);
    case SettingField::Kind::Whole:
      return makeWhole(field, settings, edited);
    case SettingField::Kind::Choice:
      return makeChoice(field, settings, edited);
    case SettingField::Kind::Number:
    case SettingField::Kind::Text:
      break;
  }
  return makeText(field, settings, edited);
}

}  // namespace

QString settingWords(std::string_view text) {
  return QCoreApplication::translate("Settings", std::string(text).c_str());
}

SettingEditor makeSettingEditor(const SettingField& field, AcquisitionSettings& settings, const Edited& edited) {
  SettingEditor editor = makeEditor(field, settings, edited);
  editor.widget->setObjectName(QString::fromStdString(std::string(field.key)));
  editor.widget->setAccessibleName(settingWords(field.label));
  editor.widget->setToolTip(settingWords(field.help));
  editor.refresh();
  return editor;
}

}  // namespace vantage
