#pragma once

#include <string>

#include "io/grid_file.h"

namespace vantage {

/// Reads depth: a grey PNG of 16 bits per pixel, 0 is no sample, with the camera's intrinsics as JSON beside it:
/// NAME.json for NAME.png, else NAME.png.json, intrinsics.json or camera.json. The JSON has, at its top or in an object
/// "intrinsics", fx, fy, cx (or ppx), cy (or ppy) in pixels, pixel centres at whole numbers, or instead of them a
/// matrix of nine numbers "K", "camera_matrix" (row by row) or "intrinsic_matrix" (column by column); and
/// "depth_scale": counts per metre, or, below 1, metres per count. A "width" and "height" must be those of the picture.
/// Points are in the camera's frame, x right, y down, z forward, in millimetres.
/// @throws IoError when it or its JSON cannot be read
/// @throws InvalidInput naming file and expectation, for a picture of another kind, a truncated one, and for intrinsics
///         that are missing or no camera's
[[nodiscard]] GridFile readDepthPng(const std::string& path);

/// The JSON file that belongs to a depth picture; empty when there is none.
[[nodiscard]] std::string intrinsicsBeside(const std::string& path);

}  // namespace vantage
