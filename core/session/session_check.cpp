#include "session/session_check.h"

#include <algorithm>

#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "session/session_schema.h"
#include "session/session_states.h"

namespace vantage {
namespace {

void append(std::vector<Loss>& losses, Loss loss) {
  if (std::find(losses.begin(), losses.end(), loss) == losses.end()) losses.push_back(std::move(loss));
}

void checkScans(SessionStore& store, std::vector<Loss>& losses, const Progress& progress) {
  SessionStates states(store, losses);
  try {
    states.setProfile(SessionStates::parsed(store.profileSource()));
  } catch (const InvalidInput& e) {
    append(losses, {LossKind::RowDamaged, {}, "file", e.what()});
  }
  const std::int64_t count = store.scanCount();
  for (std::int64_t number = 0; number < count; ++number) {
    progress.checkpoint(static_cast<double>(number) / static_cast<double>(count));
    try {
      static_cast<void>(states.scan(number));
    } catch (const InvalidInput& e) {
      append(losses, {LossKind::ScanDamaged, number, {}, e.what()});
    }
  }
}

void checkObject(SessionStore& store, std::vector<Loss>& losses) {
  try {
    const auto object = store.object();
    if (object && object->mesh && hashText(contentHash(*object->mesh)) != object->hash)
      append(losses, {LossKind::ObjectChanged, {}, {}, {}});
  } catch (const InvalidInput& e) {
    append(losses, {LossKind::RowDamaged, 1, "object", e.what()});
  }
}

}  // namespace

std::vector<Loss> checkRows(SessionStore& store, const Progress& progress) {
  std::vector<Loss> losses = store.history().losses;
  if (const std::int64_t lost = store.lostFiles(); lost > 0) append(losses, {LossKind::FilesLost, lost, {}, {}});
  // Those of the other tables are named by who reads them.
  for (const char* table : {"meta", "file", "rays", "plan", "model", "event"})
    for (Loss& loss : store.changedRows(table)) append(losses, std::move(loss));
  checkObject(store, losses);
  checkScans(store, losses, progress);
  return losses;
}

}  // namespace vantage
