#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "integration/model.h"
#include "scanner/ray_grid.h"

namespace vantage {

/// The columns of a session file as bytes. Readers check every length: @throws InvalidInput naming `what`.
[[nodiscard]] std::vector<std::byte> poseBlob(const Pose& pose);
[[nodiscard]] Pose poseFromBlob(std::span<const std::byte> blob, const std::string& what);

[[nodiscard]] std::vector<std::byte> rangeBlob(const std::vector<float>& range);
[[nodiscard]] std::vector<float> rangeFromBlob(std::span<const std::byte> blob, const std::string& what);

[[nodiscard]] std::vector<std::byte> raysBlob(const RayGrid& rays);
[[nodiscard]] RayGrid raysFromBlob(int rows, int columns, int receiversPerRay, std::span<const std::byte> blob,
                                   const std::string& what);

[[nodiscard]] std::vector<std::byte> modelBlob(const Model& model);
[[nodiscard]] Model modelFromBlob(std::span<const std::byte> blob, const std::string& what);

}  // namespace vantage
