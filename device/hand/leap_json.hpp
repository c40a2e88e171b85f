// SPDX-License-Identifier: GPL-3.0-or-later
// Hands from messages of the Leap service (WebSocket, protocol v6): one JSON object each. Pure: no
// socket, no clock. Lengths become metres, times seconds since the first frame.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hand/tracked_hand.hpp"

namespace isograsp {

/// Turns messages into frames, in the order in which they come.
class LeapDecoder {
 public:
  /// Longest message that is read [bytes]: two hands take 15 kB.
  static constexpr std::size_t kLongestMessage = std::size_t{1} << 18;

  enum class Kind : std::uint8_t {
    frame,    ///< hands were decoded
    notice,   ///< of the service or of a device: nothing to read
    damaged,  ///< no JSON object, or a frame without the numbers that it must have
    late      ///< its time is not above that of the last frame
  };
  /// Of a frame: one entry for each hand in it, and one that is not tracked for a hand that was
  /// there before. Of two hands of one side the first counts.
  [[nodiscard]] Kind take(std::string_view message, std::vector<HandFrame>& hands);
  /// Time of the last frame, since the first one [s].
  [[nodiscard]] double time_s() const noexcept;
  /// How far the last message that was late lay behind [s].
  [[nodiscard]] double late_s() const noexcept { return late_s_; }
  /// The clock of the service began anew: the next frame is the first. Hands stay known.
  void restart() noexcept { first_us_.reset(); }
  /// Version that the service has told; empty: none.
  [[nodiscard]] const std::string& service() const noexcept { return service_; }

 private:
  std::optional<std::int64_t> first_us_;
  std::int64_t last_us_ = 0;
  double late_s_ = 0.0;
  std::string service_;
  std::array<bool, 2> known_{};  ///< sides that were seen
};

}  // namespace isograsp
