// SPDX-License-Identifier: GPL-3.0-or-later
// A stored trial at any instant: what the fingers pressed, what was asked, where the object was.
// No value is invented: between two measured samples the value is linear; a held sample is called
// held; where samples are missing or were not recorded there is no value. SI units.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "hand/finger.hpp"
#include "tasks/task.hpp"

namespace isograsp::gui {

enum class SampleQuality : std::uint8_t {
  measured,
  held,    ///< the last valid sample stands in
  missing  ///< no sample, or none was recorded at this time
};

struct ReplayFinger {
  SampleQuality quality = SampleQuality::missing;
  Vec3 force_C = Vec3::Zero();  ///< contact frame, pressing is +z [N]; zero if missing
  bool touching = false;
  bool beyond_range = false;  ///< saturated or overloaded
};

struct ReplayState {
  double t_s = 0.0;                                ///< on the trial's own clock
  SampleQuality quality = SampleQuality::missing;  ///< the worst of the fingers
  tasks::Phase phase = tasks::Phase::lead_in;
  std::array<ReplayFinger, kFingerCount> fingers{};
  std::optional<double> actual_N;  ///< of the channel that the task is about
  std::optional<double> target_N;
  std::optional<Pose> X_WO;
  std::optional<Pose> X_WT;
  int target_index = -1;
  int targets_reached = 0;
  int drops = 0;
};

class TrialReplay {
 public:
  TrialReplay() = default;  ///< rows() is 0 and at() has nothing
  /// Errors: bad_input without `t_s`, or if its times do not increase.
  [[nodiscard]] static Result<TrialReplay> make(Signals signals);

  [[nodiscard]] std::size_t rows() const noexcept { return signals_.rows(); }
  [[nodiscard]] const Signals& signals() const noexcept { return signals_; }
  [[nodiscard]] double begin_s() const noexcept;
  [[nodiscard]] double end_s() const noexcept;                          ///< of the last sample
  [[nodiscard]] double period_s() const noexcept { return period_s_; }  ///< median step
  [[nodiscard]] bool has_fingers() const noexcept;
  [[nodiscard]] bool has_object() const noexcept;

  /// `t_s` outside the trial counts as its nearer end, NaN as its begin.
  [[nodiscard]] ReplayState at(double t_s) const;
  /// The last row at or before `t_s`, clamped as above. @pre rows() > 0
  [[nodiscard]] std::size_t row_at(double t_s) const noexcept;
  /// No row was recorded for some time after this one.
  [[nodiscard]] bool gap_after(std::size_t row) const noexcept;
  [[nodiscard]] SampleQuality quality(std::size_t row) const noexcept;  ///< worst of the fingers
  [[nodiscard]] SampleQuality quality(std::size_t row, Finger finger) const noexcept;

  /// Where the object was, thinned to steps of `least_step_m` and more; a NaN point ends a stretch
  /// that no recorded path joins to the next one.
  [[nodiscard]] std::vector<Vec3> path(double least_step_m) const;

 private:
  /// Of the signals; nothing: they have none.
  using Place = std::optional<std::size_t>;
  struct PoseColumns {
    std::array<Place, 3> place_m{};
    std::array<Place, 4> quaternion{};  ///< w x y z
    Place angle_rad;
  };
  /// Columns are looked up once: a trial has tens of thousands of rows.
  struct Columns {
    std::size_t t_s = 0;
    Place phase, flags, actual_N, target_N, target_index, targets_reached, drops;
    std::array<std::array<Place, 3>, kFingerCount> force_N{};
    std::array<Place, kFingerCount> finger_flags{};
    std::array<Place, kFingerCount> contact{};
    PoseColumns object, target;
  };
  [[nodiscard]] double value(Place column, std::size_t row) const;
  [[nodiscard]] double between(Place column, std::size_t row, double share) const;
  [[nodiscard]] std::optional<Pose> pose(const PoseColumns& columns, std::size_t row) const;
  [[nodiscard]] ReplayFinger finger_at(std::size_t f, std::size_t row, double share) const;
  [[nodiscard]] bool object_moves_on(std::size_t row) const;
  [[nodiscard]] std::optional<Pose> object_between(std::size_t row, double share) const;

  Columns columns_;
  Signals signals_;
  double period_s_ = 0.0;
};

/// Position of the replay: it runs at a speed, stands still or is moved. It reads no clock.
class Playback {
 public:
  static constexpr std::array<double, 5> kSpeeds{0.25, 0.5, 1.0, 2.0, 4.0};

  Playback() = default;
  Playback(double begin_s, double end_s) : begin_s_(begin_s), end_s_(end_s), t_s_(begin_s) {}

  [[nodiscard]] double t_s() const noexcept { return t_s_; }
  [[nodiscard]] bool playing() const noexcept { return playing_; }
  [[nodiscard]] double speed() const noexcept { return speed_; }
  void set_speed(double speed) noexcept { speed_ = speed; }
  /// Plays, from the begin if the end was reached; or pauses.
  void toggle() noexcept;
  void pause() noexcept { playing_ = false; }
  void seek(double t_s) noexcept;  ///< clamped to the trial; goes on playing if it was
  /// `real_s` have passed outside; stands at the end.
  void advance(double real_s) noexcept;

 private:
  double begin_s_ = 0.0;
  double end_s_ = 0.0;
  double t_s_ = 0.0;
  double speed_ = 1.0;
  bool playing_ = false;
};

}  // namespace isograsp::gui
