#pragma once

#include <QDialog>

#include "session_import.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace vantage {

class ScanList;
class SessionController;

/// Asks what has to be known of range files that were recorded elsewhere, and lets the controller bring them in: into a
/// new session, or into the open one, then with the position of each. What is wrong is said here, and nothing that was
/// typed is lost.
class ImportDialog final : public QDialog {
  Q_OBJECT

 public:
  enum class Into { NewSession, OpenSession };

  ImportDialog(SessionController& controller, Into into, QWidget* parent = nullptr);

  /// The profile that the scans may have been taken with, and the settings and folder of the new session.
  void suggest(const ImportChoice& choice);
  void addFiles(const QStringList& paths);
  /// Stops what is under way, and closes only when nothing is.
  void reject() override;

 private:
  void build();
  void browsePoses();
  void refresh();
  void bringIn();
  [[nodiscard]] ImportChoice choice() const;
  [[nodiscard]] QString whyNot() const;
  void say(const QString& complaint);

  SessionController& controller_;
  Into into_;
  ImportChoice suggested_;
  ScanList* list_;
  QComboBox* scanner_;
  QLineEdit* poses_;
  QComboBox* unit_;
  QComboBox* frame_;
  QLineEdit* grid_;
  QLineEdit* noSample_;
  QLineEdit* folder_;
  QLabel* complaint_;
  QDialogButtonBox* buttons_;
};

}  // namespace vantage
