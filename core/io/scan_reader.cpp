#include "io/scan_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "io/grid_images.h"
#include "io/no_sample.h"
#include "io/scan_on_rays.h"
#include "io/scan_sights.h"
#include "io/scan_unit.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

// Offsets are whole metres, so that they can be said and added without a rounding error.
constexpr double kOffsetStep = 1000.0;  // [mm]

constexpr std::array<std::pair<std::string_view, FrameChoice>, 12> kFrames{{{"x+", FrameChoice::LooksXUp},
                                                                            {"x-", FrameChoice::LooksXDown},
                                                                            {"y+", FrameChoice::LooksYUp},
                                                                            {"y-", FrameChoice::LooksYDown},
                                                                            {"z+", FrameChoice::LooksZUp},
                                                                            {"z-", FrameChoice::LooksZDown},
                                                                            {"camera", FrameChoice::LooksZUp},
                                                                            {"gl", FrameChoice::LooksZDown},
                                                                            {"opengl", FrameChoice::LooksZDown},
                                                                            {"profile", FrameChoice::Profile},
                                                                            {"world", FrameChoice::World},
                                                                            {"cylinder", FrameChoice::Turn}}};

void exchange(RawScan& scan) {
  std::swap(scan.file.samples.rows, scan.file.samples.columns);
  scan.reading.exchanged = true;
}

void dropMarks(RawScan& scan, const ScanReadingOptions& options, const Progress& progress) {
  const NoSamples none = dropNoSamples(scan.file.samples, options.noSample, progress);
  scan.reading.noSample = none.mark;
  scan.reading.dropped = none.dropped;
  if (scan.file.samples.points.empty())
    throw InvalidInput(scan.path + ": has no samples but " + std::to_string(none.dropped) +
                       " cells that say that nothing was measured");
}

// The samples about a point near them, where they are far from the origin.
void takeShift(RawScan& scan) {
  const Vec3 middle = middleOf(scan.file.samples);
  if (!isFar(middle, medianPitch(scan.file.samples))) return;
  scan.shift = middle.array().round();
  for (Vec3& p : scan.file.samples.points) p -= scan.shift;
}

void findSights(RawScan& scan) {
  scan.sight = findGridSight(scan.file.samples);
  if (scan.file.fromOrigin || scan.sight.fits) return;
  scan.turn = findTurn(scan.file.samples);
  if (scan.turn) return;
  const SampleGrid other = transposed(scan.file.samples);
  scan.turn = findTurn(other);
  if (scan.turn) scan.file.samples = other;
}

RawScan readRaw(const std::string& path, bool ofProfile, const ScanReadingOptions& options, const Progress& progress) {
  RawScan scan;
  scan.path = path;
  const Progress reading = progress.part(0.0, 0.7);
  scan.file = ofProfile ? readSamples(path, reading, options.grid) : readGridFile(path, reading, options.grid);
  dropMarks(scan, options, progress.part(0.7, 1.0));
  scan.T_object_scanner = scan.file.T_world_scanner;
  return scan;
}

Pose poseIn(const std::vector<ScanPose>& list, const std::string& file) {
  const auto pose = findPose(list, file);
  if (!pose) throw InvalidInput("the list of poses has none for " + file);
  return *pose;
}

class Interpretation {
 public:
  Interpretation(std::vector<RawScan> scans, const ScanReadingOptions& options)
      : scans_(std::move(scans)), options_(options) {}

  std::vector<ReadScan> read(const std::vector<ScanPose>* list, const Progress& progress) {
    parallelChunks(scans_.size(), 1, progress.part(0.0, 0.4), [&](std::size_t i, std::size_t) {
      RawScan& scan = scans_[i];
      if (scan.file.ofProfile)
        throw InvalidInput(scan.path + ": was not taken along z: it needs the profile of its scanner");
      if (isExchanged(scan.file.samples)) exchange(scan);
      takeShift(scan);
      findSights(scan);
    });
    takePoses(list);
    decideSights(scans_, options_);
    decideUnit();
    takeOffset();
    return images(progress.part(0.4, 1.0));
  }

