#pragma once

#include <QDialog>

#include "settings/preferences.h"

namespace vantage {

/// Edits the preferences; changes take effect at once, Cancel takes them back.
class SettingsDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit SettingsDialog(const Preferences& preferences, QWidget* parent = nullptr);

  [[nodiscard]] const Preferences& preferences() const { return edited_; }

 signals:
  void edited(const vantage::Preferences& preferences);

 private:
  void takeBack();

  Preferences before_;
  Preferences edited_;
};

}  // namespace vantage
