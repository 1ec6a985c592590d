#include "positional_space/positional_image.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/errors.h"
#include "base/parallel.h"
#include "positional_space/observation_rays.h"

namespace vantage {
namespace {

// Rays that are collected before they are traced as one stream: they stay in the cache.
constexpr std::size_t kBatch = 512;
// Sources per chunk of work.
constexpr std::size_t kChunk = 128;

struct SourceSighting {
  std::uint32_t source;
  Sighting sighting;
};

// Adds up the contributions of the chunks that one thread works on.
class Accumulator {
 public:
  Accumulator(std::span<const ObservationSource> sources, const RayCaster& obstacles, const ScannerImages& scanner,
              const CellLookup& lookup, double breakdownAngle, const AccumulationOptions& options)
      : sources_(sources),
        obstacles_(obstacles),
        scanner_(scanner),
        options_(options),
        rays_(scanner, lookup, breakdownAngle, options) {
    image.sums.assign(scanner.cellCount(), 0);
    const int periods = scanner.data().periods;
    for (int g = 0; g < periods; ++g)
      turns_.push_back(Eigen::AngleAxisd(2.0 * kPi * g / periods, Vec3::UnitZ()).toRotationMatrix().cast<float>());
    for (const Vec3& r : scanner.data().receiverPositions) receivers_.push_back(r.cast<float>());
  }

  void add(std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (sources_[s].weight > 0.0) rays_.append(sources_[s], static_cast<std::uint32_t>(s), batch_);
      if (batch_.rays.size() >= kBatch) flush();
    }
    flush();
  }

  // Sightings since the last call, by source, then cell.
  std::vector<SourceSighting> takeSightings() {
    std::vector<SourceSighting> taken = std::move(sightings_);
    sightings_.clear();
    std::sort(taken.begin(), taken.end(), [](const SourceSighting& a, const SourceSighting& b) {
      return std::pair(a.source, a.sighting.cell) < std::pair(b.source, b.sighting.cell);
    });
    return taken;
  }

  PositionalImage image;

 private:
  void flush() {
    obstacles_.occluded(batch_.rays);
    image.observationRays += batch_.rays.size();
    pending_.clear();
    for (std::size_t k = 0; k < batch_.rays.size(); ++k) {
      if (batch_.rays[k].blocked()) continue;
      if (scanner_.triangulates())
        pending_.push_back(batch_.observations[k]);
      else
        deposit(batch_.observations[k]);
    }
    for (int r = 0; r < scanner_.data().receivers && !pending_.empty(); ++r) seekReceiver(static_cast<std::size_t>(r));
    batch_.clear();
  }

  // Deposits the pending observations whose r-th receiver sees the source; the others stay pending.
  void seekReceiver(std::size_t r) {
    sight_.clear();
    sightOf_.clear();
    for (std::size_t k = 0; k < pending_.size(); ++k) addLineOfSight(k, r);
    obstacles_.occluded(sight_);
    image.linesOfSight += sight_.size();
    seen_.assign(pending_.size(), 0);
    for (std::size_t k = 0; k < sight_.size(); ++k) {
      if (sight_[k].blocked()) continue;
      deposit(pending_[sightOf_[k]]);
      seen_[sightOf_[k]] = 1;
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pending_.size(); ++k)
      if (seen_[k] == 0) pending_[kept++] = pending_[k];
    pending_.resize(kept);
  }

  void addLineOfSight(std::size_t k, std::size_t r) {
    const Observation& o = pending_[k];
    const ObservationSource& source = sources_[o.source];
    const std::size_t stored = scanner_.data().cells.size();
    const auto perCell = static_cast<std::size_t>(scanner_.data().receivers);
    const std::uint32_t cell = batch_.cells[o.first].cell;
    const Eigen::Vector3f receiver = turns_[cell / stored] * receivers_[cell % stored * perCell + r];
    const Eigen::Vector3f normal = source.normal.cast<float>();
    const Eigen::Vector3f centre = source.centre.cast<float>();
    if ((receiver - centre).dot(normal) <= 0.0F) return;
    const Eigen::Vector3f from = centre + static_cast<float>(options_.surfaceOffset) * normal;
    const Eigen::Vector3f to = receiver - from;
    sight_.push_back({from.x(), from.y(), from.z(), 0.0F, to.x(), to.y(), to.z(), 0.0F, 1.0F});
    sightOf_.push_back(static_cast<std::uint32_t>(k));
  }

