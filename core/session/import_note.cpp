#include "session/import_note.h"

#include <numeric>

#include "session/reading_json.h"

namespace vantage {
namespace {

constexpr const char* kNote = "import";

}  // namespace

void noteImport(Session& session, const std::vector<ScanReading>& readings) {
  session.setNote(kNote, nlohmann::json{{"readings", readingsJson(readings)}}.dump());
}

std::optional<ImportScans> interruptedImport(const Session& session) {
  const std::string note = session.note(kNote);
  if (note.empty() || !session.history().current().outline->scans.empty()) return std::nullopt;
  const std::string what = session.path() + ": the remark of its import";
  const nlohmann::json json = jsonObject(note, what);
  ImportScans command;
  command.readings = readingsFrom(JsonFields(json, what).list("readings"), what);
  const auto kept = static_cast<std::size_t>(session.scanCount());
  if (kept != command.readings.size())
    throw InvalidInput(session.path() + ": its import was interrupted when " + std::to_string(kept) + " of " +
                       std::to_string(command.readings.size()) + " scans were kept: import the files once more");
  command.scans.resize(kept);
  std::iota(command.scans.begin(), command.scans.end(), 0);
  return command;
}

}  // namespace vantage
