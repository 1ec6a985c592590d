#include "session_import.h"

#include <filesystem>

#include "base/errors.h"
#include "session/import_note.h"
#include "session/session_place.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

// The folder, and those that had to be made for it: they go again when nothing comes of them.
class FolderToFill {
 public:
  explicit FolderToFill(const std::string& path) {
    std::error_code error;
    for (fs::path folder = fs::absolute(path).lexically_normal(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
      made_.push_back(folder);
    fs::create_directories(path, error);
    if (error) throw IoError(path, "cannot be made a folder: " + error.message());
  }
  // One that has something in it stays.
  ~FolderToFill() {
    std::error_code error;
    for (const fs::path& folder : made_) fs::remove(folder, error);
  }
  FolderToFill(const FolderToFill&) = delete;
  FolderToFill& operator=(const FolderToFill&) = delete;

 private:
  std::vector<fs::path> made_;
};

}  // namespace

OpenedSession importSession(const ImportChoice& choice, const std::string& cacheFolder, const Progress& progress) {
  std::optional<ProfileSource> source;
  std::shared_ptr<const ScannerProfile> profile;
  if (!choice.scanner.empty()) {
    source = readProfileSource(choice.scanner);
    profile = std::make_shared<const ScannerProfile>(parseProfile(*source));
  }
  std::vector<ReadScan> scans =
      readRecordedScans(choice.recorded, profile.get(), progress.part(0.0, 0.1, "read scans"));
  std::vector<RangeImage> images;
  std::vector<ScanReading> readings;
  for (ReadScan& scan : scans) {
    images.push_back(std::move(scan.image));
    readings.push_back(scan.reading);
  }
  const FolderToFill folder(choice.folder);
  const std::string path = freeSessionName(choice.folder);
  {
    SessionPlace place(path, false);
    Session session = place.make({source, choice.settings, nullptr, profile});
    noteImport(session, readings);
    Acquisition(session).importScans(std::move(images), progress.part(0.1, 0.9), readings);
    place.keep();
  }
  return openSession(path, SessionAccess::Write, cacheFolder, progress.part(0.9, 1.0));
}

void addRecordedScans(Acquisition& acquisition, const RecordedScans& recorded, const SetUp& setUp,
                      const Progress& progress) {
  const auto count = static_cast<double>(recorded.files.size());
  for (std::size_t i = 0; i < recorded.files.size(); ++i) {
    const auto position = i < recorded.positions.size() ? recorded.positions[i] : std::nullopt;
    if (!position) throw InvalidInput(recorded.files[i] + ": say from which position it was taken");
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    ReadScan scan =
        readScanAt(recorded.files[i], *setUp.profile, *position, recorded.reading, part.part(0.0, 0.2, "read scan"));
    requireSaidUnit({recorded.files[i]}, {scan});
    if (turnedByHand(setUp)) {
      scan.image.poseKnownBy = PoseSource::ByHand;
      scan.image.poseUncertainty = kTurnedByHand;
    }
    acquisition.addScan(std::move(scan.image), part.part(0.2, 1.0));
  }
}

}  // namespace vantage
