#include "cli/device_run.h"

#include "acquisition/acquisition.h"
#include "cli/person_at_table.h"
#include "cli/session_run.h"

namespace vantage {

void runDevices(Session& session, const DeviceRun& with, const std::string& out, CommandContext& context) {
  const SimulationSettings& simulation = session.state()->settings.simulation;
  const int standsAt = tablePosition(session).value_or(0);
  const bool byHand = std::holds_alternative<HandTableDevice>(with.rig.table);
  PersonAtTable person(session.profile(), standsAt, with.events, context);
  HandTable::AskPerson ask;
  if (byHand) ask = [&](int position, const Progress& progress) { person.ask(position, progress); };
  DeviceSetUp devices = RealDevices{with.rig, session.profile(), ask, with.reading, standsAt};
  if (with.object) devices = Simulated{with.object, session.profile(), {simulation.seed, simulation.ideal}, ask};
  SessionRun(session, out, context).run(devices, byHand || with.events ? &person : nullptr);
}

}  // namespace vantage
