#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <functional>

#include "settings/field_table.h"

namespace vantage {

namespace detail {

template <typename T>
QWidget* makeEditor(const typename Field<T>::Switch& field, T& values, const std::function<void()>& changed) {
  auto* box = new QCheckBox;
  box->setChecked(values.*field.value);
  QObject::connect(box, &QCheckBox::toggled, [&values, field, changed](bool on) {
    values.*field.value = on;
    changed();
  });
  return box;
}

template <typename T>
QWidget* makeEditor(const typename Field<T>::Whole& field, T& values, const std::function<void()>& changed) {
  auto* box = new QSpinBox;
  box->setRange(field.least, field.most);
  box->setSuffix(field.unit);
  box->setValue(values.*field.value);
  QObject::connect(box, &QSpinBox::valueChanged, [&values, field, changed](int value) {
    values.*field.value = value;
    changed();
  });
  return box;
}

template <typename T>
QWidget* makeEditor(const typename Field<T>::Number& field, T& values, const std::function<void()>& changed) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(field.decimals);
  box->setRange(field.least, field.most);
  box->setSingleStep((field.most - field.least) / 20.0);
  box->setSuffix(field.unit);
  box->setValue(values.*field.value);
  QObject::connect(box, &QDoubleSpinBox::valueChanged, [&values, field, changed](double value) {
    values.*field.value = value;
    changed();
  });
  return box;
}

template <typename T>
QWidget* makeEditor(const typename Field<T>::Choice& field, T& values, const std::function<void()>& changed) {
  auto* box = new QComboBox;
  box->addItems(field.options);
  box->setCurrentIndex(values.*field.value);
  QObject::connect(box, &QComboBox::currentIndexChanged, [&values, field, changed](int index) {
    values.*field.value = index;
    changed();
  });
  return box;
}

template <typename T>
QWidget* makeEditor(const typename Field<T>::Named& field, T& values, const std::function<void()>& changed) {
  auto* box = new QComboBox;
  for (qsizetype i = 0; i < field.codes.size(); ++i) box->addItem(field.names[i], field.codes[i]);
  box->setCurrentIndex(static_cast<int>(field.codes.indexOf(values.*field.value)));
  QObject::connect(box, &QComboBox::currentIndexChanged, [&values, field, changed](int index) {
    values.*field.value = field.codes[index];
    changed();
  });
  return box;
}

}  // namespace detail

/// Fills a form with an editor for every field. `values` must outlive the form; `changed` is called after every edit.
template <typename T>
void fillForm(QFormLayout& form, const FieldTable<T>& fields, T& values, const std::function<void()>& changed) {
  for (const Field<T>& field : fields) {
    QWidget* editor =
        std::visit([&](const auto& kind) { return detail::makeEditor<T>(kind, values, changed); }, field.kind);
    editor->setObjectName(field.key);
    editor->setAccessibleName(field.label);
    editor->setToolTip(field.help);
    form.addRow(field.label, editor);
  }
}

/// Reads what the file has of the fields; what is missing or out of bounds stays as it is.
template <typename T>
void readFields(const QSettings& file, const FieldTable<T>& fields, T& values) {
  for (const Field<T>& field : fields) {
    const QVariant stored = file.value(field.key);
    if (!stored.isValid()) continue;
    std::visit(
        [&](const auto& kind) {
          using Kind = std::decay_t<decltype(kind)>;
          if constexpr (std::is_same_v<Kind, typename Field<T>::Switch>)
            values.*kind.value = stored.toBool();
          else if constexpr (std::is_same_v<Kind, typename Field<T>::Choice>)
            values.*kind.value = std::clamp(stored.toInt(), 0, static_cast<int>(kind.options.size()) - 1);
          else if constexpr (std::is_same_v<Kind, typename Field<T>::Named>)
            values.*kind.value = kind.codes.contains(stored.toString()) ? stored.toString() : values.*kind.value;
          else if constexpr (std::is_same_v<Kind, typename Field<T>::Whole>)
            values.*kind.value = std::clamp(stored.toInt(), kind.least, kind.most);
          else
            values.*kind.value = std::clamp(stored.toDouble(), kind.least, kind.most);
        },
        field.kind);
  }
}

template <typename T>
void writeFields(QSettings& file, const FieldTable<T>& fields, const T& values) {
  for (const Field<T>& field : fields)
    std::visit([&](const auto& kind) { file.setValue(field.key, values.*kind.value); }, field.kind);
}

}  // namespace vantage
