// SPDX-License-Identifier: GPL-3.0-or-later
// What comes next in a protocol, decided from the outcomes of the steps before. Pure: the same
// protocol, seed and outcomes give the same next step, so that an interrupted session can be
// continued by repeating its outcomes to a new agenda.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/measure.hpp"
#include "tasks/protocol.hpp"

namespace isograsp::tasks {

class Agenda {
 public:
  /// One act of the protocol.
  struct Item {
    std::size_t step = 0;       ///< of the protocol
    std::size_t task = 0;       ///< of the step
    int attempt = 1;            ///< at this task within the step
    double not_before_s = 0.0;  ///< session time: rests and recurrences end then
  };
  struct Outcome {
    bool completed = true;           ///< false: the task was refused for this hand
    std::optional<double> agreeing;  ///< the measure on which attempts must agree
    double ended_s = 0.0;            ///< session time
    double worked_s = 0.0;           ///< on the task's clock
  };

  /// Refers to `protocol`, which must outlive it.
  Agenda(const ProtocolSpec& protocol, std::uint64_t seed);

  /// Nothing: the protocol is over.
  [[nodiscard]] std::optional<Item> next() const;
  /// What came of next().
  void record(const Outcome& outcome);

  [[nodiscard]] int done() const noexcept { return done_; }
  /// Acts of the whole protocol if all further attempts agree at once.
  [[nodiscard]] int expected() const;

 private:
  void enter_step();
  void plan_more();
  [[nodiscard]] bool has_to_go_on(std::size_t task) const;
  [[nodiscard]] double rest_after(const Outcome& outcome);
  /// Asking a refused task again is of no use.
  void give_up(std::size_t task);

  const ProtocolSpec& protocol_;
  std::uint64_t seed_;
  std::size_t step_ = 0;
  std::vector<std::size_t> order_;           ///< tasks of this step, attempt by attempt
  std::size_t place_ = 0;                    ///< in order_
  std::vector<std::vector<double>> values_;  ///< per task of this step: agreeing measures
  std::vector<int> attempts_;                ///< per task of this step
  std::vector<bool> given_up_;               ///< per task of this step
  std::vector<double> worked_s_;             ///< per task of this step
  double bout_worked_s_ = 0.0;               ///< since the hand rested last between bouts
  std::map<std::string, double> ended_s_;    ///< per task file
  double rest_until_s_ = 0.0;
  int done_ = 0;
};

/// The value among the measures of a trial on which attempts at this step must agree.
[[nodiscard]] std::optional<double> agreeing(const ProtocolStep& step,
                                             const std::vector<Measure>& measures);

/// For an instruction in plain words before the first trial of every task [s]: 70 s for the twelve
/// tasks of the battery.
inline constexpr double kInstruction_s = 6.0;

/// Nominal and worst duration of a protocol [s], rests, zeros and instructions included: nominal if
/// attempts agree at once. `tasks[i]`: the tasks of step i.
[[nodiscard]] Duration duration_of(const ProtocolSpec& protocol,
                                   const std::vector<std::vector<TaskSpec>>& tasks);

}  // namespace isograsp::tasks
