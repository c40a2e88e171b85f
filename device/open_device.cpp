// SPDX-License-Identifier: GPL-3.0-or-later
// Which scheme of a device URI is opened by whom.
#include "device/config/uri.hpp"
#include "device/recording/replay_device.hpp"
#include "device/sensors/force_device.hpp"
#include "device/sensors/open_sensors.hpp"
#include "device/simulated/sim_device.hpp"

namespace isograsp {

Result<std::unique_ptr<ForceDevice>> open_device(const std::string& text,
                                                 const DeviceOptions& options) {
  const auto uri = Uri::parse(text);
  if (!uri) return uri.error();
  const bool on_bus = uri->scheme == "can" || uri->scheme == "udp" || uri->scheme == "serial";
  if (options.tap != nullptr && !on_bus)
    return refused("the device has no raw frames"_text, "record raw frames of a bus only"_text)
        .at(uri->text);
  if (uri->scheme == "sim") return open_sim_device(*uri, options);
  if (uri->scheme == "replay") return open_replay_device(*uri);
  if (on_bus || uri->scheme == "comedi") return open_sensors(*uri, options);
  return refused(
             "no device is called %1://"_text(uri->scheme),
             "use sim://healthy, replay://FILE.csv, can://, udp://, serial:// or comedi:// (see: "
             "isograsp devices)"_text)
      .at(uri->text);
}

}  // namespace isograsp
