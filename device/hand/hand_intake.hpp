// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. From frames of a tracker to rows of the hand that is wanted: which
// side, whole or not, counted and watched. The same for every source; no socket, no clock of its
// own.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/hand/hand_device.hpp"
#include "device/hand/hand_times.hpp"

namespace isograsp {

/// What is known of a stream at one instant.
struct HandReception {
  enum class Link : std::uint8_t {
    open,        ///< or a source without a connection
    lost,        ///< it was there
    nobody,      ///< it never was: nobody answers
    no_service,  ///< it never was: who answers is no tracker
  };
  HandCounters counters;
  Link link = Link::open;
  Timestamp last_frame{0};              ///< arrival; of begin() before the first
  std::optional<Timestamp> damaged;     ///< when damage was seen last
  std::optional<Timestamp> other_from;  ///< since when only the other hand has been seen
  Timestamp other_last{0};              ///< when it was seen last
  bool frozen = false;
  double period_s = 0.0;  ///< 0: not known yet
  std::optional<double> jitter_s;

  /// Without a frame, or with the other hand alone, for longer something is wrong.
  static constexpr Timestamp kPatience = std::chrono::milliseconds(200);
  /// How long damage is told.
  static constexpr Timestamp kRecent = std::chrono::seconds(1);

  [[nodiscard]] HandFault fault(Timestamp now) const noexcept;
  /// State and fault of a device that streams. Real-time safe.
  [[nodiscard]] HandHealth health(Timestamp now) const noexcept;
};

class HandIntake {
 public:
  /// Frames that are looked at for the period where nobody tells it.
  static constexpr std::size_t kLooks = 10;

  explicit HandIntake(std::optional<Hand> side) noexcept : side_(side) {}

  /// `period_s`: nothing: it is found from the first frames.
  void begin(Timestamp now, std::optional<double> period_s = std::nullopt) noexcept;
  /// One message: hands at a time of the tracker [s]. The rows to give, until the next call.
  [[nodiscard]] std::span<const HandSample> take(double tracker_s, std::span<const HandFrame> hands,
                                                 Timestamp arrival);
  /// A message that means nothing, comes behind a later one, or is of somebody else.
  void malformed(Timestamp now) noexcept;
  void late(Timestamp now) noexcept;
  void foreign(Timestamp now) noexcept;
  /// The connection stands, or does not. A new one counts as made anew when its first frame comes.
  void link(HandReception::Link link) noexcept;
  /// Rows that nobody fetched.
  void overrun() noexcept { ++now_.counters.overrun; }

  [[nodiscard]] const HandReception& reception() const noexcept { return now_; }

 private:
  void look(const PlacedHand& placed);
  void watch_side(std::span<const HandFrame> hands, Timestamp arrival) noexcept;
  void watch_motion(const HandFrame& frame, Timestamp arrival) noexcept;

  /// What each hand showed last.
  struct Seen {
    std::int64_t number = -1;
    std::array<Vec3, kHandJointCount> joints;
    Timestamp same_from{0};  ///< since when it has not moved by a bit
    int repeats = -1;        ///< -1: it was not tracked
    bool frozen = false;
  };

  std::optional<Hand> side_;
  HandTimes times_;
  HandReception now_;
  std::vector<double> first_s_;  ///< times of the first frames
  std::array<Seen, 2> seen_{};
  std::array<HandSample, 2> rows_{};
  std::int64_t number_ = -1;
  bool new_link_ = false;
};

}  // namespace isograsp
