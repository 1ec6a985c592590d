#pragma once

#include "finishing/finished_model.h"
#include "scanner/length_unit.h"

namespace vantage {

/// How a model is handed over.
struct HandOver {
  FinishingOptions finishing;
  LengthUnit unit = LengthUnit::Millimetre;
  bool onlyPrintable = true;  ///< nothing is written of a model that cannot be printed as one piece
};

}  // namespace vantage
