#include "report/edges_left.h"

#include <array>

namespace vantage {

std::vector<EdgesLeft> edgesLeft(const Plan& plan) {
  if (!plan.voids || plan.voids->patches.size() != plan.outlook.size()) return {};
  std::array<EdgesLeft, kEdgeReasons> all;
  for (std::size_t p = 0; p < plan.outlook.size(); ++p) {
    EdgesLeft& left = all.at(static_cast<std::size_t>(plan.outlook[p].reason));
    left.reason = plan.outlook[p].reason;
    ++left.edges;
    left.length += plan.voids->patches[p].width;
  }
  std::vector<EdgesLeft> result;
  for (const EdgesLeft& left : all)
    if (left.edges > 0) result.push_back(left);
  return result;
}

}  // namespace vantage
