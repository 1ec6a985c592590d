#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "integration/model.h"
#include "planning/plan.h"
#include "scanner/range_image.h"

namespace vantage {

/// The columns of a session file as bytes. Readers check every length: @throws InvalidInput naming `what`.
[[nodiscard]] std::vector<std::byte> poseBlob(const Pose& pose);
[[nodiscard]] Pose poseFromBlob(std::span<const std::byte> blob, const std::string& what);

[[nodiscard]] std::vector<std::byte> coloursBlob(const std::vector<Colour>& colours);
/// @param rays of the scan, as of rangeFromBlob
[[nodiscard]] std::vector<Colour> coloursFromBlob(std::span<const std::byte> blob, std::size_t rays,
                                                  const std::string& what);

[[nodiscard]] std::vector<std::byte> rangeBlob(const std::vector<float>& range);
/// @param rays of the scan: what unpacks to another number of ranges is refused without unpacking it
[[nodiscard]] std::vector<float> rangeFromBlob(std::span<const std::byte> blob, std::size_t rays,
                                               const std::string& what);

[[nodiscard]] std::vector<std::byte> raysBlob(const RayGrid& rays);
[[nodiscard]] RayGrid raysFromBlob(int rows, int columns, int receiversPerRay, std::span<const std::byte> blob,
                                   const std::string& what);

[[nodiscard]] std::vector<std::byte> modelBlob(const Model& model);
[[nodiscard]] Model modelFromBlob(std::span<const std::byte> blob, const std::string& what);

[[nodiscard]] std::vector<std::byte> meshBlob(const Mesh& mesh);
[[nodiscard]] Mesh meshFromBlob(std::span<const std::byte> blob, const std::string& what);

/// What a plan says of every patch: void patches, their outlook, and which of them each position would see. The reader
/// adds it to a plan that has its scores.
[[nodiscard]] std::vector<std::byte> planBlob(const Plan& plan);
void addFromPlanBlob(Plan& plan, std::span<const std::byte> blob, const std::string& what);

}  // namespace vantage
