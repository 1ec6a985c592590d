// Plans whole acquisitions and measures the planner by the truth: coverage as a share of what noise-free scans from all
// positions sample (of ceiling), views against a greedy planner that knows the object, how well the forecast ranks
// positions in views 2 to 5 and later (Spearman), achieved over predicted area, views that showed next to nothing, and
// whether "finished" was true: what the position that would really show most brings when it is forced, against F.
//
//   benchmark_planner [--scanner P.json] [--seeds 1,2] [--points N] [--size MM] [--variant NAME:key=value,...]...
//   [--rivals] OBJECT...
//
// A variant is a set of options (vantage-cli options); strategy=uniform:N is one, too. With --rivals every run is
// followed by evenly spaced and random views of the same number. Without objects: the sample objects.
//
// Halves, named before anything was tuned: the defaults were tuned on the mug and the candle holder, the handset was
// held out.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "acquisition/setting_lookup.h"
#include "acquisition/steps.h"
#include "geometry/measures.h"
#include "io/mesh_reader.h"
#include "io/placement.h"
#include "planner/object_truth.h"
#include "planning/choice.h"
#include "report/evaluation.h"
#include "scanner/simulated_sensor.h"

namespace vantage {
namespace {

struct Variant {
  std::string name;
  std::vector<std::string> settings;  // "key=value"
};

struct Arguments {
  std::string scanner = VANTAGE_RESOURCES "/scanners/rotating_stripe.json";
  std::vector<std::uint64_t> seeds{1};
  int points = 12000;
  double size = 0.0;  // [mm] of the longest side; 0: objects are as they are
  bool rivals = false;
  std::vector<Variant> variants;
  std::vector<std::string> objects;
};

// What one run came to.
struct Run {
  int views = 0;
  double ofCeiling = 0.0;
  double overGreedy = 0.0;
  std::vector<double> ranksEarly, ranksLate;  // Spearman per plan
  std::vector<double> ratios;                 // achieved / predicted per view
  double leastView = 0.0;                     // [mm^2] the least that a view after the first showed
  double threshold = 0.0;                     // F [mm^2]
  double forced = 0.0;                        // [mm^2] what the best remaining position showed
  double falseSurface = 0.0;
  std::string ended;
};

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> ranksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t j = i;
    while (j < order.size() && values[order[j]] == values[order[i]]) ++j;
    for (std::size_t k = i; k < j; ++k) ranks[order[k]] = 0.5 * static_cast<double>(i + j - 1);
    i = j;
  }
  return ranks;
}

