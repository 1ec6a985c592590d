#include "session/session_check.h"

#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "session/loss_list.h"
#include "session/session_schema.h"
#include "session/session_states.h"

namespace vantage {
namespace {

// Numbers that no scan has any more.
void checkNumbers(const SessionStore& store, const std::vector<std::int64_t>& numbers, LossList& losses) {
  std::int64_t next = 0;
  for (const std::int64_t number : numbers) {
    losses.addEach(next, number, [&](std::int64_t lost) {
      return Loss{LossKind::ScanDamaged, lost, {}, store.path() + ": scan " + std::to_string(lost) + " does not exist"};
    });
    next = number + 1;
  }
}

void checkScans(SessionStore& store, LossList& losses, const Progress& progress) {
  std::vector<Loss> ofStates;
  SessionStates states(store, ofStates);
  try {
    states.setProfile(SessionStates::parsed(store.profileSource()));
  } catch (const InvalidInput& e) {
    losses.add({LossKind::RowDamaged, {}, "file", e.what()});
  }
  static_cast<void>(store.scanCount());  // no number is out of all bounds
  const std::vector<std::int64_t> numbers = store.scanNumbers();
  checkNumbers(store, numbers, losses);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    progress.checkpoint(static_cast<double>(i) / static_cast<double>(numbers.size()));
    try {
      static_cast<void>(states.scan(numbers[i]));
    } catch (const InvalidInput& e) {
      losses.add({LossKind::ScanDamaged, numbers[i], {}, e.what()});
    }
  }
  for (Loss& loss : ofStates) losses.add(std::move(loss));
}

void checkObject(SessionStore& store, LossList& losses) {
  try {
    const auto object = store.object();
    if (object && object->mesh && hashText(contentHash(*object->mesh)) != object->hash)
      losses.add({LossKind::ObjectChanged, {}, {}, {}});
  } catch (const InvalidInput& e) {
    losses.add({LossKind::RowDamaged, 1, "object", e.what()});
  }
}

}  // namespace

std::vector<Loss> checkRows(SessionStore& store, const Progress& progress) {
  LossList losses;
  for (Loss& loss : store.history().losses) losses.add(std::move(loss));
  if (const std::int64_t lost = store.lostFiles(); lost > 0) losses.add({LossKind::FilesLost, lost, {}, {}});
  // Those of the other tables are named by who reads them.
  for (const char* table : {"meta", "file", "rays", "plan", "model", "event"})
    for (Loss& loss : store.changedRows(table)) losses.add(std::move(loss));
  checkObject(store, losses);
  checkScans(store, losses, progress);
  return losses.all();
}

}  // namespace vantage
