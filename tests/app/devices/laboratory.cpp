#include "laboratory.h"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

std::string readWhole(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// What follows `"key": ` in a JSON object of one line.
std::string valueOf(const std::string& json, const std::string& key) {
  const std::size_t at = json.find("\"" + key + "\": ");
  if (at == std::string::npos) throw std::runtime_error("no " + key + " in " + json);
  return json.substr(at + key.size() + 4);
}

}  // namespace

std::optional<fs::path> laboratoryFolder() {
  const char* named = std::getenv("VANTAGE_LAB");
  if (named == nullptr || !fs::exists(fs::path(named) / "lab_table")) return std::nullopt;
  return fs::path(named);
}

LaboratoryTable::LaboratoryTable(const fs::path& laboratory, std::vector<std::string> options,
                                 const std::string& faults) {
  options.insert(options.begin(),
                 {(laboratory / "lab_table").string(), "--link", port(), "--state", folder_.file("state.json"), "--log",
                  folder_.file("wire.log"), "--fault", folder_.write("faults.json", faults)});
  std::vector<char*> arguments;
  for (std::string& option : options) arguments.push_back(option.data());
  arguments.push_back(nullptr);
  if (::posix_spawn(&process_, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("the table of the laboratory does not start");
  for (int i = 0; i < 2000 && !(fs::exists(port()) && fs::exists(folder_.file("state.json"))); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

LaboratoryTable::~LaboratoryTable() {
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

std::string LaboratoryTable::state() const {
  return readWhole(folder_.file("state.json"));
}

double LaboratoryTable::truth() const {
  return std::stod(valueOf(state(), "angle_deg"));
}

bool LaboratoryTable::moving() const {
  return valueOf(state(), "moving").starts_with("true");
}

std::string LaboratoryTable::log() const {
  return readWhole(folder_.file("wire.log"));
}

}  // namespace vantage::testing
