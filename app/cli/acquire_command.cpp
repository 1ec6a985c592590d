#include <filesystem>
#include <memory>
#include <optional>

#include "acquisition/automatic_run.h"
#include "acquisition/report.h"
#include "acquisition/session_file.h"
#include "base/errors.h"
#include "cli/cache_directory.h"
#include "cli/command.h"
#include "cli/text.h"
#include "io/atomic_file.h"
#include "io/mesh_reader.h"
#include "io/mesh_writer.h"
#include "io/placement.h"
#include "planning/choice.h"
#include "positional_space/scanner_images_cache.h"
#include "scanner/simulated_scanner.h"

namespace vantage {
namespace {

struct AcquireArguments {
  std::string scanner;
  std::string out;
  std::string strategy = "ps";
  AcquisitionSettings settings;
};

void makeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) throw IoError(path, "cannot be made a folder: " + error.message());
}

// The object as the scanner will see it.
Mesh placeObject(const AcquireArguments& args, const ScannerProfile& profile, CommandContext& context) {
  const LoadedMesh loaded = loadMesh(args.settings.object, {}, context.progress().part(0.0, 1.0, "read object"));
  if (const std::string repair = describe(loaded.repair); !repair.empty())
    context.note(args.settings.object + ": " + repair);
  const Placement placement = args.settings.placement == "fit" ? Placement::Fit : Placement::AsIs;
  const PlacementTransform transform = computePlacement(loaded.mesh, placement, profile.viewingVolume);
  if (placement == Placement::Fit)
    context.note("placed: scaled by " + number(transform.scale, 6) + ", moved by (" +
                 number(transform.translation.x(), 3) + ", " + number(transform.translation.y(), 3) + ", " +
                 number(transform.translation.z(), 3) + ") mm");
  Mesh object = placed(loaded.mesh, transform);
  if (!isInside(object, profile.viewingVolume))
    context.note("warning: the object reaches out of the viewing volume (radius " +
                 number(profile.viewingVolume.radius, 0) + " mm, height " + number(profile.viewingVolume.height, 0) +
                 " mm); --place fit moves it inside");
  return object;
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

class AcquireCommand {
 public:
  AcquireCommand(const AcquireArguments& args, CommandContext& context) : args_(args), context_(context) {}

  void run() {
    const ProfileSource source = readProfileSource(args_.scanner);
    const auto profile = std::make_shared<const ScannerProfile>(parseProfile(source));
    if (args_.settings.firstView >= static_cast<int>(profile->workspace.size()))
      throw InvalidInput("--first-view is " + std::to_string(args_.settings.firstView) +
                         ", the workspace has positions 0 to " + std::to_string(profile->workspace.size() - 1));
    const Mesh object = placeObject(args_, *profile, context_);
    makeFolder(args_.out);
    SessionFile session = SessionFile::create(file("session.vantage"), source, args_.settings);
    const ScannerImages images = loadScannerImages(
        *profile, cacheDirectory(), context_.progress().part(0.0, 1.0, "positional space of the scanner"));
    SimulatedScanner scanner(object, profile, {args_.settings.seed, args_.settings.ideal});
    last_.profile = profile;
    try {
      last_ = acquire(
          last_, scanner, images, args_.settings, [&](const AcquisitionState& state) { record(session, state); },
          context_.progress());
    } catch (const InvalidInput& e) {
      throw InvalidInput(args_.settings.object + ": " + e.what());
    } catch (const Cancelled&) {
      last_.termination = Termination::Cancelled;
      session.save(last_);
      writeResults();
      throw;
    }
    writeResults();
    announce();
  }

 private:
  [[nodiscard]] std::string file(const char* name) const { return (std::filesystem::path(args_.out) / name).string(); }

  void record(SessionFile& session, const AcquisitionState& state) {
    session.save(state);
    const bool rejected = state.rejected.size() > last_.rejected.size();
    last_ = state;
    if (rejected) {
      context_.note("scan at position " + std::to_string(state.rejected.back().image->position) +
                    " was not integrated: registration failed: " + state.rejected.back().registration.reason);
    } else {
      context_.note(viewLine(state));
    }
  }

  void writeResults() {
    report_ = makeReport(last_, args_.settings, VANTAGE_VERSION);
    writeTextFile(file("report.json"), report_.dump(1) + "\n");
    if (!last_.model) return;
    exportModel(*last_.model, file("model.ply"));
    exportModel(*last_.model, file("model.stl"));
  }

  void announce() {
    const auto& model = report_["model"];
    std::string text =
        std::to_string(last_.views.size()) + " views, ended: " + std::string(name(last_.termination)) + "\n";
    text += "model: " + model["triangles"].dump() + " triangles, " + model["boundary_edges"].dump() +
            " boundary edges, " + number(model["area_mm2"].get<double>(), 0) + " mm2\n";
    for (const auto& r : report_["remaining"])
      text += "left: " + r["edges"].dump() + " edges (" + number(r["length_mm"].get<double>(), 0) + " mm) " +
              r["reason"].get<std::string>() + "\n";
    text += "written: " + file("model.ply") + ", " + file("model.stl") + ", " + file("report.json") + ", " +
            file("session.vantage") + "\n";
    context_.result(report_, text);
  }

  const AcquireArguments& args_;
  CommandContext& context_;
  AcquisitionState last_;
  nlohmann::ordered_json report_;
};

}  // namespace

void addAcquireCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<AcquireArguments>();
  CLI::App* command =
      app.add_subcommand("acquire", "Acquire a mesh with the simulated scanner until nothing scannable is left");
  command->add_option("--object", args->settings.object, "Mesh to put in front of the scanner")->required();
  command->add_option("--scanner", args->scanner, "Scanner profile (JSON)")->required();
  command->add_option("--out", args->out, "Folder for session, model and report")->required();
  command->add_option("--seed", args->settings.seed, "Seed of noise and mechanics")->capture_default_str();
  command->add_flag("--ideal", args->settings.ideal, "Switch noise and mechanical errors off");
  command->add_option("--max-views", args->settings.maxViews, "Stop after so many views")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--tolerance", args->settings.tolerance, "Least confidence wanted everywhere (cosine)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--place", args->settings.placement, "How the mesh gets into the viewing volume")
      ->check(CLI::IsMember({"as-is", "fit"}))
      ->capture_default_str();
  command->add_option("--first-view", args->settings.firstView, "Position of the first view")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--strategy", args->strategy, "ps, uniform:N or random")
      ->capture_default_str()
      ->check([](const std::string& text) {
        try {
          static_cast<void>(parseStrategy(text));
          return std::string();
        } catch (const InvalidInput& e) {
          return std::string(e.what());
        }
      });
  context.addCommonOptions(*command);
  command->callback([args, &context] {
    args->settings.strategy = parseStrategy(args->strategy);
    AcquireCommand(*args, context).run();
  });
}

}  // namespace vantage
