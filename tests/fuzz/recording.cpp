// SPDX-License-Identifier: GPL-3.0-or-later
// Descriptions of recordings that others made: what is accepted names every column with its unit
// and scale, and says where the data come from.
#include "session/import/recording.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto spec = session::parse_recording(text, "recording.toml");
  if (!spec) {
    fuzz::require_helpful(spec.error(), text);
    return 0;
  }
  if (!spec->rig.empty()) {
    fuzz::require(spec->hand.has_value(), "an arm is right or left");
    fuzz::require(spec->columns.empty(), "markers have no columns");
    return 0;
  }
  fuzz::require(spec->rate_Hz > 0.0 && std::isfinite(spec->rate_Hz), "the rate is a number");
  fuzz::require(!spec->columns.empty(), "something is recorded");
  for (const session::RecordedColumn& column : spec->columns) {
    fuzz::require(!column.name.empty() && !column.from.empty(), "columns come from somewhere");
    fuzz::require(column.factor > 0.0 && std::isfinite(column.factor), "units have a scale");
  }
  fuzz::require(!session::provenance_of(*spec).empty(), "the origin is told");
  return 0;
}
