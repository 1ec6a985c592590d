#include "session/stored_history.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>
#include <utility>

#include "base/errors.h"
#include "session/command_json.h"
#include "session/loss_list.h"
#include "session/session_blobs.h"
#include "session/session_json.h"
#include "session/session_schema.h"

namespace vantage {
namespace {

struct StepRow {
  std::int64_t parent = 0;
  std::int64_t views = 0;
  HistoryEntry entry;
};

// Nothing of a step that came from an earlier version: its state was hashed in another way.
std::optional<std::uint64_t> hashFrom(const std::string& text) {
  if (text.empty()) return std::nullopt;
  std::uint64_t hash = 0;
  std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  return hash;
}

// Numbers in a file may be anything.
int bounded(std::int64_t number) {
  return static_cast<int>(std::clamp<std::int64_t>(number, -1, 1'000'000));
}

// Reads the tables step, record and view, skipping what is damaged.
class HistoryReader {
 public:
  explicit HistoryReader(Database& database) : database_(database) {}

  StoredHistory read(std::int64_t tip, std::int64_t cursor) {
    first_ = firstStepRead(database_);
    if (first_) lose({LossKind::StepsUnread, *first_, {}, {}});
    readSteps();
    followPath(tip);
    readRecords();
    readViews();
    for (const std::int64_t step : path_) take(step);
    for (std::size_t i = 0; i < result_.entries.size(); ++i)
      if (result_.entries[i].step <= cursor) result_.cursor = i;
    result_.losses = losses_.all();
    return std::move(result_);
  }

 private:
  // Runs `row` for every row of a table; what is damaged becomes a loss, with the query's first column as its number.
  // Its last one says whether the row is as it was written: one that is not is named, and taken as far as it goes.
  template <typename Row>
  void forEach(const std::string& table, const std::string& query, const Row& row) {
    try {
      Statement rows = database_.prepare(query);
      while (rows.step()) {
        try {
          const std::string what = database_.path() + ": " + table + " " + rows.text(0);
          if (rows.integer(rows.columns() - 1) == 0)
            lose({LossKind::RowDamaged, rows.integer(0), table, what + " is damaged: it is not as it was written"});
          row(rows, what);
        } catch (const InvalidInput& e) {
          lose({LossKind::RowDamaged, rows.integer(0), table, e.what()});
        }
      }
    } catch (const IoError& e) {
      lose({LossKind::RowsUnread, {}, table, e.what()});
    }
  }

  void lose(Loss loss) { losses_.add(std::move(loss)); }

  // The first row of the table view that is read. Steps are written one after the other, and their views with them.
  std::int64_t firstView() {
    if (!first_) return 0;
    std::int64_t view = std::numeric_limits<std::int64_t>::max();
    Statement rows = database_.prepare("SELECT id, step FROM view ORDER BY id DESC");
    while (rows.step() && rows.integer(1) >= *first_) view = rows.integer(0);
    return view;
  }

  void readSteps() {
    forEach(
        "step",
        "SELECT id, parent, kind, command, settings, mode, stands, chosen, termination, views, model, plan, hash, " +
            intact("step") +
            " FROM step WHERE id >= " + std::to_string(first_.value_or(std::numeric_limits<std::int64_t>::min())),
        [&](const Statement& row, const std::string& what) {
          auto outline = std::make_shared<StateOutline>();
          outline->settings =
              parsed(settings_, row.text(4), [&](const std::string& text) { return settingsFromText(text, what); });
          outline->mode = modeFromName(row.text(5), what);
          outline->stands =
              parsed(stands_, row.text(6), [&](const std::string& text) { return standsFromText(text, what); });
          outline->aside =
              parsed(aside_, row.text(6), [&](const std::string& text) { return asideFromText(text, what); });
          if (const auto chosen = row.optionalInteger(7)) outline->chosenPosition = bounded(*chosen);
          outline->termination = terminationFromName(row.text(8), what);
          outline->modelStep = row.integer(10);
          outline->planStep = row.integer(11);
          StepRow step{row.integer(1), row.integer(9), {}};
          step.entry.step = row.integer(0);
          step.entry.command = commandFromText(row.text(2), row.text(3), what);
          step.entry.hash = hashFrom(row.text(12));
          outlines_[step.entry.step] = std::move(outline);
          steps_[step.entry.step] = std::move(step);
        });
  }

