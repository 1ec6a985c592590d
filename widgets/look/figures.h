#pragma once

#include <QString>

namespace vantage {

/// A number for people, as many decimals as matter: thousands apart by a thin space from five digits on, the decimal
/// point as the language writes it.
[[nodiscard]] QString figureText(double value, int decimals = 0);

}  // namespace vantage
