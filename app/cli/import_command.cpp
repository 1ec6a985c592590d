#include <memory>
#include <optional>

#include "acquisition/acquisition.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/import_result.h"
#include "cli/new_session.h"
#include "cli/reading_arguments.h"
#include "cli/session_run.h"
#include "cli/settings_arguments.h"
#include "io/recorded_scans.h"
#include "scanner/profile_size.h"
#include "session/import_note.h"
#include "session/session.h"
#include "session/session_place.h"

namespace vantage {
namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string poses;
  std::string scanner = "generic";
  std::vector<int> positions;
  std::string session;
  bool replace = false;
  ReadingArguments reading;
  SettingsArguments given;
};

RecordedScans recordedScans(const ImportArguments& args) {
  RecordedScans recorded{args.files, args.poses, {}, args.reading.options()};
  recorded.positions.assign(args.positions.begin(), args.positions.end());
  return recorded;
}

// In the words of the command line.
void checkPositions(const ImportArguments& args, const ScannerProfile* profile) {
  if (args.positions.empty()) return;
  if (profile == nullptr) throw InvalidInput("--position needs --scanner PROFILE.json, which has the positions");
  if (!args.poses.empty()) throw InvalidInput("--position and --poses both say where the scans were taken: give one");
}

// Before anything is made of the scans.
void checkPlace(const ImportArguments& args) {
  try {
    checkSessionPlace(args.session, args.replace);
  } catch (const InvalidInput& e) {
    const std::size_t others = args.files.size() - 1;
    throw InvalidInput(std::string(e.what()) + "; not imported: " + args.files.front() +
                       (others > 0 ? " and " + std::to_string(others) + " more" : ""));
  }
}

void runImport(const ImportArguments& args, CommandContext& context) {
  std::optional<ProfileSource> source;
  std::shared_ptr<const ScannerProfile> profile;
  if (args.scanner != "generic") {
    source = readProfileSource(args.scanner);
    tellMemoryNeeded(raysSaidBy(*source), args.given.applied({}), args.files.size() - 1, context);
    profile = std::make_shared<const ScannerProfile>(parseProfile(*source));
  }
  const Progress progress = context.progress();
  checkPositions(args, profile.get());
  std::vector<ReadScan> scans =
      readRecordedScans(recordedScans(args), profile.get(), progress.part(0.0, 0.1, "read scans"));
  checkPlace(args);
  const std::string lines = readingLines(args.files, scans);
  const std::vector<std::string> labels = labelsOf(args.files, scans);
  std::vector<RangeImage> images;
  std::vector<ScanReading> readings;
  for (ReadScan& scan : scans) {
    images.push_back(std::move(scan.image));
    readings.push_back(scan.reading);
  }
  std::shared_ptr<const AcquisitionState> state;
  workOnNewSession({args.session, args.replace, false, {source, args.given.applied({}), nullptr, profile}}, context,
                   [&](Session& session) {
                     noteImport(session, readings);
                     Acquisition(session).importScans(std::move(images), progress.part(0.1, 0.9), readings);
                     state = session.state();
                   });
  if (state->model->mesh.empty())
    context.note(lines + "if that is not right, say --unit, --frame or --no-sample (import --help)");
  announceImport({args.session, labels, lines}, *state, context, progress.part(0.9, 1.0));
}

}  // namespace

void addImportCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<ImportArguments>();
  CLI::App* command = app.add_subcommand("import", "Register and integrate recorded scans and say what is still void");
  command
      ->add_option(
          "range", args->files,
          "Range files: PLY, PCD, PTX, 16-bit depth PNG, XYZ; with rows and columns where no scanner profile is given")
      ->required();
  command->add_option("--poses", args->poses, "Stanford .conf with a rough pose for every scan");
  command->add_option("--scanner", args->scanner, "Scanner profile (JSON), or generic: the rays are found")
      ->capture_default_str();
  command->add_option("--position", args->positions, "Positions of the profile's workspace that they were taken from")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::NonNegativeNumber);
  command->add_option("--session", args->session, "Session file to write")->required();
  command->add_flag("--replace", args->replace,
                    "Replace a session of that name; it is kept aside until the new one is whole");
  args->reading.addTo(*command);
  args->given.addTo(*command);
  context.addCommonOptions(*command);
  command->callback([args, &context] { runImport(*args, context); });
}

}  // namespace vantage