  // Most steps have the settings and stands of the one before.
  template <typename Value>
  struct Parsed {
    std::string text;
    Value value{};
  };
  template <typename Value, typename Parser>
  static const Value& parsed(Parsed<Value>& before, std::string text, const Parser& parse) {
    if (text != before.text) {
      before.value = parse(text);
      before.text = std::move(text);
    }
    return before.value;
  }

  // The steps from the first to the tip. Where a step is lost, those before it are found by their numbers.
  void followPath(std::int64_t tip) {
    auto at = steps_.find(tip);
    if (at == steps_.end() && !steps_.empty()) {
      at = std::prev(steps_.end());
      lose({LossKind::LastStepLost, tip, {}, {}});
    }
    while (at != steps_.end()) {
      path_.push_back(at->first);
      const std::int64_t parent = at->second.parent;
      if (at == steps_.begin() || parent == 0) break;
      if (!steps_.contains(parent)) lose({LossKind::StepLost, parent, {}, {}});
      const auto behind = steps_.upper_bound(std::min(parent, at->first - 1));
      at = behind == steps_.begin() ? steps_.end() : std::prev(behind);
    }
    std::reverse(path_.begin(), path_.end());
    onPath_.insert(path_.begin(), path_.end());
  }

  void readRecords() {
    forEach("record", "SELECT id, step, scan, data, " + intact("record") + " FROM record",
            [&](const Statement& row, const std::string& what) {
              records_[{row.integer(1), row.integer(2)}] =
                  std::make_shared<const ScanRecord>(recordFromText(row.text(3), what));
            });
  }

  void readViews() {
    forEach("view",
            "SELECT v.id, v.step, v.scan, v.status, v.pose, v.record, v.plan, s.stand, s.position, " +
                intact("view", "v") + " FROM view v LEFT JOIN scan s ON s.id = v.scan WHERE v.id >= " +
                std::to_string(firstView()) + " ORDER BY v.step, v.place, v.id",
            [&](const Statement& row, const std::string& what) {
              const std::int64_t step = row.integer(1);
              if (!onPath_.contains(step)) return;
              OutlinedScan scan;
              scan.scan = row.integer(2);
              scan.status = scanStatusFromName(row.text(3), what);
              scan.T_object_scanner = poseFromBlob(row.blob(4), what);
              scan.recordStep = row.integer(5);
              scan.planStep = row.integer(6);
              scan.station = stationOf(row, 7);
              const auto record = records_.find({scan.recordStep, scan.scan});
              if (record == records_.end()) throw InvalidInput(what + " is damaged: it has no record");
              scan.record = record->second;
              outlines_[step]->scans.push_back(std::move(scan));
              ++counts_[step];
            });
  }

  void take(std::int64_t step) {
    StepRow& row = steps_[step];
    if (counts_[step] != row.views) {
      lose({LossKind::StepIncomplete, step, {}, {}});
      return;
    }
    row.entry.outline = outlines_[step];
    result_.entries.push_back(std::move(row.entry));
  }

  Database& database_;
  std::optional<std::int64_t> first_;
  LossList losses_;
  StoredHistory result_;
  std::map<std::int64_t, StepRow> steps_;
  std::map<std::int64_t, std::shared_ptr<StateOutline>> outlines_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::shared_ptr<const ScanRecord>> records_;
  std::map<std::int64_t, std::int64_t> counts_;
  Parsed<AcquisitionSettings> settings_;
  Parsed<std::vector<Stand>> stands_;
  Parsed<std::vector<OutlinedModel>> aside_;
  std::vector<std::int64_t> path_;
  std::set<std::int64_t> onPath_;
};

}  // namespace

std::optional<std::int64_t> firstStepRead(Database& database) {
  Statement last = database.prepare("SELECT id FROM step ORDER BY id DESC LIMIT 1 OFFSET ?");
  if (!last.bind(1, kMostSteps - 1).step()) return std::nullopt;
  const std::int64_t first = last.integer(0);
  Statement before = database.prepare("SELECT 1 FROM step WHERE id < ? LIMIT 1");
  if (!before.bind(1, first).step()) return std::nullopt;
  return first;
}

StoredHistory readHistory(Database& database, std::int64_t tip, std::int64_t cursor) {
  return HistoryReader(database).read(tip, cursor);
}

Station stationOf(const Statement& row, int column) {
  Station station{bounded(row.integer(column)), {}};
  if (const auto position = row.optionalInteger(column + 1)) station.position = bounded(*position);
  return station;
}

}  // namespace vantage
