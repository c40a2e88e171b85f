// SPDX-License-Identifier: GPL-3.0-or-later
// Faults as the command line names them.
#include "device/emulator/fault.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto fault = Fault::parse(text);
  if (!fault) {
    fuzz::require_helpful(fault.error(), text);
    return 0;
  }
  fuzz::require(fault->probability >= 0.0 && fault->probability <= 1.0,
                "a probability is a probability");
  fuzz::require(std::isfinite(fault->at_s) && fault->at_s >= 0.0, "a fault has its time");
  fuzz::require(std::isfinite(fault->duration_s) && fault->duration_s >= 0.0,
                "a fault has its duration");
  fuzz::require(std::isfinite(fault->amount), "an amount is a number");
  return 0;
}
