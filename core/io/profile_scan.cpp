#include "io/profile_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "io/no_sample.h"
#include "io/samples_on_rays.h"
#include "io/scan_candidates.h"
#include "scanner/length_unit.h"

namespace vantage {
namespace {

// Of points that are not exactly on the rays, so many may be hidden behind others: from elsewhere more are.
constexpr double kMostHidden = 0.03;
// Of two units the one is right that puts so many times more samples about the viewing volume.
constexpr double kClearVolume = 2.0;

std::string unitName(double unit) {
  for (const LengthUnit known : kLengthUnits)
    if (millimetresIn(known) == unit) return std::string(name(known));
  return std::to_string(unit) + " mm";
}

std::string frameName(ScanFrame frame) {
  switch (frame) {
    case ScanFrame::Profile:
      return "profile";
    case ScanFrame::Camera:
      return "camera";
    case ScanFrame::OpenGl:
      return "gl";
    case ScanFrame::File:
      return "that of the file's own pose";
    case ScanFrame::Table:
      return "world";
  }
  return {};
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::floor(100.0 * share))) + " %";
}

struct Scored {
  ScanCandidate candidate;
  ScanScore score;
};

class Choice {
 public:
  Choice(const std::string& path, const std::vector<Vec3>& points, const ScannerProfile& profile,
         const std::optional<Pose>& T_table_scanner)
      : path_(path), points_(points), profile_(profile), T_table_scanner_(T_table_scanner) {}

  void score(const std::vector<ScanCandidate>& candidates) {
    for (const ScanCandidate& candidate : candidates)
      scored_.push_back({candidate, scoreOf(candidate, points_, profile_, T_table_scanner_)});
  }

  // The first frame in which the samples lie on the rays; nothing when there is none.
  [[nodiscard]] std::optional<ScanCandidate> exact() const {
    return single([](const Scored& s) { return s.score.isExact(); });
  }

  [[nodiscard]] std::optional<ScanCandidate> likely() const {
    const auto isLikely = [](const Scored& s) { return s.score.isLikely() && s.candidate.frame != ScanFrame::Table; };
    const auto asked = [](const Scored& s) { return s.score.isLikely(); };
    if (const auto found = single(isLikely)) return found;
    return onlyTable() ? single(asked) : std::nullopt;
  }

  // What fits best, for messages.
  [[nodiscard]] std::string bestText() const {
    const auto best = std::max_element(scored_.begin(), scored_.end(), [](const Scored& a, const Scored& b) {
      return a.score.reached < b.score.reached;
    });
    if (best->score.reached == 0.0) return "none of its samples is where the scanner can reach";
    return "at best " + percent(best->score.reached) + " of its samples are where the scanner can reach, in " +
           unitName(best->candidate.unit) + " and the frame " + frameName(best->candidate.frame) +
           ", and they do not lie on its rays";
  }

 private:
  [[nodiscard]] bool onlyTable() const {
    return std::all_of(scored_.begin(), scored_.end(),
                       [](const Scored& s) { return s.candidate.frame == ScanFrame::Table; });
  }

  template <typename Predicate>
  [[nodiscard]] std::optional<ScanCandidate> single(const Predicate& fits) const {
    std::vector<Scored> left;
    double most = 0.0;
    for (const Scored& s : scored_) {
      if (!fits(s)) continue;
      left.push_back(s);
      most = std::max(most, s.score.inVolume);
    }
    std::erase_if(left, [&](const Scored& s) { return kClearVolume * s.score.inVolume < most; });
    if (left.empty()) return std::nullopt;
    const ScanCandidate& first = left.front().candidate;
    for (const Scored& s : left) {
      if (s.candidate.unit != first.unit)
        throw UnansweredQuestion(path_ + ": could be in " + unitName(first.unit) + " or in " +
                                 unitName(s.candidate.unit) + ": say --unit mm, cm, m or inch");
      const bool same = s.candidate.T_scanner_file.isApprox(first.T_scanner_file, 1e-6);
      if (!same && !s.score.isExact())
        throw UnansweredQuestion(path_ + ": its points could be in the frame " + frameName(first.frame) + " or " +
                                 frameName(s.candidate.frame) + ": say --frame " + frameName(first.frame) +
                                 " or --frame " + frameName(s.candidate.frame));
    }
    return first;
  }

