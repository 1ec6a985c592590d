#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "acquisition/command.h"
#include "present.h"
#include "set_up.h"

namespace vantage {

/// All that decides what the operator may do at a moment.
struct Situation {
  bool busy = false;             ///< something is under way
  bool sessionOpen = false;      ///< a session has begun or was opened
  Mode mode = Mode::Automatic;   ///< who takes the next step
  SharedSetUp setUp = nullptr;   ///< nothing before it was read
  SharedState now = nullptr;     ///< nothing before the first scan
  bool somethingBefore = false;  ///< there is a step to undo
  bool somethingUndone = false;  ///< there is a step to redo
  bool readOnly = false;         ///< the session may only be looked at
};

/// Why something cannot be done now, as a sentence for the operator; empty when it can.
class Permissions {
  Q_DECLARE_TR_FUNCTIONS(Permissions)

 public:
  explicit Permissions(Situation situation) : at_(std::move(situation)) {}

  [[nodiscard]] QString whyNotRun() const;
  /// Whether scans come by themselves while a person turns the table.
  [[nodiscard]] bool takesAsTheyCome() const;
  [[nodiscard]] QString whyNotScan() const;
  [[nodiscard]] QString whyNotTestScan() const;
  [[nodiscard]] QString whyNotTestTurn() const;
  /// Why the set-up has nothing to scan with, whatever else is under way.
  [[nodiscard]] QString whyNoDevices() const;
  [[nodiscard]] QString whyNot(const Command& command) const;
  [[nodiscard]] QString whyNotUndo() const;
  [[nodiscard]] QString whyNotRedo() const;
  [[nodiscard]] QString whyNotExport() const;
  /// Why scans of files cannot be added to the open session.
  [[nodiscard]] QString whyNotAddScans() const;
  /// Why there is no stand whose place in the object could be looked at.
  [[nodiscard]] QString whyNotCompareStands() const;
  /// Why nothing can be erased from the model.
  [[nodiscard]] QString whyNotErase() const;
  [[nodiscard]] QString whyNotOpen() const;
  [[nodiscard]] QString whyNotClose() const;

 private:
  [[nodiscard]] QString busyOr(const std::optional<Refusal>& refusal) const;
  /// The same of what would change the session.
  [[nodiscard]] QString whyNotChange(const std::optional<Refusal>& refusal) const;

  Situation at_;
};

}  // namespace vantage