// Nothing where all are equal.
std::optional<double> spearman(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> x = ranksOf(a);
  const std::vector<double> y = ranksOf(b);
  const double mean = 0.5 * (static_cast<double>(a.size()) - 1.0);
  double xy = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  if (xx <= 0.0 || yy <= 0.0) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

// How well the plan ranks the positions that no view was taken from.
void judgeRanks(const AcquisitionState& state, const ObjectTruth& truth, Run& run) {
  if (!state.plan || !state.model) return;
  const std::vector<double> gains = truth.gains(truth.covered(state.model->mesh, Progress().withThreads(2)));
  const std::vector<int> taken = planInputOf(state).taken;
  std::vector<double> promised;
  std::vector<double> real;
  for (const PositionScore& score : state.plan->scores) {
    if (std::find(taken.begin(), taken.end(), score.position) != taken.end()) continue;
    promised.push_back(promise(score));
    real.push_back(gains[static_cast<std::size_t>(score.position)]);
  }
  const auto rank = spearman(promised, real);
  if (!rank) return;
  (countScans(state, ScanStatus::In) < 5 ? run.ranksEarly : run.ranksLate).push_back(*rank);
}

AcquisitionSettings settingsOf(const Variant& variant) {
  AcquisitionSettings settings;
  for (const std::string& text : variant.settings) {
    const std::size_t equals = text.find('=');
    const SettingField& field = settingField(text.substr(0, equals));
    setText(field, settings, text.substr(equals + 1));
  }
  return settings;
}

// Standing on the table about its axis, its longest side of a size; as it is without one.
Mesh placedMesh(const std::string& path, double size) {
  Mesh mesh = loadMesh(path, {}, {}).mesh;
  if (!(size > 0.0)) return mesh;
  const BoundingBox box = boundingBox(mesh);
  const Vec3 foot(box.centre().x(), box.centre().y(), box.min.z());
  return placed(std::move(mesh), {size / box.size().maxCoeff(), -size / box.size().maxCoeff() * foot});
}

class Experiment {
 public:
  Experiment(const std::string& object, const Arguments& plan)
      : profile_(std::make_shared<const ScannerProfile>(loadProfile(plan.scanner))),
        images_(std::make_shared<const ScannerImages>(computeScannerImages(*profile_, Progress().withThreads(2)))),
        object_(std::make_shared<const Mesh>(placedMesh(object, plan.size))),
        truth_(object_, profile_, plan.points, Progress().withThreads(2)) {}

  Run run(const AcquisitionSettings& settings, std::uint64_t seed) {
    Run run;
    SimulationOptions simulation;
    simulation.seed = seed;
    const Rig rig = opened(simulatedRig(object_, profile_, simulation));
    MemoryJournal journal(profile_, settings);
    const Progress progress = Progress().withThreads(2);
    Acquisition acquisition(journal, {rig, images_}, [&](const Command& command, const auto&, const auto& after) {
      if (std::holds_alternative<AddScan>(command)) judgeRanks(after, truth_, run);
    });
    acquisition.runUntilTheEnd(progress);
    const AcquisitionState state = *journal.state();
    run.ended = name(state.termination);
    judge(state, run);
    if (state.plan) force(acquisition, run);
    return run;
  }

  [[nodiscard]] const ObjectTruth& truth() const { return truth_; }

 private:
  void judge(const AcquisitionState& state, Run& run) const {
    const auto views = scansOf(state, ScanStatus::In);
    const double coverage = truth_.coverage(truth_.covered(state.model->mesh, Progress().withThreads(2)));
    run.views = static_cast<int>(views.size());
    run.ofCeiling = coverage / truth_.ceiling();
    run.overGreedy = static_cast<double>(run.views) / truth_.greedyViews(coverage, state.settings.firstView);
    run.leastView = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < views.size(); ++i) {
      const ScanRecord& record = views[i]->record;
      run.leastView = std::min(run.leastView, record.newArea);
      if (record.predicted && promise(*record.predicted) > 0.0)
        run.ratios.push_back(record.newArea / promise(*record.predicted));
    }
    EvaluationOptions options;
    options.samples = 4000;
    run.falseSurface =
        evaluate(state.model->mesh, *object_, *profile_, options, Progress().withThreads(2)).falseSurface;
    if (state.plan) run.threshold = state.plan->terminationThreshold;
  }

  // Scans from where most is really left.
  void force(Acquisition& acquisition, Run& run) const {
    const auto state = acquisition.state();
    const std::vector<double> gains = truth_.gains(truth_.covered(state->model->mesh, Progress().withThreads(2)));
    const auto best = std::max_element(gains.begin(), gains.end()) - gains.begin();
    acquisition.carryOut(ChoosePosition{static_cast<int>(best)}, Progress().withThreads(2));
    acquisition.scanNext(Progress().withThreads(2));
    run.forced = acquisition.state()->scans.back().record.newArea;
  }

  std::shared_ptr<const ScannerProfile> profile_;
  std::shared_ptr<const ScannerImages> images_;
  std::shared_ptr<const Mesh> object_;
  ObjectTruth truth_;
};

void printRow(const std::string& object, const std::string& variant, std::uint64_t seed, const Run& run) {
  std::printf("%-14.14s %-16.16s %2llu %3d %8.4f %7.2f %6.2f %6.2f %7.2f %7.0f %5.0f %7.0f %7.4f  %s\n", object.c_str(),
              variant.c_str(), static_cast<unsigned long long>(seed), run.views, run.ofCeiling, run.overGreedy,
              median(run.ranksEarly), median(run.ranksLate), median(run.ratios), run.leastView, run.threshold,
              run.forced, 100.0 * run.falseSurface, run.ended.c_str());
  std::fflush(stdout);
}

