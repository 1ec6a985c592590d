#include "permissions.h"

#include <algorithm>

#include "acquisition/may_do.h"
#include "acquisition/stand_composites.h"
#include "devices/real_rig.h"
#include "refusal_text.h"

namespace vantage {
namespace {

std::optional<Refusal> unless(bool possible, RefusalReason reason) {
  return possible ? std::nullopt : std::optional(Refusal{reason, {}});
}

// An acquisition that the operator ended is opened again by scanning on.
std::optional<Refusal> refusalOfScan(const SharedState& now) {
  if (!now) return {};
  AcquisitionState open = *now;
  if (open.termination == Termination::EndedByOperator) open.termination = Termination::Running;
  return mayScan(open);
}

// Whether the object has a model, in work or set aside.
bool hasObject(const AcquisitionState& state) {
  if (compositeInWork(state) == referenceOf(state.stands)) return state.model != nullptr;
  return std::any_of(state.aside.begin(), state.aside.end(),
                     [&](const ModelAside& aside) { return aside.composite == referenceOf(state.stands); });
}

}  // namespace

QString Permissions::busyOr(const std::optional<Refusal>& refusal) const {
  if (at_.busy) return tr("Something else is under way.");
  return refusal ? refusalText(*refusal) : QString();
}

QString Permissions::whyNotChange(const std::optional<Refusal>& refusal) const {
  if (at_.readOnly) return tr("This session is open to be looked at only.");
  return busyOr(refusal);
}

QString Permissions::whyNotScan() const {
  if (QString why = whyNotChange(refusalOfScan(at_.now)); !why.isEmpty()) return why;
  return whyNoDevices();
}

QString Permissions::whyNoDevices() const {
  if (!at_.setUp) return tr("Scanner and object are not read yet.");
  if (at_.setUp->devices) return {};
  if (!at_.setUp->notes.empty())
    return tr("The simulated scanner has nothing to look at: %1").arg(QString::fromStdString(at_.setUp->notes));
  if (at_.sessionOpen) return tr("The scans of this session were recorded elsewhere: no scanner belongs to it.");
  return tr("The simulated scanner needs an object: choose one.");
}

bool Permissions::takesAsTheyCome() const {
  return at_.mode == Mode::Assisted && at_.setUp && turnedByHand(*at_.setUp) &&
         startsByItself(at_.setUp->choice.rig.sensor);
}

QString Permissions::whyNotRun() const {
  if (at_.readOnly || takesAsTheyCome()) return whyNotScan();
  if (at_.mode == Mode::Assisted)
    return tr("You turn the table yourself: scan one view at a time, or choose automatic.");
  if (at_.setUp && turnedByHand(*at_.setUp)) return tr("The table is turned by hand: choose assisted.");
  return whyNotScan();
}

QString Permissions::whyNotTestScan() const {
  if (at_.busy || at_.readOnly) return whyNotChange({});
  if (QString why = whyNoDevices(); !why.isEmpty()) return why;
  // Where its table stands belongs to the session.
  if (at_.sessionOpen && std::holds_alternative<RealDevices>(*at_.setUp->devices))
    return tr("The session has begun. Tests with its devices are made before the first scan.");
  return {};
}

QString Permissions::whyNotTestTurn() const {
  if (QString why = whyNotTestScan(); !why.isEmpty()) return why;
  return at_.setUp->profile->workspace.steps > 1 ? QString() : tr("This scanner has no turntable.");
}

QString Permissions::whyNot(const Command& command) const {
  if (!at_.sessionOpen || !at_.now) return tr("There is no session yet: it begins with the first scan.");
  return whyNotChange(mayDo(*at_.now, command));
}

QString Permissions::whyNotUndo() const {
  return whyNotChange(unless(at_.somethingBefore, RefusalReason::NothingToUndo));
}

QString Permissions::whyNotRedo() const {
  return whyNotChange(unless(at_.somethingUndone, RefusalReason::NothingToRedo));
}

QString Permissions::whyNotExport() const {
  return busyOr(unless(at_.now && hasObject(*at_.now), RefusalReason::NothingScanned));
}

QString Permissions::whyNotAddScans() const {
  if (!at_.sessionOpen || !at_.now) return tr("There is no session yet: it begins with the first scan.");
  return whyNotChange(unless(at_.now->profile != nullptr, RefusalReason::NoProfile));
}

QString Permissions::whyNotCompareStands() const {
  if (at_.busy) return tr("Something else is under way.");
  if (!at_.now || at_.now->stands.size() < 2) return tr("The object has stood in one stand only.");
  return standsToAlign(*at_.now).empty() ? tr("All stands that have views are in place.") : QString();
}

QString Permissions::whyNotErase() const {
  return whyNot(EraseRegion{at_.now ? at_.now->stand() : 0, BelowPlane{}, true});
}

QString Permissions::whyNotOpen() const {
  return busyOr({});
}

QString Permissions::whyNotClose() const {
  return at_.sessionOpen ? busyOr({}) : tr("No session is open.");
}

}  // namespace vantage
