#include "acquisition/setting_lookup.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "acquisition/settings_table.h"
#include "base/errors.h"

namespace vantage {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 16> kGroups{{{"", "Acquisition"},
                                                                   {"simulation", "Simulated scanner"},
                                                                   {"planner", "Planning"},
                                                                   {"closing", "Predicted surface"},
                                                                   {"ledger", "Ledger of forecasts"},
                                                                   {"termination", "Termination"},
                                                                   {"history", "What views have looked at"},
                                                                   {"void", "Void patches"},
                                                                   {"cut", "What is not the object"},
                                                                   {"triangulation", "Surface of a scan"},
                                                                   {"registration", "Registration"},
                                                                   {"verdict", "Verdict on a registration"},
                                                                   {"refinement", "Refinement of all poses"},
                                                                   {"alignment", "Import of recorded scans"},
                                                                   {"zipper", "Integration"},
                                                                   {"consensus", "Consensus"}}};

// How many characters must be put in, left out or replaced to make one text the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view groupLabel(std::string_view group) {
  const auto found = std::find_if(kGroups.begin(), kGroups.end(), [&](const auto& g) { return g[0] == group; });
  if (found == kGroups.end()) throw InvalidInput("there is no group of settings '" + std::string(group) + "'");
  return (*found)[1];
}

const SettingField& settingField(std::string_view key) {
  // Nobody means a setting by a text that is much longer than all of them.
  constexpr std::size_t kLongestKey = 100;
  const auto fields = settingFields();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const SettingField& f) { return f.key == key; });
  if (found != fields.end()) return *found;
  const std::string_view head = key.substr(0, kLongestKey);
  const auto nearest = std::min_element(fields.begin(), fields.end(), [&](const auto& a, const auto& b) {
    return editDistance(head, a.key) < editDistance(head, b.key);
  });
  throw InvalidInput("there is no option '" + std::string(head) + "', the nearest is " + std::string(nearest->key));
}

}  // namespace vantage
