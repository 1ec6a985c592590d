#include "cli/session_run.h"

#include <chrono>
#include <filesystem>

#include "acquisition/apply_command.h"
#include "acquisition/automatic_run.h"
#include "acquisition/next_scan.h"
#include "acquisition/patient_scanner.h"
#include "base/errors.h"
#include "cli/cache_directory.h"
#include "cli/text.h"
#include "io/mesh_writer.h"
#include "planning/choice.h"
#include "positional_space/scanner_images_cache.h"
#include "report/report.h"
#include "report/wording.h"
#include "scanner/simulated_scanner.h"
#include "session/kept_scans.h"

namespace vantage {
namespace {

// A scanner that shows no progress for so long hangs.
constexpr std::chrono::seconds kPatience{120};

}  // namespace

void makeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) throw IoError(path, "cannot be made a folder: " + error.message());
}

std::string viewLine(const AcquisitionState& state) {
  const ViewRecord& record = state.records.back();
  std::string line = "view " + std::to_string(state.views.size()) + " at position " + std::to_string(record.position) +
                     ": " + std::to_string(record.samples) + " samples, +" + number(record.newArea, 0) +
                     " mm2, registration " + std::string(name(record.registration.verdict));
  if (state.views.size() > 1) line += " (" + number(record.registration.rms, 3) + " mm)";
  if (record.plan && record.plan->outcome == PlanOutcome::Found)
    line += ", next " + std::to_string(record.plan->position) + " for " +
            number(promise(record.plan->scores[static_cast<std::size_t>(record.plan->position)]), 0) + " mm2 of void";
  return line;
}

std::string scanLine(const AcquisitionState& before, const AcquisitionState& after) {
  if (after.rejected.size() <= before.rejected.size()) return viewLine(after);
  const RejectedScan& scan = after.rejected.back();
  return "scan at position " + std::to_string(scan.image->position) +
         " was not integrated: registration failed: " + describe(scan.registration.finding);
}

SessionRun::SessionRun(Session& session, std::string out, CommandContext& context)
    : session_(session), out_(std::move(out)), context_(context), last_(session.state()) {}

std::string SessionRun::file(const char* name) const {
  return (std::filesystem::path(out_) / name).string();
}

void SessionRun::run(const Mesh& object) {
  try {
    acquireAll(object);
  } catch (const InvalidInput& e) {
    throw InvalidInput(last_->settings.object + ": " + e.what());
  } catch (const Cancelled&) {
    // The session itself stays where it was: it can be resumed.
    AcquisitionState cancelled = *last_;
    cancelled.termination = Termination::Cancelled;
    last_ = std::make_shared<const AcquisitionState>(std::move(cancelled));
    writeResults();
    throw;
  }
  writeResults();
  announce();
}

void SessionRun::acquireAll(const Mesh& object) {
  if (last_->termination != Termination::Running) return;
  const auto profile = session_.profile();
  const ScannerImages images = loadScannerImages(*profile, cacheDirectory(),
                                                 context_.progress().part(0.0, 1.0, "positional space of the scanner"));
  // Scans that were taken before have moved the turntable, whatever became of them.
  const auto unused = session_.unusedScan();
  const auto taken = static_cast<int>(session_.scanCount());
  const SimulationOptions simulation{last_->settings.seed, last_->settings.ideal};
  PatientScanner scanner(std::make_shared<SimulatedScanner>(object, profile, simulation, taken), kPatience);
  if (!last_->views.empty() && !currentPlan(*last_)) {
    session_.record(ChangeSettings{last_->settings}, planned(*last_, images, context_.progress()));
    last_ = session_.state();
  }
  if (unused) context_.note("scan " + std::to_string(unused->number) + " was not yet added: going on with it");
  const StepObserver observer = [&](const Command& command, const AcquisitionState& state) {
    session_.record(command, state);
    context_.note(scanLine(*last_, state));
    last_ = session_.state();
  };
  static_cast<void>(acquire(*last_, keptScans(scanner, session_), images, observer, context_.progress()));
  if (last_->termination == Termination::Running) {
    // Nothing was left to scan from the beginning.
    const NextScan next = nextScan(*last_);
    session_.record(Finish{next.termination}, [&] {
      AcquisitionState ended = *last_;
      ended.termination = next.termination;
      return ended;
    }());
    last_ = session_.state();
  }
}

void SessionRun::writeResults() {
  report_ = makeReport(*last_, VANTAGE_VERSION);
  writeTextFile(file("report.json"), report_.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!last_->model) return;
  exportModel(*last_->model, file("model.ply"));
  exportModel(*last_->model, file("model.stl"));
}

void SessionRun::announce() {
  const auto& model = report_["model"];
  std::string text =
      std::to_string(last_->views.size()) + " views, ended: " + std::string(name(last_->termination)) + "\n";
  text += "model: " + model["triangles"].dump() + " triangles, " + model["boundary_edges"].dump() +
          " boundary edges, " + number(model["area_mm2"].get<double>(), 0) + " mm2\n";
  for (const auto& r : report_["remaining"])
    text += "left: " + r["edges"].dump() + " edges (" + number(r["length_mm"].get<double>(), 0) + " mm) " +
            r["reason"].get<std::string>() + "\n";
  text += "written: " + file("model.ply") + ", " + file("model.stl") + ", " + file("report.json") + ", " +
          session_.path() + "\n";
  context_.result(report_, text);
}

}  // namespace vantage
