#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "base/errors.h"
#include "cli/command.h"
#include "cli/stop_signals.h"

namespace {

// Exit codes of the command line contract.
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUse = 2;
constexpr int kCancelled = 3;
constexpr int kDoneBut = 4;

int run(int argc, char** argv) {
  const vantage::StopSignals signals;
  vantage::CommandContext context(signals.token());
  CLI::App app{"Vantage: a scanning workstation that decides where to scan next", "vantage-cli"};
  app.set_version_flag("--version", "vantage-cli " VANTAGE_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 the work failed; 2 wrong use; 3 cancelled, sessions can be resumed; 4 done, but not all "
      "is\n"
      "well: scans were rejected or are doubtful, nothing or little is covered, or the acquisition ended for another\n"
      "reason than that it is finished (--json lists them under \"warnings\")");
  vantage::addAcquireCommand(app, context);
  vantage::addResumeCommand(app, context);
  vantage::addImportCommand(app, context);
  vantage::addPlanCommand(app, context);
  vantage::addStepCommand(app, context);
  vantage::addTakeCommand(app, context);
  vantage::addExportCommand(app, context);
  vantage::addMeasureCommand(app, context);
  vantage::addInfoCommand(app, context);
  vantage::addEvaluateCommand(app, context);
  vantage::addRenderCommand(app, context);
  vantage::addReportCommand(app, context);
  vantage::addOptionsCommand(app, context);
  vantage::addDevicesCommand(app, context);
  vantage::addCalibrateCommand(app, context);
  vantage::addProfileCommand(app, context);
  vantage::addStandCommand(app, context);
  vantage::addAlignCommand(app, context);
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
  } catch (const vantage::Cancelled&) {
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

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // Grids, meshes and models go back to the system when they are freed: kept for later they fit nothing.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
  try {
    return run(argc, argv);
  } catch (...) {
    std::fputs("vantage-cli: what went wrong could not be said\n", stderr);
    return kFailed;
  }
}
