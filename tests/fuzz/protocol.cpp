// SPDX-License-Identifier: GPL-3.0-or-later
// Protocol files.
#include "tasks/protocol.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto protocol = tasks::parse_protocol(text, "protocol.toml");
  if (!protocol) {
    fuzz::require_helpful(protocol.error(), text);
    return 0;
  }
  fuzz::require(!protocol->steps.empty(), "a protocol has steps");
  for (const auto& step : protocol->steps) {
    fuzz::require(step.repetitions >= 1, "a step is done once at least");
    fuzz::require(std::isfinite(step.rest_s) && step.rest_s >= 0.0, "a pause is no negative time");
    fuzz::require(step.kind != tasks::ProtocolStep::Kind::task || !step.tasks.empty(),
                  "a step names its task");
  }
  return 0;
}
