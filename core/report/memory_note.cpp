#include "report/memory_note.h"

#include <utility>

#include "scanner/profile_size.h"

namespace vantage {
namespace {

constexpr double kWorthSaying = 300.0;  // [MB]

Phrase millions(std::size_t count) {
  return figure(static_cast<double>(count) / 1e6, 1);
}

// "1.2 GB", "44 MB".
Phrase memory(double megabytes) {
  return megabytes < 100.0 ? words("%1 MB", {figure(megabytes, 0)}) : words("%1 GB", {figure(megabytes / 1e3, 1)});
}

}  // namespace

std::optional<Phrase> memoryNote(std::size_t rays, const ThinningOptions& thinning, std::size_t scans) {
  const MemoryNeeded needed = memoryFor(rays, thinning);
  const double next = needed.with(static_cast<int>(scans) + 1);
  if (next <= kWorthSaying) return std::nullopt;
  Phrase note = words(
      "the scanner has %1 million rays: this takes about %2 of memory, about %3 more with every scan, and every "
      "step some time",
      {millions(rays), memory(next), memory(needed.everyScan)});
  if (needed.worked == rays) return note;
  return words("%1; of every scan about %2 million samples are worked on, the session keeps all",
               {std::move(note), millions(needed.worked)});
}

}  // namespace vantage
