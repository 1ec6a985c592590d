#include <algorithm>
#include <memory>

#include "base/plain_text.h"
#include "cli/command.h"
#include "cli/open_session.h"
#include "io/file_info.h"
#include "report/wording.h"

namespace vantage {
namespace {

nlohmann::ordered_json jsonOf(const FactValue& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

// What a session holds, beyond that it is one. Scans and models stay on the disk.
void addSessionFacts(const std::string& path, CommandContext& context, FileInfo& info) {
  const Session session = openSession(path, SessionAccess::Read, context);
  checkSession(session, context);
  const History& history = session.history();
  const StateOutline& outline = *history.current().outline;
  info.facts.emplace_back("scans", session.scanCount());
  info.facts.emplace_back("views", static_cast<std::int64_t>(countScans(outline, ScanStatus::In)));
  info.facts.emplace_back("rejected", static_cast<std::int64_t>(countScans(outline, ScanStatus::Rejected)));
  info.facts.emplace_back("left_out", static_cast<std::int64_t>(countScans(outline, ScanStatus::LeftOut)));
  info.facts.emplace_back("stands", static_cast<std::int64_t>(outline.stands.size()));
  info.facts.emplace_back("stands_not_aligned",
                          std::int64_t{std::count_if(outline.stands.begin(), outline.stands.end(),
                                                     [](const Stand& stand) { return !stand.T_object_table; })});
  info.facts.emplace_back("aside", static_cast<std::int64_t>(countScans(outline, ScanStatus::Aside)));
  info.facts.emplace_back("steps", static_cast<std::int64_t>(history.size()));
  info.facts.emplace_back("last_step", describe(history.current().command));
  info.facts.emplace_back("state", std::string(name(outline.termination)));
  info.facts.emplace_back("scanner", session.profile() ? session.profile()->name : std::string("recorded scans"));
  info.facts.emplace_back("object", outline.settings.simulation.object);
  if (const auto model = session.model(history.cursor()))
    info.facts.emplace_back("model_triangles", static_cast<std::int64_t>(model->mesh.triangles.size()));
  const std::vector<Loss> losses = session.losses();
  const bool partly =
      std::any_of(losses.begin(), losses.end(), [](const Loss& loss) { return loss.kind == LossKind::StepsUnread; });
  info.facts.emplace_back(
      "checked",
      partly ? std::string("the last steps, with every row that they need against its sum and every one of "
                           "them against its hash; not the steps before, nor whether the whole file is readable")
             : std::string("every row against its sum, every step against its hash, where it has one"));
  info.facts.emplace_back("damages", std::int64_t{std::count_if(losses.begin(), losses.end(), isDamage)});
}

void runInfo(const std::string& path, CommandContext& context) {
  FileInfo info = describeFile(path, context.progress());
  if (info.content == FileContent::Session) addSessionFacts(path, context, info);
  nlohmann::ordered_json json{{"file", path}, {"kind", nameOf(info.content)}};
  std::string text = plainText(path) + ": " + nameOf(info.content) + "\n";
  for (const auto& [key, value] : info.facts) {
    json[key] = jsonOf(value);
    text += "  " + key + ": " + plainText(toText(value)) + "\n";
  }
  context.result(json, text);
}

}  // namespace

void addInfoCommand(CLI::App& app, CommandContext& context) {
  auto path = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("info", "Say what a mesh, range file, profile or session is");
  command->add_option("file", *path, "File to describe")->required();
  context.addCommonOptions(*command);
  command->callback([path, &context] { runInfo(*path, context); });
}

}  // namespace vantage
