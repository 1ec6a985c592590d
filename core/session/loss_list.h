#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "session/loss.h"

namespace vantage {

/// Losses, each of them once, and of every kind in every table no more than kMostNamed: of the others there is a count.
class LossList {
 public:
  void add(Loss loss) {
    auto& [count, first] = counts_[{loss.kind, loss.name}];
    if (count == 0) first = losses_.size();
    if (std::find(losses_.begin() + static_cast<std::ptrdiff_t>(first), losses_.end(), loss) != losses_.end()) return;
    if (++count <= kMostNamed) losses_.push_back(std::move(loss));
  }

  /// One and the same loss for each of many numbers, from one to before another.
  /// @param make the loss of a number: only asked for as many as are named
  template <typename Make>
  void addEach(std::int64_t from, std::int64_t to, Make make) {
    const std::int64_t named = std::min<std::int64_t>(to, from + kMostNamed);
    for (std::int64_t number = from; number < named; ++number) add(make(number));
    if (to <= named) return;
    const Loss last = make(to - 1);
    counts_[{last.kind, last.name}].first += to - named;
  }

  /// All of them, with the counts.
  [[nodiscard]] std::vector<Loss> all() const {
    std::vector<Loss> losses = losses_;
    for (const auto& [what, entry] : counts_)
      if (entry.first > kMostNamed)
        losses.push_back({LossKind::MoreDamaged, entry.first - kMostNamed, what.second, {}});
    return losses;
  }

 private:
  std::vector<Loss> losses_;
  std::map<std::pair<LossKind, std::string>, std::pair<std::int64_t, std::size_t>> counts_;
};

}  // namespace vantage
