// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: divides a trial into the parts of its timeline, and collects its measures.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hand/columns.hpp"
#include "hand/force_channel.hpp"
#include "statistics/samples.hpp"
#include "tasks/measures/coordination/digits.hpp"
#include "tasks/measures/coordination/synergy.hpp"
#include "tasks/record.hpp"

namespace isograsp::tasks {

/// Rows [first, last) of one segment of the timeline, pauses within it included.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
  Phase phase = Phase::active;
  Cue cue = Cue::relax;
  ForceChannel channel;
};
/// In the order of time, without the row of phase `done` that ends a trial. Without a column
/// `segment` the rows of one phase after the other are the parts, of the grip.
[[nodiscard]] std::vector<Part> parts_of(const Record& record);

/// When the part's last row that is not paused ends, in task time [s]. @pre the part has rows
[[nodiscard]] double end_of(const Record& record, const Part& part);

/// The force of the channel over some rows, without those that do not count.
struct Trace {
  Section section;
  std::vector<double> t_s;  ///< task time
  std::vector<double> force_N;
  std::vector<double> target_N;  ///< empty unless asked for
  std::vector<double> weight_s;
  [[nodiscard]] bool empty() const noexcept { return t_s.empty(); }
};
[[nodiscard]] Trace trace_of(const Record& record, std::size_t first, std::size_t last,
                             bool with_target = false);
/// The rows of `parts` one after the other; t_s runs on.
[[nodiscard]] Section join(std::span<const Section> sections);

/// Normal forces fz of the three digits over the rows in which all are known.
struct NormalForces {
  Section section;
  std::array<std::vector<double>, kFingerCount> force_N;
  [[nodiscard]] DigitForces view() const;
  [[nodiscard]] PerDigit mean() const;  ///< 0 without rows
};
[[nodiscard]] NormalForces normal_forces(const Record& record, std::size_t first, std::size_t last,
                                         std::initializer_list<Phase> phases = {});

/// The vector columns PREFIX_fx_N … of one digit, or of its target, over some rows.
struct Vectors {
  Section section;
  std::vector<Vec3> force_N;
};
[[nodiscard]] Vectors vectors_of(const Record& record, std::size_t first, std::size_t last,
                                 const columns::OfAxes& axes);

/// Value of a column in the first row of the part in which it is known; NaN: nowhere.
[[nodiscard]] double known_in(const Record& record, const Part& part, std::string_view column);

/// Kaplan-Meier median of times of which some are longer than `limit_s`.
[[nodiscard]] statistics::Computed median_time(std::span<const statistics::EventTime> each,
                                               double limit_s);

/// Mean over repetitions of those that have a value; the first reason, or `none`, if none has.
[[nodiscard]] statistics::Computed mean_of_repetitions(std::span<const statistics::Computed> each,
                                                       Words none = "there was no repetition"_text);

/// Collects the measures of a trial.
class MeasureList {
 public:
  void add(std::string name, std::string channel, std::string unit, const Section& section,
           statistics::Computed computed);
  /// mean_of_repetitions().
  void add_mean(std::string name, const std::string& channel, std::string unit,
                const Section& section, std::span<const statistics::Computed> each);
  /// Times that may be censored: NAME (median, Kaplan-Meier), NAME_restricted (mean up to
  /// limit_s), NAME_share (% of the repetitions in which the event came).
  void add_times(const std::string& name, const std::string& channel, const Section& section,
                 std::span<const statistics::EventTime> each, double limit_s);
  [[nodiscard]] std::vector<Measure> take() { return std::move(measures_); }

 private:
  std::vector<Measure> measures_;
};

/// Net push of arm or trunk over the active rows, where digits press against each other: a single
/// digit always pushes the platform.
void add_net_push(const Record& record, ForceChannel channel, MeasureList& list);

/// Shares of the digits in their sum, and the thumb against the fingers, over the active rows,
/// where all three press together.
void add_sharing(const Record& record, ForceChannel channel, MeasureList& list);

/// The hardest effort in % of the maximum of the session, where that is known: above 110 % that was
/// no maximum.
void add_force_of_maximum(const Record& record, ForceChannel channel, MeasureList& list);

/// synergy_index and the two variances behind it.
void add_synergy(const CycleSynergy& found, const Section& section, MeasureList& list);

}  // namespace isograsp::tasks
