#include "cli/device_run.h"

#include "cli/person_at_table.h"
#include "cli/session_run.h"
#include "session/table_note.h"

namespace vantage {

namespace {

// What a run goes by from stand to stand is remembered for who resumes it.
constexpr const char* kCourseNote = "stands";

std::optional<StandCourse> courseOf(Session& session, const DeviceRun& with) {
  if (with.course) session.setNote(kCourseNote, name(*with.course));
  const std::string text = session.note(kCourseNote);
  if (text.empty() || !with.object) return std::nullopt;
  return parseStandCourse(text);
}

}  // namespace

void runDevices(Session& session, const DeviceRun& with, const std::string& out, CommandContext& context) {
  const SimulationSettings& simulation = session.state()->settings.simulation;
  const TableLeft table = tableLeft(session).value_or(TableLeft{});
  const bool byHand = std::holds_alternative<HandTableDevice>(with.rig.table);
  PersonAtTable person(session.profile(), table.stand, with.events, context);
  HandTable::AskPerson ask;
  if (byHand) ask = [&](int position, const Progress& progress) { person.ask(position, progress); };
  DeviceSetUp devices = RealDevices{with.rig, session.profile(), ask, with.reading, table.stand};
  if (with.object) devices = Simulated{with.object, session.profile(), {simulation.seed, simulation.ideal}, ask};
  if (table.underWayTo && std::holds_alternative<SerialTableDevice>(with.rig.table))
    context.note("the table was left in a move from position " + std::to_string(table.stand.position) +
                 " to position " + std::to_string(*table.underWayTo) +
                 ", so it is taken to stand at the first; where it really stands, the next scan that fits will tell");
  const std::optional<StandCourse> course = with.positions.empty() ? courseOf(session, with) : std::nullopt;
  SessionRun(session, out, context, course, with.positions).run(devices, byHand || with.events ? &person : nullptr);
}

}  // namespace vantage
