// The phases of a whole acquisition of the sample mug in the shape of Table 2 (Pito 1999), and the most memory it held.
// Arguments: another object and another scanner profile.

#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "acquisition/acquisition.h"
#include "acquisition/memory_journal.h"
#include "io/mesh_reader.h"
#include "report/report.h"
#include "scanner/simulated_sensor.h"

namespace vantage {
namespace {

void printRow(const std::string& label, const PhaseTimes& seconds) {
  std::printf("%-12s", label.c_str());
  double sum = 0.0;
  for (int phase = 0; phase < kPhases; ++phase) {
    const auto it = seconds.find(static_cast<Phase>(phase));
    const double time = it == seconds.end() ? 0.0 : it->second;
    sum += time;
    std::printf(" %12.3f", time);
  }
  std::printf(" %9.3f\n", sum);
}

void printTable(const AcquisitionState& state) {
  std::printf("%-12s", "seconds");
  for (int phase = 0; phase < kPhases; ++phase) std::printf(" %12s", name(static_cast<Phase>(phase)).data());
  std::printf(" %9s\n", "sum");
  PhaseTimes total;
  for (const KeptScan* scan : scansOf(state, ScanStatus::In)) {
    const ScanRecord& record = scan->record;
    for (const auto& [phase, time] : record.seconds) total[phase] += time;
    printRow("scan " + std::to_string(scan->number) + " at " + std::to_string(scan->station().position.value_or(-1)),
             record.seconds);
  }
  printRow("all", total);
}

void run(const std::string& object, const std::string& scanner) {
  const auto profile = std::make_shared<const ScannerProfile>(loadProfile(scanner));
  const auto images = std::make_shared<const ScannerImages>(computeScannerImages(*profile));
  const Rig rig = opened(simulatedRig(std::make_shared<const Mesh>(loadMesh(object, {}, {}).mesh), profile, {}));
  MemoryJournal journal(profile, {});
  Acquisition(journal, {rig, images}).runUntilTheEnd(Progress().withThreads(2));
  const AcquisitionState state = *journal.state();
  std::size_t scanned = 0;
  for (const KeptScan& scan : state.scans) scanned += scan.record.triangles;
  std::printf("%zu views of %zu triangles in all, a model of %zu triangles, %s; peak memory %.0f MB\n",
              countScans(state, ScanStatus::In), scanned, state.model->mesh.triangles.size(),
              name(state.termination).data(), peakMemory());
  printTable(state);
}

}  // namespace
}  // namespace vantage

int main(int argc, char** argv) {
  try {
    vantage::run(argc > 1 ? argv[1] : VANTAGE_RESOURCES "/objects/mug.ply",
                 argc > 2 ? argv[2] : VANTAGE_RESOURCES "/scanners/rotating_stripe.json");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
