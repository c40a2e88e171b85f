// SPDX-License-Identifier: GPL-3.0-or-later
// Which scheme of a device URI is opened by whom.
#include "device/can_device.hpp"
#include "device/force_device.hpp"
#include "device/replay_device.hpp"
#include "device/sim_device.hpp"
#include "device/uri.hpp"

namespace isograsp {

Result<std::unique_ptr<ForceDevice>> open_device(const std::string& text,
                                                 const DeviceOptions& options) {
  const auto uri = Uri::parse(text);
  if (!uri) return uri.error();
  if (uri->scheme == "sim") return open_sim_device(*uri, options);
  if (uri->scheme == "replay") return open_replay_device(*uri);
  if (uri->scheme == "can") return open_can_device(*uri);
  return uri->error("", "no device is called " + uri->scheme + "://",
                    "use sim://healthy, replay://FILE.csv or can://can0?protocol=rft");
}

}  // namespace isograsp
