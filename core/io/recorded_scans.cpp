#include "io/recorded_scans.h"

#include <algorithm>

#include "base/errors.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

bool anyPosition(const RecordedScans& recorded) {
  return std::any_of(recorded.positions.begin(), recorded.positions.end(),
                     [](const std::optional<int>& position) { return position.has_value(); });
}

void checkPositions(const RecordedScans& recorded, const ScannerProfile* profile) {
  if (profile == nullptr)
    throw InvalidInput("scans were taken from positions of a scanner's workspace: its profile is needed");
  if (!recorded.poses.empty())
    throw InvalidInput("positions and a list of poses both say where the scans were taken: give one");
  if (recorded.positions.size() != recorded.files.size())
    throw InvalidInput("there are " + std::to_string(recorded.positions.size()) + " positions for " +
                       std::to_string(recorded.files.size()) + " files, expected one for each");
  const auto count = static_cast<int>(profile->workspace.size());
  for (std::size_t i = 0; i < recorded.files.size(); ++i) {
    const std::optional<int>& position = recorded.positions[i];
    if (position && (*position < 0 || *position >= count))
      throw InvalidInput(recorded.files[i] + ": is said to be from position " + std::to_string(*position) +
                         ", the workspace has positions 0 to " + std::to_string(count - 1));
  }
}

// One file at a time: some of a known position, some not.
std::vector<ReadScan> readAtPositions(const RecordedScans& recorded, const ScannerProfile& profile,
                                      const Progress& progress) {
  std::vector<ReadScan> scans;
  const auto count = static_cast<double>(recorded.files.size());
  for (std::size_t i = 0; i < recorded.files.size(); ++i) {
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    part.checkpoint(0.0);
    if (recorded.positions[i]) {
      scans.push_back(readScanAt(recorded.files[i], profile, *recorded.positions[i], recorded.reading, part));
      scans.back().file = i;
      continue;
    }
    for (ReadScan& scan : readScans({recorded.files[i]}, nullptr, &profile, recorded.reading, part)) {
      scans.push_back(std::move(scan));
      scans.back().file = i;
    }
  }
  return scans;
}

}  // namespace

std::vector<ReadScan> readRecordedScans(const RecordedScans& recorded, const ScannerProfile* profile,
                                        const Progress& progress) {
  if (anyPosition(recorded)) {
    checkPositions(recorded, profile);
    std::vector<ReadScan> scans = readAtPositions(recorded, *profile, progress);
    requireSaidUnit(recorded.files, scans);
    return scans;
  }
  std::optional<std::vector<ScanPose>> list;
  if (!recorded.poses.empty()) list = readScanPoses(recorded.poses, 1.0);
  std::vector<ReadScan> scans = readScans(recorded.files, list ? &*list : nullptr, profile, recorded.reading, progress);
  if (profile != nullptr) requireSaidUnit(recorded.files, scans);
  return scans;
}

void requireSaidUnit(const std::vector<std::string>& files, const std::vector<ReadScan>& scans) {
  for (const ReadScan& scan : scans) {
    if (scan.reading.unitKnownBy != KnownBy::Evidence || scan.reading.unit == 1.0) continue;
    const auto known = lengthUnitOf(scan.reading.unit);
    const std::string unit = known ? std::string(name(*known)) : std::to_string(scan.reading.unit) + " mm";
    throw InvalidInput(files[scan.file] + ": seems to be in " + unit +
                       ", in which its points are before the scanner and on its rays, not in mm: say --unit " + unit +
                       ", or the unit that it is in");
  }
}

std::vector<std::string> labelsOf(const std::vector<std::string>& files, const std::vector<ReadScan>& scans) {
  std::vector<std::string> labels;
  std::vector<std::size_t> part(files.size(), 0);
  for (const ReadScan& scan : scans) ++part[scan.file];
  const std::vector<std::size_t> parts = part;
  std::fill(part.begin(), part.end(), 0);
  for (const ReadScan& scan : scans) {
    const std::string number =
        parts[scan.file] > 1 ? " part " + std::to_string(++part[scan.file]) + " of " + std::to_string(parts[scan.file])
                             : std::string();
    labels.push_back(files[scan.file] + number);
  }
  return labels;
}

}  // namespace vantage
