#pragma once

#include <QMessageBox>
#include <QPointer>
#include <QStringList>

namespace vantage {

/// What failed, for people.
struct FailureText {
  QString sentence;  ///< names a file without its folder
  QString place;     ///< the folder; empty where no file is named
};

/// @param what "/folder/file: what is wrong with it", as the engine says it, or a sentence
[[nodiscard]] FailureText readableFailure(const QString& what);

/// What the operator has to know of: in one dialog at a time. What comes while it is open is added to it.
class Notices final {
 public:
  /// @param window that the dialog belongs to, and that outlives this
  explicit Notices(QWidget& window) : window_(window) {}

  /// @param details are folded away
  void show(const QString& what, const QStringList& details = {});
  /// Null while there is none.
  [[nodiscard]] QMessageBox* dialog() const { return box_; }

 private:
  QWidget& window_;
  QPointer<QMessageBox> box_;
  QStringList said_;
};

}  // namespace vantage
