#pragma once

#include <QString>
#include <QWidget>
#include <functional>

#include "acquisition/setting_field.h"

namespace vantage {

/// A text of the table of settings in the operator's language. The table is free of Qt: its labels, units, choices,
/// help and group labels are the source texts of the context "Settings", where a translation has them word for word.
[[nodiscard]] QString settingWords(std::string_view text);

/// The widget that edits one setting.
struct SettingEditor {
  QWidget* widget = nullptr;
  std::function<void()> refresh;  ///< shows what the settings have
};

/// @param settings must outlive the widget.
/// @param edited is called after every edit, with why a value was refused: the settings then stay as they were.
[[nodiscard]] SettingEditor makeSettingEditor(const SettingField& field, AcquisitionSettings& settings,
                                              const std::function<void(const QString& refusal)>& edited);

}  // namespace vantage
