#include <memory>

#include "acquisition/session_file.h"
#include "cli/command.h"
#include "io/file_info.h"

namespace vantage {
namespace {

nlohmann::ordered_json jsonOf(const FactValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

// What a session holds, beyond that it is one.
void addSessionFacts(const std::string& path, const Progress& progress, FileInfo& info) {
  const Session session = SessionFile::open(path).load(progress);
  info.facts.emplace_back("views", static_cast<std::int64_t>(session.state.views.size()));
  info.facts.emplace_back("scanner",
                          session.state.profile ? session.state.profile->name : std::string("recorded scans"));
  info.facts.emplace_back("object", session.settings.object);
  if (session.state.model)
    info.facts.emplace_back("model_triangles", static_cast<std::int64_t>(session.state.model->mesh.triangles.size()));
}

void run(const std::string& path, CommandContext& context) {
  FileInfo info = describeFile(path, context.progress());
  if (info.content == FileContent::Session) addSessionFacts(path, context.progress(), info);
  nlohmann::ordered_json json{{"file", path}, {"kind", nameOf(info.content)}};
  std::string text = path + ": " + nameOf(info.content) + "\n";
  for (const auto& [key, value] : info.facts) {
    json[key] = jsonOf(value);
    text += "  " + key + ": " + toText(value) + "\n";
  }
  context.result(json, text);
}

}  // namespace

void addInfoCommand(CLI::App& app, CommandContext& context) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "Say what a mesh, range file, profile or session is");
  command->add_option("file", *path, "File to describe")->required();
  context.addCommonOptions(*command);
  command->callback([path, &context] { run(*path, context); });
}

}  // namespace vantage
