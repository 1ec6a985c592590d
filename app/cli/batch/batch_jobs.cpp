#include "cli/batch/batch_jobs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "base/errors.h"
#include "base/plain_text.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestName = 100;
// What the batch itself says to its commands, and what a batch has nobody for.
constexpr std::array<std::string_view, 8> kOwnOptions{"out",     "session", "json", "threads",
                                                      "replace", "events",  "help", "range"};

// What is read, where in which file: the words of every refusal.
class Place {
 public:
  Place(std::string file, const CLI::App& app) : file_(std::move(file)), app_(app) {}

  [[noreturn]] void refuse(const std::string& pointer, const std::string& expected) const {
    throw InvalidInput(file_ + ": " + (pointer.empty() ? "/" : pointer) + ": expected " + expected);
  }
  [[nodiscard]] const CLI::App& command(const std::string& name) const { return *app_.get_subcommand(name); }

 private:
  std::string file_;
  const CLI::App& app_;
};

void mustKnow(const Place& place, const Json& object, const std::string& pointer,
              const std::set<std::string>& members) {
  if (!object.is_object()) place.refuse(pointer, "an object");
  for (const auto& [key, value] : object.items()) {
    if (members.contains(key)) continue;
    std::string known;
    for (const std::string& member : members) known += (known.empty() ? "" : ", ") + member;
    place.refuse(pointer + "/" + plainText(key), "one of " + known);
  }
}

std::string textOf(const Place& place, const Json& value, const std::string& pointer) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return value.dump();
  place.refuse(pointer, "a text or a number");
}

std::vector<std::string> textsOf(const Place& place, const Json& value, const std::string& pointer) {
  if (!value.is_array()) return {textOf(place, value, pointer)};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < value.size(); ++i)
    texts.push_back(textOf(place, value[i], pointer + "/" + std::to_string(i)));
  return texts;
}

void addSettings(const Place& place, const Json& settings, const std::string& pointer,
                 std::vector<std::string>& arguments) {
  if (!settings.is_object()) place.refuse(pointer, "an object of settings, as vantage-cli options lists them");
  for (const auto& [key, value] : settings.items())
    arguments.push_back("--set=" + key + "=" +
                        (value.is_boolean() ? value.dump() : textOf(place, value, pointer + "/" + key)));
}

void addOption(const Place& place, const std::string& command, const std::string& key, const Json& value,
               const std::string& pointer, std::vector<std::string>& arguments) {
  const CLI::Option* option = place.command(command).get_option_no_throw("--" + key);
  const bool own = std::find(kOwnOptions.begin(), kOwnOptions.end(), key) != kOwnOptions.end();
  if (option == nullptr || own) place.refuse(pointer, "an option of " + command + " that a batch does not set itself");
  if (key == "set") return addSettings(place, value, pointer, arguments);
  if (option->get_expected_max() == 0) {
    if (!value.is_boolean()) place.refuse(pointer, "true or false");
    if (value.get<bool>()) arguments.push_back("--" + key);
    return;
  }
  const std::vector<std::string> texts = textsOf(place, value, pointer);
  if (option->get_delimiter() == ',') {
    std::string joined;
    for (const std::string& text : texts) joined += (joined.empty() ? "" : ",") + text;
    arguments.push_back("--" + key + "=" + joined);
    return;
  }
  for (const std::string& text : texts) arguments.push_back("--" + key + "=" + text);
}

BatchStep stepOf(const Place& place, const std::string& command, const Json& options, const std::string& pointer) {
  if (!options.is_object()) place.refuse(pointer, "an object of the options of " + command);
  BatchStep step{command, {}};
  for (const auto& [key, value] : options.items())
    if (!(command == "import" && key == "range"))
      addOption(place, command, key, value, pointer + "/" + plainText(key), step.arguments);
  if (command != "import") return step;
  const auto range = options.find("range");
  if (range == options.end() || (range->is_array() && range->empty()))
    place.refuse(pointer + "/range", "the files of scans to import");
  step.arguments.emplace_back("--");
  for (std::string& file : textsOf(place, *range, pointer + "/range")) step.arguments.push_back(std::move(file));
  return step;
}

bool isPlainName(const std::string& name) {
  return !name.empty() && name.size() <= kLongestName && name.front() != '.' && name.front() != '-' &&
         name.find('/') == std::string::npos && plainText(name) == name;
}