  const std::string& path_;
  const std::vector<Vec3>& points_;
  const ScannerProfile& profile_;
  const std::optional<Pose>& T_table_scanner_;
  std::vector<Scored> scored_;
};

// What would fit if what an operator said did not hold.
std::string otherWay(const RawScan& scan, const ScannerProfile& profile, const ScanReadingOptions& options,
                     const std::optional<Pose>& T_table_scanner) {
  if (!options.unit && !options.frame) return {};
  ScanReadingOptions open = options;
  open.unit.reset();
  open.frame.reset();
  Choice choice(scan.path, scan.file.samples.points, profile, T_table_scanner);
  choice.score(candidatesFor(scan.file, profile, open, T_table_scanner));
  const auto found = choice.exact();
  if (!found) return {};
  return "; they do lie on them with --unit " + unitName(found->unit) + " --frame " + frameName(found->frame);
}

[[noreturn]] void refuse(const RawScan& scan, const std::string& why, const std::string& other) {
  throw InvalidInput(scan.path + ": is not of this scanner: " + why + (other.empty() ? "" : other) +
                     (other.empty() ? "; choose the profile of the scanner that took it" : ""));
}

}  // namespace

ReadScan placeOnRays(const RawScan& scan, const ScannerProfile& profile, const ScanReadingOptions& options,
                     const std::optional<Pose>& T_table_scanner, bool ownSize, const Progress& progress) {
  const SampleGrid& samples = scan.file.samples;
  Choice choice(scan.path, samples.points, profile, T_table_scanner);
  choice.score(candidatesFor(scan.file, profile, options, T_table_scanner));
  std::optional<ScanCandidate> found = choice.exact();
  const bool exact = found.has_value();
  if (!found && !ownSize) found = choice.likely();
  if (!found) refuse(scan, choice.bestText(), otherWay(scan, profile, options, T_table_scanner));
  std::vector<Vec3> points = samples.points;
  for (Vec3& p : points) p = found->T_scanner_file * (found->unit * p);
  SamplesOnRays placed = samplesOnRays(points, samples.colours, profile.rays, progress);
  const double hidden = static_cast<double>(placed.hidden) / static_cast<double>(points.size());
  if (!exact && hidden > kMostHidden)
    refuse(scan, percent(hidden) + " of its samples are hidden behind others where the scanner stands",
           otherWay(scan, profile, options, T_table_scanner));
  ReadScan read{0, std::move(placed.image), scan.reading};
  read.reading.unit = read.reading.poseUnit = found->unit;
  read.reading.unitKnownBy = found->unitKnownBy;
  read.reading.sightKind = SightKind::Profile;
  read.reading.sightKnownBy = options.frame ? KnownBy::Operator : KnownBy::Evidence;
  read.reading.placed = found->frame == ScanFrame::Table;
  return read;
}

RangeImage readScan(const std::string& path, const ScannerProfile& profile, const ScanReadingOptions& options,
                    const Progress& progress, const std::optional<Pose>& T_table_scanner) {
  RawScan scan;
  scan.path = path;
  scan.file = readSamples(path, progress.part(0.0, 0.6), options.grid);
  const NoSamples none = dropNoSamples(scan.file.samples, options.noSample, progress.part(0.6, 0.7));
  if (scan.file.samples.points.empty())
    throw InvalidInput(path + ": has no samples but " + std::to_string(none.dropped) +
                       " that say that nothing was measured");
  const ReadScan read = placeOnRays(scan, profile, options, T_table_scanner, false, progress.part(0.7, 1.0));
  if (read.reading.unitKnownBy == KnownBy::Evidence && read.reading.unit != 1.0)
    throw UnansweredQuestion(path + ": the file seems to be in " + unitName(read.reading.unit) +
                             ", in which its points are before the scanner and on its rays, not in mm: say --unit " +
                             unitName(read.reading.unit));
  return read.image;
}

}  // namespace vantage
