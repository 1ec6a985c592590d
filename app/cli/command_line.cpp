#include "cli/command_line.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/errors.h"
#include "cli/stop_signals.h"
#include "program/crash_trace.h"
#include "program/user_folders.h"
#include "program/version.h"

namespace vantage {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUse = 2;
constexpr int kCancelled = 3;
constexpr int kDoneBut = 4;

int carryOut(CLI::App& app, CommandContext& context, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return context.warned() ? kDoneBut : kDone;
  } catch (const CLI::ParseError& e) {
    const bool asked = app.exit(e) == 0;
    if (asked && !std::cout.flush()) {
      context.note("vantage-cli: standard output cannot be written");
      return kFailed;
    }
    return asked ? kDone : kWrongUse;
  } catch (const Cancelled&) {
    context.note("vantage-cli: cancelled");
    return kCancelled;
  } catch (const std::bad_alloc&) {
    context.note("vantage-cli: not enough memory for this input");
    return kFailed;
  } catch (const std::exception& e) {
    context.note(std::string("vantage-cli: ") + e.what());
    return kFailed;
  }
}

int run(int argc, char** argv, const std::function<void(CLI::App&, CommandContext&)>& addCommands) {
  if (const std::string state = stateDirectory(); !state.empty())
    leaveCrashTraces("vantage-cli", std::filesystem::path(state) / "crashes");
  const StopSignals signals;
  CommandContext context(signals.token(), {argv + 1, argv + argc});
  CLI::App app{"Vantage: a scanning workstation that decides where to scan next", "vantage-cli"};
  app.set_version_flag("--version", [] { return versionText("vantage-cli"); });
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 the work failed; 2 wrong use; 3 cancelled, sessions can be resumed; 4 done, but not all "
      "is\n"
      "well: scans were rejected or are doubtful, nothing or little is covered, or the acquisition ended for another\n"
      "reason than that it is finished (--json lists them under \"warnings\")");
  addCommands(app, context);
  return carryOut(app, context, argc, argv);
}

}  // namespace

int runCommandLine(int argc, char** argv, const std::function<void(CLI::App&, CommandContext&)>& addCommands) {
#ifdef __GLIBC__
  // Grids, meshes and models go back to the system when they are freed: kept for later they fit nothing.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
  try {
    return run(argc, argv, addCommands);
  } catch (...) {
    std::fputs("vantage-cli: what went wrong could not be said\n", stderr);
    return kFailed;
  }
}

}  // namespace vantage
