// SPDX-License-Identifier: GPL-3.0-or-later
// A tracker of hands, named by a URI: live over the network or a recording. Positions leave it in
// m, in the world of the tracker (x right, y up, z to the viewer). It tells where joints are and
// nothing else: no picture is read.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/config/uri.hpp"
#include "device/sensors/force_device.hpp"
#include "hand/hand_source.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp {

/// One hand in one frame of the tracker.
struct HandSample {
  Timestamp stamp{0};  ///< when it was seen, on the clock given to start()
  /// Place in the grid of the tracker's period: frames that were lost are counted. Increases
  /// strictly for each hand.
  std::int64_t number = 0;
  /// t_s: since the first frame, on the tracker's clock as long as that can be believed. A hand of
  /// which a joint is missing or no number is not tracked (metacarpals and palm may be missing).
  HandFrame frame;
};

/// Counters since start(); they never decrease.
struct HandCounters {
  std::uint64_t frames = 0;       ///< of the tracker, whatever they show
  std::uint64_t rows = 0;         ///< of the chosen hand
  std::uint64_t untracked = 0;    ///< of these: the hand was not seen, or not whole
  std::uint64_t incomplete = 0;   ///< of these: a joint was missing or no number
  std::uint64_t other_side = 0;   ///< rows of the other hand, which are not given
  std::uint64_t lost = 0;         ///< frames missing by time
  std::uint64_t late = 0;         ///< messages whose time is not above that of the last one
  std::uint64_t malformed = 0;    ///< messages that mean nothing
  std::uint64_t foreign = 0;      ///< messages of another sender than the first
  std::uint64_t clock_steps = 0;  ///< times that the tracker's clock jumped
  std::uint64_t restarts = 0;     ///< times that the connection had to be made anew
  std::uint64_t overrun = 0;      ///< rows that nobody fetched in time
};

/// Why a tracker is degraded or faulted, the gravest first.
enum class HandFault : std::uint8_t {
  none,
  connection_lost,  ///< the tracker's service has closed the connection
  silence,          ///< it sends nothing
  frozen,           ///< it repeats one picture
  other_hand,       ///< it has shown only the other hand for a while
  damaged_samples   ///< frames are lost or mean nothing
};
/// Whether the hand is missing because of it. A hand that is not seen for a while is no fault.
[[nodiscard]] constexpr bool stops_hand(HandFault fault) noexcept {
  return fault != HandFault::none && fault <= HandFault::frozen;
}
/// One word for machines: "silence".
[[nodiscard]] std::string_view name_of(HandFault fault) noexcept;
/// One plain sentence for the therapist, with what to do. Real-time safe.
[[nodiscard]] Words words_of(HandFault fault) noexcept;

struct HandHealth {
  DeviceState state = DeviceState::absent;
  HandFault fault = HandFault::none;
  HandCounters counters;
  /// Stamp of the tracker to arrival, beyond the smallest so far [s]; nothing before a frame.
  std::optional<double> jitter_s;
};

/// What the device is. Live trackers tell service and rate at start(); the rest is fixed.
struct HandDeviceInfo {
  std::string uri;
  Text description;               ///< one line for people, e.g. "Leap service at 127.0.0.1"
  bool simulated = false;         ///< hands come from software
  bool recorded = false;          ///< hands come from a file
  double period_s = 0.01;         ///< of the tracker
  std::optional<double> delay_s;  ///< from the hand to the stamp; nothing: not measured
  std::string mounting;           ///< of the camera: desk, screen or head
  std::string service;            ///< version of the tracker's program, empty: it tells none
  std::vector<std::string> provenance;
};

/// Life: open_hand_device() -> start() -> read()… -> stop(). All calls from one thread.
class HandDevice {
 public:
  virtual ~HandDevice() = default;

  [[nodiscard]] virtual const HandDeviceInfo& info() const noexcept = 0;
  [[nodiscard]] virtual HandHealth health() const noexcept = 0;

  /// Begins to stream; stamps are on `clock`, which must outlive the device and, of a live tracker,
  /// is read from another thread, too. Errors: nobody answers, or sends no frames.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  /// Waits for the next row of the chosen hand at most until `deadline`. Real-time safe.
  [[nodiscard]] virtual ReadStatus read(Timestamp deadline, HandSample& out) noexcept = 0;
  /// The present on the axis of the stamps and deadlines: that of the clock, except for a replay
  /// that runs slower or faster than it was recorded. Real-time safe.
  [[nodiscard]] virtual Timestamp now(const Clock& clock) const noexcept { return clock.now(); }
  virtual void stop() noexcept = 0;
};

/// Opens leap://HOST[:PORT], udp-hand://HOST[:PORT], replay://FILE, sim://hand. `side` is the hand
/// of the session: rows of the other label are counted and not given; nothing: both hands are
/// given. `person`: whose hand sim://hand shows; outlives the device.
[[nodiscard]] Result<std::unique_ptr<HandDevice>> open_hand_device(const Uri& uri,
                                                                   std::optional<Hand> side,
                                                                   HandSource* person = nullptr);

}  // namespace isograsp
