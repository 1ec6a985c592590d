#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "acquisition/kept_scan.h"
#include "simulated_bodies.h"

namespace vantage {

/// What is wrong with a set of scans.
enum class ImportFault : std::uint8_t {
  None,
  OneElsewhere,    ///< one scan is of another object
  FirstElsewhere,  ///< the first one is
  TwoElsewhere,    ///< two are, of different objects
  HalfTurns,       ///< the table turned half of what the list says
  OtherWay,        ///< the table turned the other way
  ListInMetres,    ///< positions in the list are metres, samples millimetres
  NoList,          ///< nobody says where the scanner stood
  InverseList,     ///< the list has the inverse of every pose
  FlippedFrame,    ///< samples have y down and z forward
  AxisBeside,      ///< the axis is a tenth of the size beside where the list has it
};
inline constexpr int kImportFaults = 11;
[[nodiscard]] const char* name(ImportFault fault);

/// Eight scans of a body with what they should come to.
struct SimulatedImport {
  ImportFault fault = ImportFault::None;
  BodyKind kind = BodyKind::Unique;
  double size = 0.0;     ///< about [mm]
  double spacing = 0.0;  ///< [mm]
  double noise = 0.0;    ///< [spacings]
  std::vector<NumberedScan> scans;
  std::vector<Pose> truth;      ///< T_object_scanner, one per scan
  std::vector<bool> elsewhere;  ///< one per scan: of another object
  Body distance;                ///< object coordinates
};

/// The same for the same seed on every machine.
[[nodiscard]] SimulatedImport simulatedImport(std::uint64_t seed);

}  // namespace vantage
