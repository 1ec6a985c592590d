#include "session_start.h"

#include <filesystem>

#include "base/errors.h"
#include "positional_space/scanner_images_cache.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// The devices that a session is scanned with.
constexpr const char* kRigNote = "rig";

// A session may come from anywhere: it runs no program that it names.
void restoreRig(const Session& session, SetUp& setUp) {
  const std::string text = session.note(kRigNote);
  if (text.empty()) return;
  try {
    const RigDescription rig = parseRigFile(text, session.path()).rig;
    if (std::holds_alternative<ProgramDevice>(rig.sensor) || std::holds_alternative<ProgramDevice>(rig.table))
      throw InvalidInput(session.path() + ": was scanned with a program, which is not run because a session names it");
    setUp.choice.rig = rig;
  } catch (const InvalidInput& e) {
    setUp.notes = e.what();
  }
}

}  // namespace

std::string freeSessionName(const std::string& folder) {
  fs::path path = fs::path(folder) / "session.vantage";
  for (int i = 2; fs::exists(path); ++i) path = fs::path(folder) / ("session-" + std::to_string(i) + ".vantage");
  return path.string();
}

void rememberDevices(Session& session, const SetUp& setUp) {
  const std::string text = rigFileText({setUp.choice.rig, {}});
  if (session.note(kRigNote) != text) session.setNote(kRigNote, text);
}

std::shared_ptr<Session> createSession(const SetUp& setUp) {
  std::error_code error;
  fs::create_directories(setUp.choice.folder, error);
  if (error) throw IoError(setUp.choice.folder, "cannot be made a folder: " + error.message());
  const Mesh* object = setUp.object ? setUp.object->mesh.get() : nullptr;
  auto session = std::make_shared<Session>(Session::create(
      freeSessionName(setUp.choice.folder), {setUp.source, setUp.choice.settings, object, setUp.profile}));
  rememberDevices(*session, setUp);
  return session;
}

OpenedSession openSession(const std::string& path, SessionAccess access, const std::string& cacheFolder,
                          const Progress& progress) {
  OpenedSession opened;
  opened.access = access;
  opened.session = std::make_shared<Session>(Session::open(path, access, progress.part(0.0, 0.4, "read session")));
  auto setUp = std::make_shared<SetUp>();
  setUp->choice.settings = opened.session->state()->settings;
  setUp->choice.folder = fs::path(path).parent_path().string();
  setUp->profile = opened.session->profile();
  if (!setUp->profile) {
    opened.setUp = setUp;
    return opened;
  }
  restoreRig(*opened.session, *setUp);
  if (!std::holds_alternative<SimulatedSensorDevice>(setUp->choice.rig.sensor)) {
    connectDevices(*setUp);
  } else if (!setUp->choice.settings.simulation.object.empty()) {
    try {
      Mesh mesh = opened.session->object(progress.part(0.4, 0.5, "read object"));
      placeObject(*setUp, std::make_shared<const Mesh>(std::move(mesh)));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      // Everything but a further scan works without the object.
      setUp->notes = e.what();
    }
  }
  setUp->images = std::make_shared<const ScannerImages>(
      loadScannerImages(*setUp->profile, cacheFolder, progress.part(0.5, 1.0, "positional space of the scanner")));
  opened.setUp = setUp;
  return opened;
}

}  // namespace vantage