  void deposit(const Observation& o) {
    const double scale = sources_[o.source].weight / PositionalImage::kUnit;
    for (std::uint32_t k = o.first; k < o.first + o.count; ++k) {
      const std::uint32_t cell = batch_.cells[k].cell;
      const float confidence = batch_.cells[k].confidence();
      image.sums[cell] += std::llrint(scale * static_cast<double>(confidence));
      if (options_.keepSightings) sightings_.push_back({o.source, {cell, confidence}});
    }
  }

  std::span<const ObservationSource> sources_;
  const RayCaster& obstacles_;
  const ScannerImages& scanner_;
  const AccumulationOptions& options_;
  std::vector<Eigen::Matrix3f> turns_;
  std::vector<Eigen::Vector3f> receivers_;
  ObservationRays rays_;
  ObservationBatch batch_;
  std::vector<Observation> pending_;
  std::vector<OcclusionRay> sight_;
  std::vector<std::uint32_t> sightOf_;
  std::vector<std::uint8_t> seen_;
  std::vector<SourceSighting> sightings_;
};

// Lends accumulators to chunks: as many come into being as chunks run at once.
class AccumulatorPool {
 public:
  template <typename Make>
  Accumulator& take(const Make& make) {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      Accumulator* last = idle_.back();
      idle_.pop_back();
      return *last;
    }
    all_.push_back(make());
    return *all_.back();
  }

  void giveBack(Accumulator& accumulator) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(&accumulator);
  }

  [[nodiscard]] const std::vector<std::unique_ptr<Accumulator>>& all() const { return all_; }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Accumulator>> all_;
  std::vector<Accumulator*> idle_;
};

void check(std::span<const ObservationSource> sources) {
  if (sources.size() >= kNoIndex)
    throw InvalidInput(std::to_string(sources.size()) + " observation sources are too many");
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const ObservationSource& o = sources[s];
    // A share of 2^62 units leaves room for the sum of all.
    if (!(o.weight >= 0.0 && o.weight < 1e9) || !o.centre.allFinite())
      throw InvalidInput("observation source " + std::to_string(s) + " has no finite place or no weight from 0 to 1e9");
    if (o.weight > 0.0 && !(std::abs(o.normal.norm() - 1.0) < 1e-3))
      throw InvalidInput("observation source " + std::to_string(s) + " has no unit normal");
  }
}

void appendSightings(const std::vector<std::vector<SourceSighting>>& chunks, std::size_t sources,
                     PositionalImage& image) {
  image.sightingStart.assign(sources + 1, 0);
  for (const auto& chunk : chunks) {
    for (const SourceSighting& s : chunk) {
      image.sightings.push_back(s.sighting);
      ++image.sightingStart[s.source + 1];
    }
  }
  for (std::size_t s = 0; s < sources; ++s) image.sightingStart[s + 1] += image.sightingStart[s];
}

}  // namespace

PositionalImage accumulate(std::span<const ObservationSource> sources, const RayCaster& obstacles,
                           const ScannerImages& scanner, double breakdownAngle, const AccumulationOptions& options,
                           const Progress& progress) {
  check(sources);
  const CellLookup lookup(scanner);
  AccumulatorPool pool;
  std::vector<std::vector<SourceSighting>> sightings((sources.size() + kChunk - 1) / kChunk);
  parallelChunks(sources.size(), kChunk, progress, [&](std::size_t begin, std::size_t end) {
    Accumulator& accumulator = pool.take(
        [&] { return std::make_unique<Accumulator>(sources, obstacles, scanner, lookup, breakdownAngle, options); });
    accumulator.add(begin, end);
    sightings[begin / kChunk] = accumulator.takeSightings();
    pool.giveBack(accumulator);
  });

  PositionalImage image;
  image.sums.assign(scanner.cellCount(), 0);
  for (const auto& accumulator : pool.all()) {
    for (std::size_t k = 0; k < image.sums.size(); ++k) image.sums[k] += accumulator->image.sums[k];
    image.observationRays += accumulator->image.observationRays;
    image.linesOfSight += accumulator->image.linesOfSight;
  }
  if (options.keepSightings) appendSightings(sightings, sources.size(), image);
  return image;
}

}  // namespace vantage
