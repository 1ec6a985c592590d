#include "house/sentences.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>

namespace vantage::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> kResultRooms{"registration", "integration", "composites",
                                                  "void_space",   "planning",    "acquisition"};
// Files of these rooms that hold no result: help, groups and bounds of the settings, and what a device that hangs is
// said to do.
constexpr std::array<std::string_view, 4> kNoResults{"setting_field.cpp", "setting_lookup.cpp", "settings_table.cpp",
                                                     "patient_scanner.h"};

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Walks through a source, one token at a time.
class Walk {
 public:
  explicit Walk(std::string_view source) : source_(source) {}

  std::vector<Sentence> run() {
    while (at_ < source_.size()) step();
    return std::move(found_);
  }

 private:
  void step() {
    if (ahead("//")) return skipPast("\n");
    if (ahead("/*")) return skipPast("*/");
    if (ahead("R\"")) return rawLiteral();
    const char c = source_[at_];
    if (c == '"') return literal();
    if (c == '\'') return character();
    if (isWord(c)) return word();
    if (c == ';') thrown_ = false;
    advance(1);
  }

  [[nodiscard]] bool ahead(std::string_view text) const { return source_.substr(at_).starts_with(text); }

  void advance(std::size_t count) {
    for (; count > 0 && at_ < source_.size(); --count) line_ += source_[at_++] == '\n' ? 1 : 0;
  }

  void skipPast(std::string_view end) {
    const std::size_t found = source_.find(end, at_);
    advance(found == std::string_view::npos ? source_.size() : found + end.size() - at_);
  }

  // Numbers are words as well, so that 1'000 is no character.
  void word() {
    const std::size_t from = at_;
    const bool number = std::isdigit(static_cast<unsigned char>(source_[at_])) != 0;
    while (at_ < source_.size() && (isWord(source_[at_]) || (number && source_[at_] == '\''))) advance(1);
    if (source_.substr(from, at_ - from) == "throw") thrown_ = true;
  }

  void character() {
    advance(1);
    while (at_ < source_.size() && source_[at_] != '\'') advance(source_[at_] == '\\' ? 2 : 1);
    advance(1);
  }

  void literal() {
    const int line = line_;
    advance(1);
    const std::size_t from = at_;
    while (at_ < source_.size() && source_[at_] != '"') advance(source_[at_] == '\\' ? 2 : 1);
    add(line, source_.substr(from, at_ - from));
    advance(1);
  }

  void rawLiteral() {
    const int line = line_;
    advance(2);
    const std::size_t open = source_.find('(', at_);
    if (open == std::string_view::npos) return;
    std::string close(1, ')');
    close.append(source_.substr(at_, open - at_)).append(1, '"');
    const std::size_t end = source_.find(close, open);
    add(line, source_.substr(open + 1, end == std::string_view::npos ? end : end - open - 1));
    skipPast(close);
  }

  void add(int line, std::string_view text) {
    if (!thrown_ && text.find(' ') != std::string_view::npos) found_.push_back({line, std::string(text)});
  }

  std::string_view source_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool thrown_ = false;
  std::vector<Sentence> found_;
};

void checkFile(const fs::path& root, const fs::path& file, std::vector<std::string>& violations) {
  std::ifstream in(file);
  const std::string source{std::istreambuf_iterator<char>(in), {}};
  for (const Sentence& sentence : sentencesIn(source))
    violations.push_back(fs::relative(file, root).generic_string() + ":" + std::to_string(sentence.line) +
                         ": results are codes and numbers: \"" + sentence.text + "\"");
}

}  // namespace

std::vector<Sentence> sentencesIn(std::string_view source) {
  return Walk(source).run();
}

std::vector<std::string> sentenceViolations(const fs::path& root) {
  std::set<fs::path> files;
  for (const char* room : kResultRooms) {
    if (!fs::is_directory(root / "core" / room)) continue;
    for (const auto& entry : fs::directory_iterator(root / "core" / room))
      if ((entry.path().extension() == ".h" || entry.path().extension() == ".cpp") &&
          std::find(kNoResults.begin(), kNoResults.end(), entry.path().filename()) == kNoResults.end())
        files.insert(entry.path());
  }
  std::vector<std::string> violations;
  for (const fs::path& file : files) checkFile(root, file, violations);
  return violations;
}

}  // namespace vantage::testing