void printSummary(const std::string& variant, const std::vector<Run>& runs) {
  std::vector<double> shares, greedy, early, late, ratios;
  int views = 0;
  int falseDone = 0;
  for (const Run& run : runs) {
    shares.push_back(run.ofCeiling);
    greedy.push_back(run.overGreedy);
    early.insert(early.end(), run.ranksEarly.begin(), run.ranksEarly.end());
    late.insert(late.end(), run.ranksLate.begin(), run.ranksLate.end());
    ratios.insert(ratios.end(), run.ratios.begin(), run.ratios.end());
    views += run.views;
    falseDone += run.threshold > 0.0 && run.forced > 2.0 * run.threshold ? 1 : 0;
  }
  std::printf(
      "%-16.16s %zu runs, %d views: of ceiling median %.4f worst %.4f, views/greedy median %.2f worst %.2f, rank early "
      "%.2f late %.2f, achieved/predicted %.2f, false done %d\n",
      variant.c_str(), runs.size(), views, median(shares), *std::min_element(shares.begin(), shares.end()),
      median(greedy), *std::max_element(greedy.begin(), greedy.end()), median(early), median(late), median(ratios),
      falseDone);
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

Arguments planFrom(int argc, char** argv) {
  Arguments plan;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const auto value = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (option == "--scanner") {
      plan.scanner = value();
    } else if (option == "--seeds") {
      plan.seeds.clear();
      for (const std::string& seed : split(value(), ',')) plan.seeds.push_back(std::stoull(seed));
    } else if (option == "--points") {
      plan.points = std::stoi(value());
    } else if (option == "--size") {
      plan.size = std::stod(value());
    } else if (option == "--rivals") {
      plan.rivals = true;
    } else if (option == "--variant") {
      const std::string text = value();
      const std::size_t colon = text.find(':');
      plan.variants.push_back({text.substr(0, colon), split(text.substr(colon + 1), ',')});
    } else {
      plan.objects.push_back(option);
    }
  }
  if (plan.variants.empty()) plan.variants.push_back({"default", {}});
  if (plan.objects.empty())
    for (const char* name : {"mug", "candle_holder", "handset"})
      plan.objects.push_back(std::string(VANTAGE_RESOURCES "/objects/") + name + ".ply");
  return plan;
}

void run(const Arguments& plan) {
  std::printf("%-14s %-16s %2s %3s %8s %7s %6s %6s %7s %7s %5s %7s %7s\n", "object", "variant", "sd", "n", "ofceil",
              "/greedy", "early", "late", "ach/pre", "least", "F", "forced", "false%");
  std::map<std::string, std::vector<Run>> all;
  for (const std::string& path : plan.objects) {
    Experiment experiment(path, plan);
    const std::string object = std::filesystem::path(path).stem().string();
    for (const std::uint64_t seed : plan.seeds)
      for (const Variant& variant : plan.variants) {
        const auto tell = [&](const std::string& name, const AcquisitionSettings& settings) {
          Run result = experiment.run(settings, seed);
          printRow(object, name, seed, result);
          all[name].push_back(result);
          return result.views;
        };
        AcquisitionSettings settings = settingsOf(variant);
        const int views = tell(variant.name, settings);
        if (!plan.rivals) continue;
        settings.strategy = parseStrategy("uniform:" + std::to_string(views));
        tell(variant.name + "=uniform", settings);
        settings.strategy = parseStrategy("random");
        settings.maxViews = views;
        settings.simulation.seed = seed;
        tell(variant.name + "=random", settings);
      }
  }
  for (const auto& [variant, runs] : all) printSummary(variant, runs);
}

}  // namespace
}  // namespace vantage

int main(int argc, char** argv) {
  try {
    vantage::run(vantage::planFrom(argc, argv));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
