// SPDX-License-Identifier: GPL-3.0-or-later
// The configuration page of a Net F/T box: what is accepted is a scale, and comes back when
// written.
#include <cmath>

#include "device/codec/net_ft_box_config.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto page = fuzz::as_text(data, size);
  const auto config = NetFtBoxConfig::parse(page, "192.168.1.1");
  if (!config) {
    fuzz::require_helpful(config.error(), page);
    return 0;
  }
  const NetFtScale& scale = config->scale;
  for (const double number : {scale.counts_per_unit_force, scale.counts_per_unit_torque,
                              scale.unit_force_N, scale.unit_torque_Nm})
    fuzz::require(std::isfinite(number) && number > 0.0, "counts are a number of newtons");
  fuzz::require(!config->rate_Hz || (std::isfinite(*config->rate_Hz) && *config->rate_Hz > 0.0),
                "a rate is no surprise");
  fuzz::require(!config->range || (config->range->allFinite() && config->range->minCoeff() > 0.0),
                "a range is a range");
  const auto again = NetFtBoxConfig::parse(encode_net_ft_page(*config), "192.168.1.1");
  fuzz::require(again.ok(), "what is written can be read");
  fuzz::require(again->product == config->product && again->serial_number == config->serial_number,
                "a box keeps its name");
  return 0;
}
