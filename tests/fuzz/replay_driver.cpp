#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/random.h"
#include "fuzz/fuzz_target.h"

// Runs a fuzz target without a fuzzer: its seeds, and seeded mutations of them.
// Usage: replay_<target> [COUNT]      mutations of the seeds (default 2000)
//        replay_<target> FILE...      files, for instance what a fuzzer found
//        replay_<target> --seeds DIR  writes the seeds there

namespace vantage::testing {
namespace {

// Numbers and words that readers stumble over.
constexpr const char* kPieces[] = {"0",     "-1",  "4294967295", "18446744073709551615",
                                   "1e308", "nan", "inf",        "\xff\xff\xff\xff",
                                   "{",     "}",   "[",          "\"",
                                   "\n",    " ",   "null",       "999999999"};

void changeOnce(std::string& text, Random& random) {
  const std::size_t at = random.below(text.size());
  const std::size_t length = std::min<std::size_t>(1 + random.below(16), text.size() - at);
  switch (random.below(5)) {
    case 0:
      text[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, kPieces[random.below(std::size(kPieces))]);
      break;
    case 3:
      text.resize(at);
      break;
    default:
      text.insert(random.below(text.size()), text.substr(at, length));
      break;
  }
}

std::string mutated(std::string text, Random& random) {
  for (std::uint64_t i = 1 + random.below(4); i > 0 && !text.empty(); --i) changeOnce(text, random);
  return text;
}

void runOne(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

void runFile(const char* path) {
  std::ifstream in(path, std::ios::binary);
  runOne({std::istreambuf_iterator<char>(in), {}});
}

void writeSeeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::vector<std::string> seeds = fuzzSeeds();
  for (std::size_t i = 0; i < seeds.size(); ++i)
    std::ofstream(folder / ("seed_" + std::to_string(i)), std::ios::binary) << seeds[i];
}

void runMutations(std::uint64_t count) {
  const std::vector<std::string> seeds = fuzzSeeds();
  for (const std::string& seed : seeds) runOne(seed);
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random(i);
    runOne(mutated(seeds[random.below(seeds.size())], random));
  }
  std::printf("%zu seeds and %llu mutations\n", seeds.size(), static_cast<unsigned long long>(count));
}

}  // namespace
}  // namespace vantage::testing

int main(int argc, char** argv) {
  using namespace vantage::testing;
  if (argc == 3 && std::string(argv[1]) == "--seeds") {
    writeSeeds(argv[2]);
  } else if (argc > 1 && std::filesystem::exists(argv[1])) {
    for (int i = 1; i < argc; ++i) runFile(argv[i]);
  } else {
    runMutations(argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000);
  }
  return 0;
}
