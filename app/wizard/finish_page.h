#pragma once

#include <functional>

#include "wizard/wizard_page.h"

class QLabel;
class QPushButton;

namespace vantage {

/// Model and report go out.
class FinishPage final : public WizardPage {
  Q_OBJECT

 public:
  explicit FinishPage(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("finish"); }
  [[nodiscard]] QString title() const override { return tr("Finish"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override { return tr("&New session"); }
  [[nodiscard]] bool complete() const override;
  void entered() override;
  void leaving() override;

  /// Asks where to, and writes the model; asks before it replaces a file.
  /// @pre nothing is against it (Permissions::whyNotExport), for both
  void exportAs();
  /// Writes the report to its place in the session's folder; asks before it replaces one.
  void report();

 signals:
  void reportRequested(const QString& path);  ///< with pictures, which a page cannot make

 private:
  QPushButton* addExport(const QString& text, const QString& name, const QString& file, const QString& help,
                         bool primary);
  void writeTo(const QString& path, const std::function<void(const QString& path)>& write);
  [[nodiscard]] QString inFolder(const QString& file) const;
  void exportForPrint();
  void addLine(const QString& line);
  void refresh();

  QLabel* place_;
  QLabel* missing_;
  QLabel* written_;
  QList<QPushButton*> exports_;
};

/// A path that ends as the filter of a file dialog says, unless it already ends as a model's does.
[[nodiscard]] QString withSuffix(const QString& path, const QString& filter);

}  // namespace vantage
