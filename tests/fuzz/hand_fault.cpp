// SPDX-License-Identifier: GPL-3.0-or-later
// A fault of an emulated tracker of hands, as --fault names it.
#include "device/hand/hand_fault.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto fault = EmulatedHandFault::parse(text);
  if (!fault) {
    fuzz::require_helpful(fault.error(), text);
    return 0;
  }
  fuzz::require(fault->at_s >= 0.0 && fault->duration_s >= 0.0, "times are not negative");
  fuzz::require(fault->probability >= 0.0 && fault->probability <= 1.0, "a probability is one");
  fuzz::require(std::isfinite(fault->step_s), "a jump is a number");
  return 0;
}
