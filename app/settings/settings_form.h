#pragma once

#include <QWidget>
#include <functional>
#include <string_view>
#include <vector>

#include "acquisition/setting_field.h"

class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace vantage {

/// Edits the settings of an acquisition, group by group; those for experts are folded away. Says what is wrong with a
/// value, or with two that contradict each other.
class SettingsForm final : public QWidget {
  Q_OBJECT

 public:
  /// @param group that is edited, all of it in sight; empty: all groups
  explicit SettingsForm(std::string_view group = {}, QWidget* parent = nullptr);

  [[nodiscard]] const AcquisitionSettings& settings() const { return settings_; }
  void setSettings(const AcquisitionSettings& settings);

  /// Whether a simulated scanner is used: what says nothing to a real one is out of sight.
  void setSimulated(bool simulated);

  /// Whether no settings contradict each other.
  [[nodiscard]] bool consistent() const { return consistent_; }

  /// All that changes settings.
  [[nodiscard]] const std::vector<QWidget*>& editors() const { return editors_; }

  /// Says what is wrong with options that came from elsewhere, until something is edited.
  void complain(const QString& what) { judge(what); }

  /// A profile of options, to and from a file. What is wrong is said in the form; the settings then stay as they are.
  void save(const QString& path);
  void load(const QString& path);

 signals:
  void edited();

 private:
  void build(std::string_view group);
  QWidget* buildExpertPart();
  QWidget* buildFileButtons();
  void add(const SettingField& field, QFormLayout& form);
  void refresh();
  void judge(const QString& refusal);
  void showWhatMatters();

  AcquisitionSettings settings_;
  bool simulated_ = true;
  bool consistent_ = true;
  std::vector<std::function<void()>> refreshers_;
  std::vector<QWidget*> editors_;
  std::vector<std::function<void()>> hiders_;
  QLabel* complaint_ = nullptr;
};

}  // namespace vantage
