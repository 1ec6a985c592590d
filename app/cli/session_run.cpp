#include "cli/session_run.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "acquisition/acquisition.h"
#include "acquisition/hand_placing.h"
#include "acquisition/other_turn.h"
#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "cli/text.h"
#include "devices/standing_object.h"
#include "planning/choice.h"
#include "positional_space/scanner_images_cache.h"
#include "program/user_folders.h"
#include "program/version.h"
#include "report/memory_note.h"
#include "report/report.h"
#include "report/wording.h"
#include "scanner/profile_size.h"
#include "scanner/table_turn.h"
#include "session/table_note.h"

namespace vantage {
namespace {

// Triangles of a model that is written while somebody waits for the program to end.
constexpr std::size_t kWrittenAtOnce = 500'000;

bool hasViews(const AcquisitionState& state) {
  return lastView(state, state.stand()) != nullptr;
}

bool takesLong(const AcquisitionState& state) {
  return state.model && state.model->mesh.triangles.size() > kWrittenAtOnce;
}

std::string positionText(const KeptScan& scan) {
  return scan.station().position ? std::to_string(*scan.station().position) : "none";
}

std::string viewLine(const AcquisitionState& state, const KeptScan& scan) {
  const ScanRecord& record = scan.record;
  const std::size_t views = countScans(state, ScanStatus::In);
  std::string line = "view " + std::to_string(views) + " at position " + positionText(scan) + ": " +
                     std::to_string(record.samples) + " samples" +
                     (record.everyNth > 1 ? " (" + thinningText(record.everyNth) + " worked on)" : "") + ", +" +
                     number(record.newArea, 0) + " mm2, registration " + std::string(name(record.registration.verdict));
  if (views > 1) line += " (" + number(record.registration.rms, 3) + " mm)";
  if (record.planAfter && record.planAfter->outcome == PlanOutcome::Found)
    line += ", next " + std::to_string(record.planAfter->position.value()) + " for " +
            number(promise(record.planAfter->scores[static_cast<std::size_t>(record.planAfter->position.value())]), 0) +
            (record.planAfter->forecast ? " mm2 of new surface" : " mm2 of void");
  return line;
}

// "3 (90.0 deg)" where a table turns.
std::string placeText(const AcquisitionState& state, const KeptScan& scan) {
  const std::string position = positionText(scan);
  if (!scan.station().position || !state.profile || state.profile->workspace.steps == 0) return position;
  return position + " (" +
         number(degrees(turnBetween(state.profile->workspace, 0, *scan.station().position).angle), 1) + " deg)";
}

// What a person who turned too far is asked for.
std::string remedyText(const AcquisitionState& state, const KeptScan& scan) {
  if (scan.record.registration.finding.reason != VerdictReason::FewPairs || !turnedByGuess(*scan.view.image)) return {};
  const auto next = nextPosition(state);
  if (!next) return "; too little of it overlaps with what is known: turn less between scans";
  return "; too little of it overlaps with what is known: turn less, to position " + std::to_string(*next) + " (" +
         number(degrees(turnBetween(state.profile->workspace, 0, *next).angle), 1) + " deg)";
}

// Another position than the one that comes next and those that were skipped before: the one that promises most; of no
// plan the next. Without any the run ends here.
void chooseInstead(Acquisition& acquisition, std::set<int>& skipped, const Progress& progress) {
  const auto state = acquisition.state();
  const NextScan next = acquisition.next();
  if (const auto* from = std::get_if<ScanFrom>(&next)) skipped.insert(from->position);
  std::optional<int> best;
  if (state->plan) {
    for (const PositionScore& score : state->plan->scores) {
      if (skipped.contains(score.position) || score.constraint != Constraint::Outscored) continue;
      if (!best || promise(score) > promise(state->plan->scores[static_cast<std::size_t>(*best)]))
        best = score.position;
    }
  } else {
    for (int i = 0; i < static_cast<int>(state->profile->workspace.size()) && !best; ++i)
      if (!skipped.contains(i)) best = i;
  }
  if (best)
    acquisition.carryOut(ChoosePosition{*best}, progress);
  else
    acquisition.carryOut(Finish{Termination::EndedByOperator}, progress);
}

}  // namespace

std::string lastScanLine(const AcquisitionState& state) {
  const KeptScan& scan = state.scans.back();
  switch (scan.status) {
    case ScanStatus::Rejected:
      return "scan at position " + placeText(state, scan) +
             " was not integrated: registration failed: " + describe(scan.record.registration.finding) +
             remedyText(state, scan);
    case ScanStatus::Waiting:
      return "scan at position " + positionText(scan) + " waits until it is known how the object stands";
    default:
      return viewLine(state, scan);
  }
}

std::string standLine(const AcquisitionState& state, int stand) {
  const std::string which = "stand " + std::to_string(stand);
  const auto& alignment = state.stands[static_cast<std::size_t>(stand)].alignment;
  if (!alignment) return which + " is not aligned yet";
  return which + (alignment->used ? " aligned: " : " is not aligned, " + std::string(name(alignment->verdict)) + ": ") +
         describe(*alignment);
}

void changeSettings(Session& session, const AcquisitionSettings& settings, CommandContext& context) {
  if (settings == session.state()->settings) return;
  AcquisitionTools tools;
  if (const auto profile = session.profile())
    tools.images = std::make_shared<const ScannerImages>(loadScannerImages(
        *profile, cacheDirectory(), context.progress().part(0.0, 0.5, "positional space of the scanner")));
  Acquisition(session, tools).carryOut(ChangeSettings{settings}, context.progress().part(0.5, 1.0));
}

SessionRun::SessionRun(Session& session, std::string out, CommandContext& context, std::optional<StandCourse> course,
                       std::vector<int> positions)
    : session_(session),
      results_(std::move(out)),
      context_(context),
      course_(std::move(course)),
      positions_(std::move(positions)),
      last_(session.state()) {}

void SessionRun::run(const DeviceSetUp& devices, PersonAtTable* person) {
  try {
    acquireAll(devices, person);
  } catch (const InvalidInput& e) {
    const std::string& object = last_->settings.simulation.object;
    throw InvalidInput((object.empty() ? session_.path() : object) + ": " + e.what());
  } catch (const Cancelled&) {
    // The session itself stays where it was: it can be resumed.
    AcquisitionState cancelled = *last_;
    cancelled.termination = Termination::Cancelled;
    last_ = std::make_shared<const AcquisitionState>(std::move(cancelled));
    // Without a scan nothing is left, and the same command may come again.
    if (session_.scanCount() > 0) writeStopped();
    throw;
  }
  writeResults();
  announce();
}

void SessionRun::tellLast(PersonAtTable* person) {
  context_.note(lastScanLine(*last_));
  if (person == nullptr) return;
  const KeptScan& scan = last_->scans.back();
  nlohmann::ordered_json event{{"event", "registered"},
                               {"scan", scan.number},
                               {"verdict", name(scan.record.registration.verdict)},
                               {"new_area_mm2", scan.record.newArea}};
  if (scan.station().position) event["position"] = *scan.station().position;
  person->tell(event);
  if (scan.status != ScanStatus::Rejected) return;
  const std::vector<double> turns = turnsThatFit(*last_, scan);
  if (turns.size() == 1) person->offerTurn(scan.number, turns.front());
  person->tell({{"event", "problem"},
                {"code", name(scan.record.registration.finding.reason)},
                {"scan", scan.number},
                {"fits_at_deg", turns},
                {"text", lastScanLine(*last_)}});
}

// The scan that was refused last is taken as from where it fits.
void SessionRun::takeLast(Acquisition& acquisition, PersonAtTable& person) {
  const KeptScan& scan = last_->scans.back();
  const TakeAsFrom command{scan.number, turnsThatFit(*last_, scan).front()};
  try {
    acquisition.carryOut(command, context_.progress());
  } catch (const InvalidInput& e) {
    context_.note(e.what());
    person.tell({{"event", "problem"}, {"scan", command.scan}, {"text", e.what()}});
    return;
  }
  person.standsAt(command.tableDeg);
  tellLast(&person);
}

void SessionRun::acquireAll(const DeviceSetUp& devices, PersonAtTable* person) {
  if (last_->termination != Termination::Running && !course_ && positions_.empty()) return;
  const auto images = std::make_shared<const ScannerImages>(loadScannerImages(
      *session_.profile(), cacheDirectory(), context_.progress().part(0.0, 1.0, "positional space of the scanner")));
  do acquireStand(devices, images, person);
  while (course_ && turnOver(images));
  if (person != nullptr) person->tell({{"event", "done"}, {"terminated_by", name(last_->termination)}});
}

Acquisition::StepObserver SessionRun::observer(PersonAtTable* person) {
  return [this, person](const Command& command, const auto& /*before*/, const auto& /*after*/) {
    last_ = session_.state();
    if (std::holds_alternative<AddScan>(command)) tellLast(person);
    if (const auto* align = std::get_if<AlignStand>(&command)) context_.note(standLine(*last_, align->stand));
    if (const auto* reference = std::get_if<TakeReference>(&command))
      context_.note("the object is known by stand " + std::to_string(reference->stand) +
                    " from here on: it shows much more of it");
    if (const auto* chosen = std::get_if<ChooseStandPose>(&command)) context_.note(standLine(*last_, chosen->stand));
  };
}

// Acquires the stand of now to its end, and finds out how the object stands in it.
void SessionRun::acquireStand(const DeviceSetUp& devices, const SharedImages& images, PersonAtTable* person) {
  if (last_->termination != Termination::Running && !hasUntriedStand(*last_) && positions_.empty()) return;
  // Scans that were taken before have moved a simulated turntable, whatever became of them.
  Rig rig = DeviceFactory().open(withObjectAsItStands(devices, *last_), session_.scanCount(), context_.progress());
  if (std::holds_alternative<RealDevices>(devices)) rig = remarked(rig, session_);
  if (person != nullptr) rig = person->told(rig);
  if (const auto unused = session_.unusedScan(); unused && unused->image->station.stand == last_->stand())
    context_.note("scan " + std::to_string(unused->number) + " was not yet added: going on with it");
  Acquisition acquisition(session_, {rig, images}, observer(person));
  if (!positions_.empty()) return scanFromPositions(acquisition);
  std::set<int> skipped;
  bool goesOn = true;
  while (goesOn) {
    goesOn = goOn(acquisition, skipped, person);
    if (course_) static_cast<void>(findPlaces(acquisition, context_.progress()));
    goesOn = goesOn && last_->termination == Termination::Running;
  }
}

// Where the plan then says that nothing is left, the acquisition has ended; else the next run goes on.
void SessionRun::scanFromPositions(Acquisition& acquisition) {
  for (const int position : positions_) {
    acquisition.carryOut(ChoosePosition{position}, context_.progress());
    acquisition.scanNext(context_.progress());
  }
  if (last_->termination != Termination::Running) return;
  const NextScan next = acquisition.next();
  if (const auto* ended = std::get_if<Ended>(&next))
    acquisition.carryOut(Finish{ended->termination}, context_.progress());
}

// Scans until the end, or until a stand that is not known yet may find its place. @return whether the stand shows
// anything
bool SessionRun::goOn(Acquisition& acquisition, std::set<int>& skipped, PersonAtTable* person) {
  try {
    acquisition.runUntilTheEnd(context_.progress(), [&] { return course_ && mayFindItsPlace(*last_); });
  } catch (const PositionSkipped& e) {
    context_.note(e.what());
    chooseInstead(acquisition, skipped, context_.progress());
  } catch (const TakenAsFrom& e) {
    context_.note(e.what());
    takeLast(acquisition, *person);
  } catch (const EndedByPerson& e) {
    context_.note(e.what());
    acquisition.carryOut(Finish{Termination::EndedByOperator}, context_.progress());
  } catch (const InvalidInput& e) {
    // The scanner may see nothing of an object that lies flat.
    if (!course_ || last_->stand() == 0 || hasViews(*last_)) throw;
    context_.note("stand " + std::to_string(last_->stand()) + " shows nothing: " + e.what());
    return false;
  }
  return true;
}

// Puts the object on another side. @return whether that is worth while
bool SessionRun::turnOver(const SharedImages& images) {
  const auto advice = nextStand(*last_, *course_, context_.progress());
  if (!advice) return false;
  Acquisition(session_, {{}, images}, observer(nullptr)).carryOut(TurnObject{{}, advice->down}, context_.progress());
  context_.note("turned over: stand " + std::to_string(last_->stand()) + " is to show " + number(advice->gain, 0) +
                " mm2 of void, " + number(100.0 * advice->share, 0) + " % of what is left");
  return true;
}

void SessionRun::writeStopped() {
  if (!takesLong(*last_)) return writeResults();
  context_.note("the model has " + std::to_string(last_->model->mesh.triangles.size()) +
                " triangles and is in the session only: vantage-cli export and report write it from there");
}

void SessionRun::writeResults() {
  // Whatever stopped the run: what it came to is written, unless that takes long.
  const Progress progress = takesLong(*last_) ? context_.progress().part(0.0, 1.0, "writing the results")
                                              : Progress({}, {}, context_.progress().threads());
  progress.checkpoint(0.0);
  report_ = makeReport(*last_, programVersion());
  results_.write(withObject(*last_), report_, progress.part(0.3, 1.0));
}

void SessionRun::announce() {
  const auto& model = report_["model"];
  std::string text =
      std::to_string(report_["views"].size()) + " views, ended: " + std::string(name(last_->termination)) + "\n";
  text += "model: " + model["triangles"].dump() + " triangles, " + model["boundary_edges"].dump() +
          " boundary edges, " + number(model["area_mm2"].get<double>(), 0) + " mm2\n";
  for (const auto& r : report_["remaining"])
    text += "left: " + r["edges"].dump() + " edges (" + number(r["length_mm"].get<double>(), 0) + " mm) " +
            r["reason"].get<std::string>() + "\n";
  if (last_->stand() > 0)
    for (int stand = 0; stand <= last_->stand(); ++stand)
      if (stand != referenceOf(last_->stands)) text += standLine(*last_, stand) + "\n";
  text += "written: " + results_.file("model.ply") + ", " + results_.file("model.stl") + ", " +
          results_.file("report.json") + ", " + session_.path() + "\n";
  context_.result(report_, text, warningsOf(withObject(*last_)));
}

void tellMemoryNeeded(std::size_t rays, const AcquisitionSettings& settings, std::size_t scans,
                      CommandContext& context) {
  const auto note = memoryNote(rays, settings.thinning, scans);
  if (!note) return;
  const bool thinned = memoryFor(rays, settings.thinning).worked < rays;
  context.note(english(*note) + (thinned ? " (--set triangulation.spacing=0 works on all)" : ""));
}

}  // namespace vantage
