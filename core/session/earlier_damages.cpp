#include "session/earlier_damages.h"

#include <array>
#include <charconv>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/errors.h"
#include "geometry/geometry_hash.h"
#include "session/json_fields.h"
#include "session/session_blobs.h"
#include "session/session_json.h"
#include "session/session_store.h"

namespace vantage {
namespace {

using Json = nlohmann::json;

// The ways in which an acquisition could end, in the order of that time.
constexpr std::array<std::string_view, 6> kEnds{
    "running", "finished", "no_overlap", "max_views", "registration_failed", "cancelled"};

std::string textIn(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

// From here on everything is as it was hashed at that time. It never changes, whatever becomes of state_hash.cpp.

// What a position score fixed worst was a sentence.
void addScore(ContentHash& hash, const PositionScore& score, const std::string& worst) {
  hash.add(score.position);
  hash.add(score.voidArea);
  hash.add(score.overlapArea);
  hash.add(score.tracedVoidArea.value_or(-1.0));
  hash.add(score.poseSigma.value_or(-1.0));
  hash.add(worst);
  hash.add(score.constraint);
  hash.add(score.shortBy);
  hash.add(score.patches);
}

// A plan with the sentences of its scores.
struct EarlierPlan {
  Plan plan;
  std::vector<std::string> worst;
};

void addPlan(ContentHash& hash, const EarlierPlan& earlier) {
  const Plan& plan = earlier.plan;
  hash.add(plan.outcome);
  hash.add(plan.position.value_or(-1));
  hash.add(plan.leastOverlap);
  hash.add(plan.terminationThreshold);
  hash.add(plan.voidLeft);
  hash.add(plan.relaxations);
  hash.add(plan.angularError);
  for (std::size_t i = 0; i < plan.scores.size(); ++i) addScore(hash, plan.scores[i], earlier.worst[i]);
}

void addPatches(ContentHash& hash, const Plan& plan) {
  for (const VoidPatch& p : plan.voids->patches) {
    hash.add(p.triangle);
    addPoint(hash, p.centre);
    hash.add(p.angle);
    hash.add(p.weight);
    hash.add(p.edgeClass);
  }
  for (const PatchOutlook& o : plan.outlook) {
    hash.add(o.looks);
    hash.add(o.answered);
    hash.add(o.reason);
    hash.add(o.promise);
  }
}

void addModel(ContentHash& hash, const Model& model) {
  hash.add(contentHash(model.mesh));
  hash.add(model.confidence);
  hash.add(model.vertexView);
  hash.add(model.vertexSample);
  hash.add(model.triangleView);
}

void addSettings(ContentHash& hash, const Json& settings) {
  hash.add(textIn(settings, "object"));
  hash.add(textIn(settings, "placement"));
  hash.add(settings.at("seed").get<std::uint64_t>());
  hash.add(settings.at("ideal").get<bool>());
  hash.add(settings.at("first_view").get<int>());
  hash.add(settings.at("max_views").get<int>());
  hash.add(settings.at("tolerance").get<double>());
  hash.add(textIn(settings, "strategy"));
}

// Hashes of states as version 2 made them, from its rows.
class Version2 {
 public:
  explicit Version2(Database& database) : database_(database) {}

  std::vector<Loss> changedSteps() {
    std::vector<Loss> losses;
    readStart();
    // Models may be gone, as they can be made again.
    Statement steps = database_.prepare(
        "SELECT id, settings, chosen, termination, model, hash FROM step WHERE hash <> '' AND (model = 0 OR model IN "
        "(SELECT step FROM model)) ORDER BY id");
    while (steps.step())
      if (steps.integer(0) != startStep_ && !fits(steps))
        losses.push_back({LossKind::StateUntrue, steps.integer(0), {}, {}});
    return losses;
  }

 private:
  bool fits(const Statement& step) {
    try {
      return hashText(hashOf(step)) == step.text(5);
    } catch (const InvalidInput&) {
      return false;
    } catch (const Json::exception&) {
      return false;
    }
  }

  // The first step holds settings and nothing else: its hash tells what they were hashed as. Their text may be another
  // by now: the path of an object means nothing on another machine.
  void readStart() {
    Statement step = database_.prepare(
        "SELECT id, settings, hash FROM step WHERE parent = 0 AND kind = 'change_settings' AND chosen = -1 AND "
        "termination = 'running' AND model = 0 AND hash <> '' AND id NOT IN (SELECT step FROM view)");
    if (!step.step()) return;
    startStep_ = step.integer(0);
    startSettings_ = step.text(1);
    const std::string text = step.text(2);
    std::uint64_t hash = 0;
    std::from_chars(text.data(), text.data() + text.size(), hash, 16);
    const auto running = endOf("running");
    const int unchosen = -1;
    const ContentHash chosen = ContentHash::before(hash, std::as_bytes(std::span(&running, 1)));
    afterSettings_ = ContentHash::before(chosen.value(), std::as_bytes(std::span(&unchosen, 1)));
  }

  std::uint64_t hashOf(const Statement& step) {
    ContentHash hash = afterSettings_;
    if (step.text(1) != startSettings_) {
      hash = {};
      addSettings(hash, jsonObject(step.text(1), what_));
    }
    const std::int64_t id = step.integer(0);
    std::int64_t lastPlan = addViews(hash, id, "in");
    addViews(hash, id, "left out");
    addRejected(hash, id);
    if (lastPlan != 0) addPatches(hash, plan(lastPlan).plan);
    if (const std::int64_t model = step.integer(4); model != 0) addModel(hash, this->model(model));
    hash.add(static_cast<int>(step.integer(2)));
    hash.add(endOf(step.text(3)));
    return hash.value();
  }

  std::uint8_t endOf(const std::string& termination) const {
    for (std::size_t i = 0; i < kEnds.size(); ++i)
      if (kEnds[i] == termination) return static_cast<std::uint8_t>(i);
    throw InvalidInput(what_ + " is damaged: its end is not known");
  }

  // @return the step of the last view's plan; 0 without one
  std::int64_t addViews(ContentHash& hash, std::int64_t step, const char* status) {
    std::int64_t last = 0;
    Statement rows = viewsOf(step, status);
    while (rows.step()) {
      hash.add(rows.integer(0));
      addPose(hash, poseFromBlob(rows.blob(1), what_));
      addScan(hash, rows.integer(0));
      const Json json = recordOf(rows.integer(2), rows.integer(0));
      addRecord(hash, json);
      last = rows.integer(3);
      hash.add(last != 0);
      if (last != 0) addPlan(hash, plan(last));
    }
    return last;
  }

  void addRejected(ContentHash& hash, std::int64_t step) {
    Statement rows = viewsOf(step, "rejected");
    while (rows.step()) {
      hash.add(rows.integer(0));
      addScan(hash, rows.integer(0));
      addRegistration(hash, recordOf(rows.integer(2), rows.integer(0)));
    }
  }

  Statement viewsOf(std::int64_t step, const char* status) {
    Statement rows =
        database_.prepare("SELECT scan, pose, record, plan FROM view WHERE step = ? AND status = ? ORDER BY place, id");
    rows.bind(1, step).bind(2, std::string_view(status));
    return rows;
  }

  Json recordOf(std::int64_t step, std::int64_t scan) {
    Statement row = database_.prepare("SELECT data FROM record WHERE step = ? AND scan = ?");
    if (!row.bind(1, step).bind(2, scan).step()) throw InvalidInput(what_ + " is damaged: a record is missing");
    return jsonObject(row.text(0), what_);
  }

  void addRegistration(ContentHash& hash, const Json& record) const {
    const RegistrationResult r = recordFromText(record.dump(), what_).registration;
    addPose(hash, r.T_object_scanner);
    hash.add(static_cast<int>(r.verdict));
    hash.add(textIn(record.at("registration"), "reason"));
    hash.add(r.rms);
    hash.add(r.inlierShare);
    hash.add(static_cast<std::uint64_t>(r.pairs));
    hash.add(r.iterations);
  }

  void addRecord(ContentHash& hash, const Json& json) const {
    addRegistration(hash, json);
    const ScanRecord record = recordFromText(json.dump(), what_);
    hash.add(record.newArea);
    hash.add(record.overlapArea);
    hash.add(record.predicted.has_value());
    if (record.predicted) addScore(hash, *record.predicted, textIn(json.at("predicted"), "worst_direction"));
  }

  void addScan(ContentHash& hash, std::int64_t number) {
    Statement row = database_.prepare(
        "SELECT s.position, s.nominal, s.range, s.rays, r.rows * r.columns FROM scan s LEFT JOIN rays r ON r.id = "
        "s.rays "
        "WHERE s.id = ?");
    if (!row.bind(1, number).step()) throw InvalidInput(what_ + " is damaged: a scan is missing");
    hash.add(static_cast<int>(row.integer(0)));
    addPose(hash, poseFromBlob(row.blob(1), what_));
    const auto rays = row.optionalInteger(3) ? static_cast<std::size_t>(row.integer(4)) : profileRays();
    hash.add(rangeFromBlob(row.blob(2), rays, what_));
  }

  std::size_t profileRays() {
    if (!profileRays_) {
      const auto source = profileSourceIn(database_);
      profileRays_ = source ? parseProfile(*source).rays->size() : 0;
    }
    return *profileRays_;
  }

  const EarlierPlan& plan(std::int64_t step) {
    if (const auto known = plans_.find(step); known != plans_.end()) return known->second;
    Statement row = database_.prepare("SELECT summary, data FROM plan WHERE step = ?");
    if (!row.bind(1, step).step()) throw InvalidInput(what_ + " is damaged: a plan is missing");
    EarlierPlan plan{planFromText(row.text(0), what_), {}};
    const Json summary = jsonObject(row.text(0), what_);
    for (const Json& score : summary.at("scores")) plan.worst.push_back(textIn(score, "worst_direction"));
    addFromPlanBlob(plan.plan, row.blob(1), what_);
    return plans_.emplace(step, std::move(plan)).first->second;
  }

  const Model& model(std::int64_t step) {
    if (step == modelStep_) return model_;
    Statement row = database_.prepare("SELECT data FROM model WHERE step = ?");
    if (!row.bind(1, step).step()) throw InvalidInput(what_ + " is damaged: a model is missing");
    model_ = modelFromBlob(row.blob(0), what_);
    modelStep_ = step;
    return model_;
  }

  Database& database_;
  const std::string what_ = database_.path() + ": a step";
  std::map<std::int64_t, EarlierPlan> plans_;
  std::int64_t startStep_ = 0;
  std::string startSettings_;
  ContentHash afterSettings_;  ///< what startSettings_ were hashed to
  std::optional<std::size_t> profileRays_;
  std::int64_t modelStep_ = 0;
  Model model_;
};

}  // namespace

std::vector<Loss> earlierDamages(Database& database, int version) {
  return version == 2 ? Version2(database).changedSteps() : std::vector<Loss>();
}

}  // namespace vantage
