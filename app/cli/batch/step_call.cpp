#include "cli/batch/step_call.h"

#include <filesystem>

#include "base/errors.h"
#include "session/import_note.h"
#include "session/session.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// The options with which an acquisition goes on.
bool isOfResume(const std::string& argument) {
  for (const char* option : {"--sensor=", "--table=", "--rig=", "--scanner=", "--calibration=", "--unit=", "--frame=",
                             "--up=", "--no-sample=", "--grid="})
    if (argument.starts_with(option)) return true;
  return false;
}

// A simulated acquisition goes on with what its session names.
std::vector<std::string> deviceArguments(const std::vector<std::string>& all) {
  bool real = false;
  std::vector<std::string> arguments;
  for (const std::string& argument : all) {
    if (!isOfResume(argument)) continue;
    real = real || (argument.starts_with("--sensor=") && argument != "--sensor=simulated") ||
           argument.starts_with("--rig=");
    arguments.push_back(argument);
  }
  return real ? arguments : std::vector<std::string>{};
}

enum class ImportState { CarriedOut, Interrupted, Incomplete };

ImportState importStateOf(const std::string& file, const Progress& progress) {
  const Session session = Session::open(file, SessionAccess::Read, progress);
  try {
    return interruptedImport(session) ? ImportState::Interrupted : ImportState::CarriedOut;
  } catch (const InvalidInput&) {
    return ImportState::Incomplete;
  }
}

using Arguments = std::vector<std::string>;

Arguments joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Arguments acquisition(const BatchStep& step, const StepPlace& place) {
  if (fs::exists(place.session)) return joined({"resume", place.session}, deviceArguments(step.arguments));
  return joined({"acquire", "--out", place.folder}, step.arguments);
}

Arguments import(const BatchStep& step, const StepPlace& place, const Progress& progress) {
  const Arguments anew = joined({"import", "--session", place.session}, step.arguments);
  if (!fs::exists(place.session)) return anew;
  switch (importStateOf(place.session, progress)) {
    case ImportState::CarriedOut:
      return {"info", place.session};
    case ImportState::Interrupted:
      return {"resume", place.session};
    case ImportState::Incomplete:
      break;
  }
  return joined({"import", "--replace", "--session", place.session}, step.arguments);
}

}  // namespace

Arguments callOf(const BatchStep& step, const StepPlace& place, const Progress& progress) {
  Arguments arguments;
  if (step.command == "acquire") {
    arguments = acquisition(step, place);
  } else if (step.command == "import") {
    arguments = import(step, place, progress);
  } else {
    arguments = {step.command, place.session, "--out", (fs::path(place.folder) / step.arguments.front()).string()};
  }
  // Behind the command and before what may be names of files only.
  return joined({place.program, arguments.front(), "--json", "--threads", std::to_string(place.threads)},
                {arguments.begin() + 1, arguments.end()});
}

}  // namespace vantage
