#include <memory>
#include <optional>

#include "acquisition/acquisition.h"
#include "acquisition/other_turn.h"
#include "base/errors.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "cli/text.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "report/report.h"
#include "report/wording.h"

namespace vantage {
namespace {

struct TakeArguments {
  std::string session;
  std::optional<std::int64_t> scan;
  std::optional<double> tableDeg;
};

// The scan that was said, else the last one that was refused and fits elsewhere.
const KeptScan& scanMeant(const TakeArguments& args, const AcquisitionState& state) {
  for (auto scan = state.scans.rbegin(); scan != state.scans.rend(); ++scan)
    if (args.scan ? scan->number == *args.scan : !turnsThatFit(state, *scan).empty()) return *scan;
  if (args.scan) throw InvalidInput(args.session + ": has no scan " + std::to_string(*args.scan));
  throw InvalidInput(args.session + ": has no refused scan that was found to fit another turn of the table");
}

double turnMeant(const TakeArguments& args, const AcquisitionState& state, const KeptScan& scan) {
  if (args.tableDeg) return *args.tableDeg;
  const std::vector<double> turns = turnsThatFit(state, scan);
  if (turns.size() == 1) return turns.front();
  std::string fits;
  for (const double turn : turns) fits += (fits.empty() ? "" : ", ") + number(turn, 1);
  throw InvalidInput("scan " + std::to_string(scan.number) +
                     (turns.empty() ? " was not found to fit another turn of the table"
                                    : " fits at " + fits + " degrees: say with --table-deg where the table stood"));
}

void runTake(const TakeArguments& args, CommandContext& context) {
  Session session = openSession(args.session, SessionAccess::Write, context);
  const auto before = session.state();
  const KeptScan& scan = scanMeant(args, *before);
  const TakeAsFrom command{scan.number, turnMeant(args, *before, scan)};
  AcquisitionTools tools;
  if (const auto profile = session.profile())
    tools.images = std::make_shared<const ScannerImages>(loadScannerImages(
        *profile, cacheDirectory(), context.progress().part(0.0, 0.2, "positional space of the scanner")));
  Acquisition acquisition(session, tools);
  acquisition.carryOut(command, context.progress().part(0.2, 1.0));
  const auto after = session.state();
  const KeptScan& taken = *findScan(*after, command.scan);
  const std::optional<int> next = nextPosition(*after);
  context.result({{"scan", command.scan},
                  {"table_deg", command.tableDeg},
                  {"status", name(taken.status)},
                  {"views", countScans(*after, ScanStatus::In)},
                  {"registration", registrationJson(taken.record.registration)},
                  {"next_position", next.value_or(-1)},
                  {"state", name(after->termination)}},
                 describe(Command(command)) + "\n" +
                     (next ? "next best view: position " + std::to_string(*next)
                           : "nothing is left to scan: " + std::string(name(after->termination))) +
                     "\n");
}

}  // namespace

void addTakeCommand(CLI::App& app, CommandContext& context) {
  auto args = std::make_shared<TakeArguments>();
  CLI::App* command = app.add_subcommand("take", "Take a refused scan as from the turn of the table that it fits");
  command->add_option("session", args->session, "Session file")->required();
  command->add_option("--scan", args->scan, "Number of the scan; the last one that was found to fit when not given");
  command->add_option("--table-deg", args->tableDeg,
                      "Where the table stood [deg from the first position, counter-clockwise seen from above]; needed "
                      "only where the scan fits in several places");
  context.addCommonOptions(*command);
  command->callback([args, &context] { runTake(*args, context); });
}

}  // namespace vantage
