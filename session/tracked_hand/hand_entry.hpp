// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of a session with a tracked hand: is it seen well enough at rest, and does it open? A
// hand that only closes is for the isometric tasks. Pure: no clock, no allocation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/text.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp::session {

/// From the tip of the thumb to that of the index [m]; NaN: a tip is not given.
[[nodiscard]] double thumb_index_gap(const HandFrame& hand) noexcept;

class HandEntry {
 public:
  static constexpr double kRest_s = 10.0;           ///< the hand lies still
  static constexpr double kLeastTracked = 0.9;      ///< share of that time in which it is seen
  static constexpr int kOpenings = 3;               ///< asked for: open and close
  static constexpr double kLeastOpening_m = 0.03;   ///< largest gap of thumb and index
  static constexpr double kLargestOfOpening = 0.7;  ///< of the opening: no wider object is offered
  /// A gap counts if it stands this long: one wrong frame is no opening [s].
  static constexpr double kStands_s = 0.1;
  /// A gap that grows, or shrinks, by this much is a movement [m].
  static constexpr double kMovement_m = 0.01;
  /// Without three openings in this time the test ends with those that there were [s].
  static constexpr double kLongest_s = 40.0;

  enum class Stage : std::uint8_t { rest, openings, ended };
  enum class Refusal : std::uint8_t {
    none,
    badly_tracked,  ///< the tracker loses it at rest
    opens_little    ///< the isometric opening tasks are for it
  };

  explicit HandEntry(double period_s) noexcept;
  /// One frame; `tracked` false: the hand is not seen. True: the test has ended. Real-time safe.
  bool add(bool tracked, double gap_m) noexcept;

  [[nodiscard]] Stage stage() const noexcept { return stage_; }
  [[nodiscard]] Refusal refusal() const noexcept { return refusal_; }
  [[nodiscard]] int openings() const noexcept { return openings_; }
  /// Since this stage began [s].
  [[nodiscard]] double stage_s() const noexcept { return static_cast<double>(frames_) * period_s_; }
  /// 0 … 1, of the time at rest.
  [[nodiscard]] double tracked_share() const noexcept;
  /// Largest gap that stood [m].
  [[nodiscard]] double opening_m() const noexcept { return opening_m_; }
  [[nodiscard]] double widest_object_m() const noexcept { return kLargestOfOpening * opening_m_; }

 private:
  static constexpr std::size_t kMostStanding = 32;

  void open(double gap_m) noexcept;
  void end() noexcept;

  double period_s_;
  Stage stage_ = Stage::rest;
  Refusal refusal_ = Refusal::none;
  std::int64_t frames_ = 0;  ///< of this stage
  std::int64_t rest_frames_ = 0;
  std::int64_t seen_ = 0;  ///< at rest
  int openings_ = 0;
  double opening_m_ = 0.0;
  std::array<double, kMostStanding> last_m_{};  ///< the newest gaps, in a ring
  std::size_t standing_;                        ///< frames of kStands_s
  std::size_t known_ = 0;                       ///< of these, on end
  std::size_t next_ = 0;
  std::optional<double> least_m_, most_m_;  ///< since the last change of direction
  bool opening_ = false;
};

/// Why the hand is not for these tasks, and what is.
[[nodiscard]] Words words_of(HandEntry::Refusal refusal) noexcept;

}  // namespace isograsp::session
