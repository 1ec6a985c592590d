#include "house/include_cycles.h"

#include <deque>
#include <map>
#include <regex>
#include <set>

#include "house/source_files.h"

namespace vantage::testing {
namespace {

using Graph = std::map<std::string, std::set<std::string>>;

const std::regex kInclude("^\\s*#\\s*include\\s*\"([^\"]+)\"");

Graph includesOf(const std::vector<SourceFile>& files) {
  Graph graph;
  for (const SourceFile& file : files)
    if (file.isHeader()) graph[file.name];
  for (const SourceFile& file : files) {
    if (!file.isHeader()) continue;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (!std::regex_search(line, match, kInclude)) continue;
      // From its own layer, from the root of another, or from the root of the tree.
      for (const std::string& from : {file.layer() + "/", std::string("core/"), std::string("widgets/"), std::string()})
        if (graph.contains(from + match[1].str())) {
          graph[file.name].insert(from + match[1].str());
          break;
        }
    }
  }
  return graph;
}

// The shortest way from a header back to itself over headers that are not before it in the alphabet; empty for none.
std::string circleFrom(const Graph& graph, const std::string& start) {
  std::map<std::string, std::string> pathTo{{start, start}};
  std::deque<std::string> open{start};
  while (!open.empty()) {
    const std::string at = open.front();
    open.pop_front();
    for (const std::string& next : graph.at(at)) {
      if (next == start) return pathTo[at] + " > " + start;
      if (next > start && pathTo.emplace(next, pathTo[at] + " > " + next).second) open.push_back(next);
    }
  }
  return {};
}

}  // namespace

std::vector<std::string> includeCycles(const std::filesystem::path& root) {
  const Graph graph = includesOf(sourceFiles(root));
  std::vector<std::string> circles;
  for (const auto& [header, includes] : graph)
    if (std::string circle = circleFrom(graph, header); !circle.empty()) circles.push_back(std::move(circle));
  return circles;
}

}  // namespace vantage::testing