 private:
  // Poses map the points as they stand in the file; the shift is part of them.
  void takePoses(const std::vector<ScanPose>* list) {
    double ratio = 1.0;
    if (list != nullptr) ratio = listRatio(*list);
    for (RawScan& scan : scans_) {
      if (list != nullptr) {
        scan.T_object_scanner = poseIn(*list, scan.path);
        scan.T_object_scanner->translation() *= ratio;
        scan.poseOfList = true;
        scan.reading.poseUnit = ratio;
        scan.reading.poseUnitKnownBy = ratio == 1.0 ? KnownBy::Default : KnownBy::Evidence;
      }
      if (!scan.shift.isZero(0.0)) {
        if (!scan.T_object_scanner) scan.T_object_scanner = Pose::Identity();
        scan.T_object_scanner = *scan.T_object_scanner * Eigen::Translation3d(scan.shift);
      }
    }
    if (const auto axis = axisOfTurns(scans_))
      for (RawScan& scan : scans_) scan.reading.turnsAbout = axis;
  }

  [[nodiscard]] double listRatio(const std::vector<ScanPose>& list) const {
    std::vector<Vec3> middles;
    std::vector<Pose> poses;
    double size = 0.0;
    for (const RawScan& scan : scans_) {
      middles.push_back(middleOf(scan.file.samples) + scan.shift);
      poses.push_back(poseIn(list, scan.path));
      size = std::max(size, sizeOf(scan.file.samples));
    }
    return poseUnitRatio(middles, poses, size);
  }

  void decideUnit() {
    std::optional<double> unit = options_.unit;
    KnownBy knownBy = KnownBy::Operator;
    if (!unit && scans_.front().file.unit) {
      unit = scans_.front().file.unit;
      knownBy = KnownBy::File;
    }
    if (!unit) {
      unit = guessed();
      knownBy = KnownBy::Evidence;
    }
    for (RawScan& scan : scans_) {
      const bool own = knownBy == KnownBy::File && scan.file.unit;
      scan.reading.unit = own ? *scan.file.unit : *unit;
      scan.reading.unitKnownBy = knownBy;
      scan.reading.poseUnit *= scan.reading.unit;
    }
  }

  [[nodiscard]] double guessed() const {
    UnitEvidence evidence;
    for (const RawScan& scan : scans_) {
      evidence.size = std::max(evidence.size, sizeOf(scan.file.samples));
      evidence.pitch = std::max(evidence.pitch, medianPitch(scan.file.samples));
      if (scan.sight.spreads) evidence.distance = std::max(evidence.distance.value_or(0.0), *scan.sight.distance);
      evidence.usuallyMetres |= scan.file.inMetres;
    }
    const UnitGuess guess = guessUnit(evidence);
    if (!guess.clear) refuseUnit(evidence);
    return millimetresIn(guess.unit);
  }

  [[noreturn]] void refuseUnit(const UnitEvidence& evidence) const {
    throw InvalidInput(scans_.front().path + ": its unit cannot be told: its samples are " +
                       std::to_string(evidence.size) + " units across and " + std::to_string(evidence.pitch) +
                       " apart, which could be millimetres, metres or others: say --unit mm, cm, m or inch");
  }

  // What is far from the origin of the object goes into one offset of all scans.
  void takeOffset() {
    const auto posed = std::find_if(scans_.begin(), scans_.end(), [](const RawScan& s) {
      return s.T_object_scanner && isFar(*s.T_object_scanner * middleOf(s.file.samples), medianPitch(s.file.samples));
    });
    if (posed == scans_.end()) return;
    const Vec3 middle = posed->reading.unit * (*posed->T_object_scanner * middleOf(posed->file.samples));
    offset_ = kOffsetStep * (middle / kOffsetStep).array().round();
  }

  [[nodiscard]] std::vector<ReadScan> images(const Progress& progress) const {
    std::vector<std::vector<ReadScan>> perFile(scans_.size());
    parallelChunks(scans_.size(), 1, progress, [&](std::size_t i, std::size_t) {
      for (RangeImage& image : imagesOf(scans_[i])) perFile[i].push_back(finished(i, std::move(image)));
    });
    std::vector<ReadScan> read;
    for (std::vector<ReadScan>& scans : perFile)
      read.insert(read.end(), std::make_move_iterator(scans.begin()), std::make_move_iterator(scans.end()));
    return read;
  }

