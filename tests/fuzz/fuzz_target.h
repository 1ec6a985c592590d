#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What libFuzzer calls, and the replay driver as well. One of each per target. An input is refused with a
/// vantage::Error or read; anything else that comes out ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace vantage::testing {

/// Good inputs of the target that fuzzing begins with.
[[nodiscard]] std::vector<std::string> fuzzSeeds();

}  // namespace vantage::testing