std::string fileName(const Place& place, const Json& value, const std::string& pointer) {
  if (value.is_string() && isPlainName(value.get<std::string>())) return value.get<std::string>();
  place.refuse(pointer, "the name of a file in the folder of the job");
}

void addExports(const Place& place, const Json& value, const std::string& pointer, std::vector<BatchStep>& steps) {
  const Json files = value.is_array() ? value : Json::array({value});
  for (std::size_t i = 0; i < files.size(); ++i)
    steps.push_back(
        {"export", {fileName(place, files[i], value.is_array() ? pointer + "/" + std::to_string(i) : pointer)}});
}

void addReport(const Place& place, const Json& value, const std::string& pointer, std::vector<BatchStep>& steps) {
  if (value.is_boolean() && !value.get<bool>()) return;
  steps.push_back({"report", {value.is_boolean() ? "report.html" : fileName(place, value, pointer)}});
}

// What all jobs have where they do not say it themselves.
Json completed(const Json& job, const Json& all) {
  Json whole = job;
  const bool begins = job.contains("acquire") || job.contains("import") || job.contains("session");
  for (const auto& [key, value] : all.items()) {
    const bool beginning = key == "acquire" || key == "import";
    if (!whole.contains(key) && !(beginning && begins)) {
      whole[key] = value;
    } else if (beginning && whole.contains(key) && value.is_object() && whole[key].is_object()) {
      for (const auto& [option, usual] : value.items())
        if (!whole[key].contains(option)) whole[key][option] = usual;
    }
  }
  return whole;
}

BatchJob jobOf(const Place& place, const Json& described, const std::string& pointer, const BatchFile& file) {
  mustKnow(place, described, pointer, {"name", "acquire", "import", "session", "export", "report"});
  const auto name = described.find("name");
  if (name == described.end() || !name->is_string() || !isPlainName(name->get<std::string>()))
    place.refuse(pointer + "/name", "a name that a folder can have");
  BatchJob job{name->get<std::string>(), {}, {}, described};
  job.session = (fs::path(file.out) / job.name / "session.vantage").string();
  int beginnings = 0;
  for (const char* command : {"acquire", "import"}) {
    if (!described.contains(command)) continue;
    ++beginnings;
    job.steps.push_back(stepOf(place, command, described[command], pointer + "/" + command));
  }
  if (described.contains("session")) {
    ++beginnings;
    if (!described["session"].is_string()) place.refuse(pointer + "/session", "a session file");
    job.session = (fs::path(file.folder) / described["session"].get<std::string>()).lexically_normal().string();
  }
  if (beginnings != 1) place.refuse(pointer, "one of acquire, import and session");
  if (described.contains("export")) addExports(place, described["export"], pointer + "/export", job.steps);
  if (described.contains("report")) addReport(place, described["report"], pointer + "/report", job.steps);
  if (job.steps.empty()) place.refuse(pointer, "something to be done: acquire, import, export or report");
  return job;
}

Json parsed(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path, "cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  try {
    return Json::parse(text);
  } catch (const Json::exception& e) {
    throw InvalidInput(path + ": is no JSON: " + e.what());
  }
}

}  // namespace

BatchFile readBatchFile(const std::string& path, const std::string& out, const CLI::App& app) {
  const Json json = parsed(path);
  const Place place(path, app);
  mustKnow(place, json, "", {"out", "all", "jobs"});
  const fs::path file = fs::absolute(path).lexically_normal();
  BatchFile batch;
  batch.folder = file.parent_path().string();
  batch.out = (file.parent_path() / file.stem()).string();
  if (json.contains("out"))
    batch.out = (file.parent_path() / textOf(place, json["out"], "/out")).lexically_normal().string();
  if (!out.empty()) batch.out = fs::absolute(out).lexically_normal().string();
  const Json all = json.value("all", Json::object());
  mustKnow(place, all, "/all", {"acquire", "import", "export", "report"});
  if (!json.contains("jobs") || !json["jobs"].is_array() || json["jobs"].empty())
    place.refuse("/jobs", "a list of jobs");
  std::set<std::string> names;
  for (std::size_t i = 0; i < json["jobs"].size(); ++i) {
    const std::string pointer = "/jobs/" + std::to_string(i);
    if (!json["jobs"][i].is_object()) place.refuse(pointer, "an object");
    batch.jobs.push_back(jobOf(place, completed(json["jobs"][i], all), pointer, batch));
    if (!names.insert(batch.jobs.back().name).second) place.refuse(pointer + "/name", "a name that no other job has");
  }
  return batch;
}

}  // namespace vantage
