#include "settings/settings_form.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "acquisition/setting_lookup.h"
#include "acquisition/settings_json.h"
#include "acquisition/settings_table.h"
#include "base/errors.h"
#include "form_parts.h"
#include "settings/setting_editor.h"

namespace vantage {
namespace {

QFormLayout* makeForm(QVBoxLayout& column) {
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  column.addLayout(form);
  return form;
}

// Whether a setting says anything to a real scanner, too: the seed is also that of positions taken at random.
bool concernsRealScanners(const SettingField& field, const AcquisitionSettings& settings) {
  if (groupOf(field) != "simulation") return true;
  return field.key == "simulation.seed" && settings.strategy.kind == Strategy::Kind::Random;
}

QString labelOf(const SettingField& field) {
  const QString label = settingWords(field.label);
  return field.unit.empty() ? label : label + QStringLiteral(" [%1]").arg(settingWords(field.unit));
}

}  // namespace

SettingsForm::SettingsForm(std::string_view group, QWidget* parent) : QWidget(parent) {
  build(group);
}

void SettingsForm::build(std::string_view group) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  QFormLayout* basic = makeForm(*column);
  for (const SettingField& field : settingFields())
    if (group.empty() ? field.audience == SettingAudience::Basic : groupOf(field) == group) add(field, *basic);
  complaint_ = makeLabel({}, "warning");
  complaint_->setObjectName(QStringLiteral("settings_complaint"));
  complaint_->hide();
  if (!group.empty()) {
    column->addWidget(complaint_);
    return;
  }

  auto* unfold = new QToolButton;
  unfold->setObjectName(QStringLiteral("expert_settings"));
  unfold->setText(tr("Options for experts"));
  unfold->setAccessibleName(unfold->text());
  unfold->setToolTip(tr("Show the options of every operation."));
  unfold->setCheckable(true);
  unfold->setArrowType(Qt::RightArrow);
  unfold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  QWidget* expert = buildExpertPart();
  expert->hide();
  connect(unfold, &QToolButton::toggled, expert, [unfold, expert](bool on) {
    unfold->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    expert->setVisible(on);
  });
  column->addWidget(unfold);
  column->addWidget(expert);
  column->addWidget(complaint_);
}

QWidget* SettingsForm::buildExpertPart() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(buildFileButtons());
  QFormLayout* form = nullptr;
  std::string_view group;
  for (const SettingField& field : settingFields()) {
    if (field.audience != SettingAudience::Expert) continue;
    if (form == nullptr || groupOf(field) != group) {
      group = groupOf(field);
      column->addWidget(makeLabel(settingWords(groupLabel(group)), "section"));
      form = makeForm(*column);
    }
    add(field, *form);
  }
  return part;
}

QWidget* SettingsForm::buildFileButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  QPushButton* loadButton = makeButton(tr("Load options…"), QStringLiteral("load_options"),
                                       tr("Take all options from a file that was saved before."));
  QPushButton* saveButton = makeButton(tr("Save options…"), QStringLiteral("save_options"),
                                       tr("Keep all options in a file, for here and for the command line."));
  editors_.push_back(loadButton);
  connect(loadButton, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Load options"), {}, tr("Options (*.json)"));
    if (!path.isEmpty()) load(path);
  });
  connect(saveButton, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save options"), {}, tr("Options (*.json)"));
    if (!path.isEmpty()) save(path);
  });
  layout->addWidget(loadButton);
  layout->addWidget(saveButton);
  layout->addStretch();
  return row;
}

void SettingsForm::add(const SettingField& field, QFormLayout& form) {
  const SettingEditor editor = makeSettingEditor(field, settings_, [this](const QString& refusal) {
    judge(refusal);
    emit edited();
  });
  refreshers_.push_back(editor.refresh);
  editors_.push_back(editor.widget);
  // As narrow as the page: a line is scrolled in its editor, not out of sight.
  editor.widget->setMinimumWidth(1);
  editor.widget->setSizePolicy(QSizePolicy::Ignored, editor.widget->sizePolicy().verticalPolicy());
  form.addRow(labelOf(field), editor.widget);
  hiders_.emplace_back([this, &field, &form, widget = editor.widget] {
    form.setRowVisible(widget, simulated_ || concernsRealScanners(field, settings_));
  });
}

void SettingsForm::setSimulated(bool simulated) {
  simulated_ = simulated;
  showWhatMatters();
}

void SettingsForm::showWhatMatters() {
  for (const auto& hide : hiders_) hide();
}

void SettingsForm::setSettings(const AcquisitionSettings& settings) {
  settings_ = settings;
  refresh();
  judge({});
}

void SettingsForm::refresh() {
  for (const auto& refreshOne : refreshers_) refreshOne();
}

// A refused value is told before a contradiction.
void SettingsForm::judge(const QString& refusal) {
  QString complaint = refusal;
  consistent_ = true;
  try {
    checkSettings(settings_);
  } catch (const InvalidInput& e) {
    consistent_ = false;
    if (complaint.isEmpty()) complaint = QString::fromUtf8(e.what());
  }
  showWhatMatters();
  complaint_->setText(complaint);
  complaint_->setVisible(!complaint.isEmpty());
}

void SettingsForm::save(const QString& path) {
  try {
    writeOptions(path.toStdString(), settings_);
    judge({});
  } catch (const Error& e) {
    judge(QString::fromUtf8(e.what()));
  }
}

void SettingsForm::load(const QString& path) {
  try {
    setSettings(readOptions(path.toStdString(), settings_));
    emit edited();
  } catch (const Error& e) {
    judge(QString::fromUtf8(e.what()));
  }
}

}  // namespace vantage
