// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded hands frame by frame, and what an emulated tracker shows of them, with faults on
// purpose. No socket and no real clock. The same seed gives the same frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/result.hpp"
#include "device/hand/hand_fault.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp {

/// The rows of one time.
struct HandShot {
  double t_s = 0.0;
  std::size_t first = 0;  ///< in HandPlay::hands
  std::size_t count = 0;
};

struct HandPlay {
  std::vector<HandFrame> hands;  ///< t_s from 0
  std::vector<HandShot> shots;   ///< t_s from 0, increasing
  double period_s = 0.01;
  bool repeat = false;

  [[nodiscard]] std::span<const HandFrame> hands_of(const HandShot& shot) const noexcept {
    return std::span(hands).subspan(shot.first, shot.count);
  }
  /// Errors name the file: also times that do not increase from hand to hand, fewer than two.
  [[nodiscard]] static Result<HandPlay> read(const std::string& path);
  /// @pre times do not decrease, and two of them differ
  [[nodiscard]] static HandPlay of(std::vector<HandFrame> hands);
};

/// What was done.
struct HandSceneCounters {
  std::uint64_t frames = 0;     ///< made
  std::uint64_t dropped = 0;    ///< lost by a fault
  std::uint64_t silent = 0;     ///< not sent in a silence
  std::uint64_t malformed = 0;  ///< broken off
};

/// One frame, with all faults in it.
struct HandPicture {
  std::int64_t frame = 0;  ///< from 1 on
  double stamp_s = 0.0;    ///< on the tracker's clock
  double play_s = 0.0;     ///< since the play began
  bool sent = true;        ///< false: nobody gets it
  bool cut = false;        ///< it breaks off
  std::vector<HandFrame> hands;
};

/// The part of a message that comes where it breaks off.
[[nodiscard]] inline std::string cut_off(std::string message) {
  message.resize(message.size() / 2);
  return message;
}

class HandScene {
 public:
  HandScene(HandPlay play, std::vector<EmulatedHandFault> faults, std::uint64_t seed);

  /// When the next frame is due, since the play began; nothing: the play is over.
  [[nodiscard]] std::optional<double> next_s() const noexcept;
  /// @pre next_s()
  [[nodiscard]] HandPicture take();
  [[nodiscard]] double rate_Hz() const noexcept { return 1.0 / play_.period_s; }
  [[nodiscard]] const std::vector<EmulatedHandFault>& faults() const noexcept { return faults_; }
  [[nodiscard]] const HandSceneCounters& counters() const noexcept { return counters_; }

 private:
  void apply(const EmulatedHandFault& fault, HandPicture& picture);

  HandPlay play_;
  std::vector<EmulatedHandFault> faults_;
  Random random_;
  std::vector<std::optional<std::vector<HandFrame>>> frozen_;  ///< of each fault
  std::vector<HandFrame> last_;
  std::size_t shot_ = 0;
  double round_s_ = 0.0;  ///< when this round of the play began
  HandSceneCounters counters_;
};

}  // namespace isograsp
