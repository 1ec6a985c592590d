#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "devices/serial/serial_line.h"
#include "devices/serial/table_dialog.h"
#include "devices/serial/table_profile.h"

namespace vantage {

/// What listening to a port and asking came to.
struct Recognition {
  std::optional<std::size_t> profile;  ///< index of the one that it answers to
  std::string heard;                   ///< what came, as it came, its beginning
};

/// Waits for the greeting of a board that the opening of its port has reset, then asks in the words of each profile,
/// none of which makes a table of another kind turn. @throws DeviceError when the port vanished; what the pulse throws
[[nodiscard]] Recognition recognise(SerialLine& line, const std::vector<TableProfile>& profiles,
                                    const TableDialog::Pulse& pulse);

}  // namespace vantage
