#include "cli/session_run.h"

#include <utility>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "cli/cache_directory.h"
#include "cli/text.h"
#include "devices/device_factory.h"
#include "planning/choice.h"
#include "positional_space/scanner_images_cache.h"
#include "report/report.h"
#include "report/wording.h"

namespace vantage {
namespace {

std::string positionText(const KeptScan& scan) {
  return scan.station().position ? std::to_string(*scan.station().position) : "none";
}

std::string viewLine(const AcquisitionState& state, const KeptScan& scan) {
  const ScanRecord& record = scan.record;
  const std::size_t views = countScans(state, ScanStatus::In);
  std::string line = "view " + std::to_string(views) + " at position " + positionText(scan) + ": " +
                     std::to_string(record.samples) + " samples, +" + number(record.newArea, 0) +
                     " mm2, registration " + std::string(name(record.registration.verdict));
  if (views > 1) line += " (" + number(record.registration.rms, 3) + " mm)";
  if (record.planAfter && record.planAfter->outcome == PlanOutcome::Found)
    line += ", next " + std::to_string(record.planAfter->position.value()) + " for " +
            number(promise(record.planAfter->scores[static_cast<std::size_t>(record.planAfter->position.value())]), 0) +
            " mm2 of void";
  return line;
}

}  // namespace

std::string lastScanLine(const AcquisitionState& state) {
  const KeptScan& scan = state.scans.back();
  switch (scan.status) {
    case ScanStatus::Rejected:
      return "scan at position " + positionText(scan) +
             " was not integrated: registration failed: " + describe(scan.record.registration.finding);
    case ScanStatus::Waiting:
      return "scan at position " + positionText(scan) + " waits until it is known how the object stands";
    default:
      return viewLine(state, scan);
  }
}

void changeSettings(Session& session, const AcquisitionSettings& settings, CommandContext& context) {
  if (settings == session.state()->settings) return;
  AcquisitionTools tools;
  if (const auto profile = session.profile())
    tools.images = std::make_shared<const ScannerImages>(loadScannerImages(
        *profile, cacheDirectory(), context.progress().part(0.0, 0.5, "positional space of the scanner")));
  Acquisition(session, tools).carryOut(ChangeSettings{settings}, context.progress().part(0.5, 1.0));
}

SessionRun::SessionRun(Session& session, std::string out, CommandContext& context)
    : session_(session), results_(std::move(out)), context_(context), last_(session.state()) {}

void SessionRun::run(const std::shared_ptr<const Mesh>& object) {
  try {
    acquireAll(object);
  } catch (const InvalidInput& e) {
    throw InvalidInput(last_->settings.simulation.object + ": " + e.what());
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

void SessionRun::acquireAll(const std::shared_ptr<const Mesh>& object) {
  if (last_->termination != Termination::Running) return;
  const auto profile = session_.profile();
  const auto images = std::make_shared<const ScannerImages>(loadScannerImages(
      *profile, cacheDirectory(), context_.progress().part(0.0, 1.0, "positional space of the scanner")));
  // Scans that were taken before have moved the turntable, whatever became of them.
  const Simulated devices{object, profile, {last_->settings.simulation.seed, last_->settings.simulation.ideal}};
  const Rig rig = DeviceFactory().open(devices, session_.scanCount(), context_.progress());
  if (const auto unused = session_.unusedScan())
    context_.note("scan " + std::to_string(unused->number) + " was not yet added: going on with it");
  Acquisition acquisition(session_, {rig, images}, [&](const Command& command, const auto& /*before*/, const auto&) {
    last_ = session_.state();
    if (std::holds_alternative<AddScan>(command)) context_.note(lastScanLine(*last_));
  });
  acquisition.runUntilTheEnd(context_.progress());
}

void SessionRun::writeResults() {
  report_ = makeReport(*last_, VANTAGE_VERSION);
  results_.write(*last_, report_);
}

void SessionRun::announce() {
  const auto& model = report_["model"];
  std::string text = std::to_string(countScans(*last_, ScanStatus::In)) +
                     " views, ended: " + std::string(name(last_->termination)) + "\n";
  text += "model: " + model["triangles"].dump() + " triangles, " + model["boundary_edges"].dump() +
          " boundary edges, " + number(model["area_mm2"].get<double>(), 0) + " mm2\n";
  for (const auto& r : report_["remaining"])
    text += "left: " + r["edges"].dump() + " edges (" + number(r["length_mm"].get<double>(), 0) + " mm) " +
            r["reason"].get<std::string>() + "\n";
  text += "written: " + results_.file("model.ply") + ", " + results_.file("model.stl") + ", " +
          results_.file("report.json") + ", " + session_.path() + "\n";
  context_.result(report_, text, warningsOf(*last_));
}

void tellMemoryNeeded(const ScannerProfile& profile, CommandContext& context) {
  // Measured at the peak, with 9 million rays.
  constexpr double kBytesPerRay = 170.0;
  constexpr double kWorthSaying = 300.0;  // [MB]
  const auto rays = static_cast<double>(profile.rays->size());
  if (const double megabytes = rays * kBytesPerRay / 1e6; megabytes > kWorthSaying)
    context.note("the scanner has " + number(rays / 1e6, 1) + " million rays: this takes about " +
                 number(megabytes / 1e3, 1) + " GB of memory, and every step some time");
}

}  // namespace vantage
