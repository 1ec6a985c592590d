#pragma once

#include <QWidget>

#include "session_controller.h"

class QVBoxLayout;

namespace vantage {

/// One page of the wizard. It shows what the controller knows and asks the controller for everything.
class WizardPage : public QWidget {
  Q_OBJECT

 public:
  WizardPage(SessionController& controller, QWidget* parent = nullptr);

  [[nodiscard]] virtual QString key() const = 0;  ///< in the session file
  [[nodiscard]] virtual QString title() const = 0;
  [[nodiscard]] virtual QString whatNext() const = 0;  ///< one sentence: what going on will do
  [[nodiscard]] virtual QString nextText() const = 0;  ///< on the button; empty hides it
  [[nodiscard]] virtual bool complete() const = 0;     ///< one may go on
  /// Why one may not go on, for when one may not.
  [[nodiscard]] virtual QString whyNotNext() const;
  /// Whether the set-up has anything to do on this page; if not, the way through the wizard leads past it.
  [[nodiscard]] virtual bool applies() const { return true; }
  virtual void entered() {}  ///< the page has come up
  virtual void leaving() {}  ///< one goes on from here

 signals:
  void changed();                   ///< title, texts or completeness
  void finished();                  ///< go on without being asked
  void wanted(const QString& key);  ///< go to that page
  void eraseWanted();               ///< begin to erase what is not the object

 protected:
  [[nodiscard]] SessionController& controller() const { return controller_; }
  [[nodiscard]] QVBoxLayout& column() const { return *column_; }
  /// Adds a heading.
  void addSection(const QString& text);
  /// Adds a button that begins to erase.
  void addErase();

 private:
  SessionController& controller_;
  QVBoxLayout* column_;
};

}  // namespace vantage
