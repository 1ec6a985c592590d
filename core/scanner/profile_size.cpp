#include "scanner/profile_size.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace vantage {
namespace {

// [bytes] At the peak of a step, per ray of the scanner and per ray that is worked on; of the 5 million rays of a head
// that sees its object with a third of them.
constexpr double kOfEveryRay = 75.0;
constexpr double kOfWork = 250.0;
constexpr double kOfFurtherScan = 100.0;

}  // namespace

std::size_t raysSaidBy(const ProfileSource& source) {
  const auto json = nlohmann::json::parse(source.text, nullptr, false);
  if (!json.is_object() || !json.contains("scanner") || !json["scanner"].is_object()) return 0;
  const auto& scanner = json["scanner"];
  const auto count = [&](const char* key) -> std::size_t {
    return scanner.contains(key) && scanner[key].is_number_unsigned() ? scanner[key].get<std::size_t>() : 0;
  };
  return count("rows") * count("columns") + count("samples_per_stripe") * count("stripes");
}

MemoryNeeded memoryFor(std::size_t rays, const ThinningOptions& thinning) {
  MemoryNeeded needed;
  needed.worked = rays;
  if (!thinning.spacing && rays > kWholeRays) {
    const double step = std::ceil(std::sqrt(static_cast<double>(rays) / static_cast<double>(kUsefulRays)));
    needed.worked = static_cast<std::size_t>(static_cast<double>(rays) / (step * step));
  }
  const auto worked = static_cast<double>(needed.worked);
  needed.megabytes = (kOfEveryRay * static_cast<double>(rays) + kOfWork * worked) / 1e6;
  needed.everyScan = kOfFurtherScan * worked / 1e6;
  return needed;
}

}  // namespace vantage
