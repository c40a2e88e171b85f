// SPDX-License-Identifier: GPL-3.0-or-later
// A system of cameras that tells where optical markers are, named by a URI: live over the network,
// a recording, or simulated. Positions leave it in m, in the frame W of the cameras, as the cameras
// see them (left arms too: kinematics/rig.hpp reflects them).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "core/time.hpp"
#include "device/config/uri.hpp"
#include "device/sensors/force_device.hpp"
#include "hand/marker_source.hpp"

namespace isograsp {

/// One picture of all cameras.
struct MarkerSample {
  Timestamp stamp{0};  ///< when it was taken, on the clock given to start()
  /// Place in the grid of the cameras: those that were lost are counted, so that rate and gaps are
  /// exact whatever the network does. Increases strictly.
  std::int64_t number = 0;
  /// One position for each label [m]; not seen: NaN in all three places. Until the next read().
  std::span<const Vec3> p_W;
};

/// Counters since start(); they never decrease.
struct MarkerCounters {
  std::uint64_t good = 0;        ///< pictures given, whatever they show
  std::uint64_t lost = 0;        ///< pictures missing by number
  std::uint64_t duplicate = 0;   ///< pictures whose number is not above that of the last one
  std::uint64_t unlabelled = 0;  ///< pictures of other markers than the labels say
  std::uint64_t damaged = 0;     ///< packets that mean nothing
  std::uint64_t restarts = 0;    ///< times that the connection had to be made anew
};

/// Why a device is degraded or faulted, the gravest first.
enum class MarkerFault : std::uint8_t {
  none,
  connection_lost,  ///< the computer of the cameras has closed the connection
  silence,          ///< it is there and sends nothing
  wrong_labels,     ///< it came back with other markers
  damaged_samples   ///< pictures are lost or mean nothing
};
/// Whether markers are missing because of it.
[[nodiscard]] constexpr bool stops_markers(MarkerFault fault) noexcept {
  return fault != MarkerFault::none && fault <= MarkerFault::wrong_labels;
}
/// One word for machines: "silence".
[[nodiscard]] std::string_view name_of(MarkerFault fault) noexcept;
/// One plain sentence for the therapist, with what to do. Real-time safe.
[[nodiscard]] Words words_of(MarkerFault fault) noexcept;

struct MarkerHealth {
  DeviceState state = DeviceState::absent;
  MarkerFault fault = MarkerFault::none;
  MarkerCounters counters;
  /// Stamp of the cameras to arrival, beyond the smallest so far [s]; nothing: they tell no time.
  std::optional<double> jitter_s;
};

/// What the device is. Live systems tell labels and rate at start(); the rest is fixed.
struct MarkerDeviceInfo {
  std::string uri;
  Text description;        ///< one line for people, e.g. "Qualisys at 192.168.0.7"
  bool simulated = false;  ///< markers come from software: reports carry a watermark
  bool recorded = false;   ///< markers come from a file
  double period_s = 0.01;  ///< of the cameras
  double delay_s = 0.0;    ///< known delay from the picture to its stamp
  std::vector<std::string> labels;
  std::vector<std::string> provenance;  ///< where recorded data come from
};

/// Life: open_marker_device() -> start() -> read()… -> stop(). All calls from one thread.
class MarkerDevice {
 public:
  virtual ~MarkerDevice() = default;

  [[nodiscard]] virtual const MarkerDeviceInfo& info() const noexcept = 0;
  [[nodiscard]] virtual MarkerHealth health() const noexcept = 0;

  /// Begins to stream; stamps are on `clock`, which must outlive the device. Errors: nobody
  /// answers, or has no markers.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  /// Waits for the next picture at most until `deadline`. Real-time safe.
  [[nodiscard]] virtual ReadStatus read(Timestamp deadline, MarkerSample& out) noexcept = 0;
  /// The present on the axis of the stamps and deadlines: that of the clock, except for a replay
  /// that runs slower or faster than it was recorded. Real-time safe.
  [[nodiscard]] virtual Timestamp now(const Clock& clock) const noexcept { return clock.now(); }
  virtual void stop() noexcept = 0;
};

/// Opens qtm://HOST[:PORT], natnet://HOST, replay://FILE, sim://arm. The parameter `rig` belongs to
/// who reads the markers and is let pass. `source` is what sim:// shows; it must outlive the
/// device; null where nobody is simulated.
[[nodiscard]] Result<std::unique_ptr<MarkerDevice>> open_marker_device(
    const Uri& uri, MarkerSource* source = nullptr);

}  // namespace isograsp