  [[nodiscard]] std::vector<RangeImage> imagesOf(const RawScan& scan) const {
    SampleGrid grid = scan.file.samples;
    for (Vec3& p : grid.points) p *= scan.reading.unit;
    if (scan.reading.sightKind == SightKind::Turntable) return imagesOfTurn(grid, *scan.turn, options_.standoff);
    if (scan.reading.sightKind == SightKind::Point) return {imageFromOrigin(grid, *fitTurn(grid, Axis::Z))};
    return {imageAlong(grid, scan.reading.sight, options_.standoff)};
  }

  [[nodiscard]] ReadScan finished(std::size_t file, RangeImage image) const {
    const RawScan& scan = scans_[file];
    ReadScan read{file, std::move(image), scan.reading};
    const Axis up = options_.up.value_or(Axis::Z);
    const Eigen::Matrix3d upright = uprightTurn(up);
    Pose T = scan.T_object_scanner.value_or(Pose::Identity());
    T.translation() = T.translation() * scan.reading.unit - offset_;
    read.image.T_table_scanner.linear() = up == Axis::Z ? Eigen::Matrix3d(T.linear()) : upright * T.linear();
    read.image.T_table_scanner.translation() = up == Axis::Z ? Vec3(T.translation()) : upright * T.translation();
    if (scan.T_object_scanner && (scan.poseOfList || scan.file.T_world_scanner || scan.reading.placed))
      read.image.poseKnownBy = PoseSource::Reported;
    read.reading.offset = up == Axis::Z ? offset_ : Vec3(upright * offset_);
    read.reading.up = up;
    return read;
  }

  std::vector<RawScan> scans_;
  const ScanReadingOptions& options_;
  Vec3 offset_ = Vec3::Zero();
};

}  // namespace

std::optional<FrameChoice> parseFrame(std::string_view text) {
  if (text == "auto") return std::nullopt;
  for (const auto& [name, frame] : kFrames)
    if (name == text) return frame;
  throw InvalidInput("frame is '" + std::string(text) +
                     "', expected auto, profile, camera, gl, x+, x-, y+, y-, z+, z-, world or cylinder");
}

namespace {

bool fitsAProfile(FrameChoice frame) {
  return frame == FrameChoice::Profile || frame == FrameChoice::World || frame == FrameChoice::LooksZUp ||
         frame == FrameChoice::LooksZDown;
}

}  // namespace

std::vector<ReadScan> readScans(const std::vector<std::string>& files, const std::vector<ScanPose>* list,
                                const ScannerProfile* profile, const ScanReadingOptions& options,
                                const Progress& progress) {
  if (profile == nullptr && options.frame == FrameChoice::Profile)
    throw InvalidInput("--frame profile needs --scanner PROFILE.json, whose frame it is");
  if (profile != nullptr && options.frame && !fitsAProfile(*options.frame))
    throw InvalidInput(
        "the profile says where its scanner looks: leave --frame, or say profile, camera, gl or world for points that "
        "are in other coordinates than its own");
  const auto share = [&](std::size_t file) { return static_cast<double>(file) / static_cast<double>(files.size()); };
  if (profile == nullptr) {
    std::vector<RawScan> raw;
    const Progress reading = progress.part(0.0, 0.5);
    for (const std::string& file : files)
      raw.push_back(readRaw(file, false, options, reading.part(share(raw.size()), share(raw.size() + 1))));
    return Interpretation(std::move(raw), options).read(list, progress.part(0.5, 1.0));
  }
  // One after the other: points take much more memory than what they are on the rays.
  std::vector<ReadScan> read;
  for (const std::string& file : files) {
    const Progress one = progress.part(share(read.size()), share(read.size() + 1));
    std::optional<Pose> pose;
    if (list != nullptr) pose = poseIn(*list, file);
    read.push_back(readOnRays(readRaw(file, true, options, one.part(0.0, 0.7)), *profile, pose, true, options,
                              one.part(0.7, 1.0)));
    read.back().file = read.size() - 1;
    if (pose) read.back().image.poseKnownBy = PoseSource::Reported;
  }
  return read;
}

ReadScan readScanAt(const std::string& file, const ScannerProfile& profile, int position,
                    const ScanReadingOptions& options, const Progress& progress) {
  const Pose& pose = profile.workspace.poses[static_cast<std::size_t>(position)];
  ReadScan read = readOnRays(readRaw(file, true, options, progress.part(0.0, 0.7)), profile, pose, false, options,
                             progress.part(0.7, 1.0));
  read.image.station.position = position;
  read.image.poseKnownBy = PoseSource::Commanded;
  return read;
}

}  // namespace vantage
