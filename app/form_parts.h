#pragma once

#include <QLabel>
#include <QPushButton>
#include <QString>
#include <functional>

class QGridLayout;

namespace vantage {

/// A label in one of the styles of window_theme.h; wraps its text.
[[nodiscard]] QLabel* makeLabel(const QString& text, const char* role = "");

/// Gives a label another style, at once.
void setRole(QLabel& label, const char* role);

/// A button with a name for assistive technology and tests.
[[nodiscard]] QPushButton* makeButton(const QString& text, const QString& objectName, const QString& help,
                                      bool primary = false);

/// What a control does, for its tooltip while it can be used.
void setHelp(QWidget& control, const QString& help);

/// Enables a control, whose tooltip is its help then, or says in its tooltip why it cannot be used now.
void allow(QWidget& control, const QString& whyNot);

/// Rows of name, value and remark that can be filled again and again.
class FigureTable final : public QWidget {
  Q_OBJECT

 public:
  explicit FigureTable(QWidget* parent = nullptr);

  void clear();
  /// @return the label of the name
  QLabel* add(const QString& name, const QString& value, const QString& remark = {});

 private:
  QGridLayout* grid_;
  int rows_ = 0;
};

}  // namespace vantage
