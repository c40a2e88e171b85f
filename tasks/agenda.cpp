// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/agenda.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/random.hpp"
#include "tasks/attempts.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::uint64_t kOrderStream = 210;
/// A task whose clock stands still would otherwise be asked without end.
constexpr int kMostAttemptsInBouts = 200;

/// Every task `repetitions` times.
std::vector<std::size_t> planned(const ProtocolStep& step, std::uint64_t seed) {
  if (step.kind != ProtocolStep::Kind::task) return {0};
  std::vector<std::size_t> order;
  const auto repetitions = static_cast<std::size_t>(step.repetitions);
  for (std::size_t k = 0; k < step.tasks.size() * repetitions; ++k)
    order.push_back(step.order == Order::ordered ? k / repetitions : k % step.tasks.size());
  if (step.order == Order::random) {  // Fisher-Yates, the same in every build
    Random random(seed, kOrderStream);
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1],
                order[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  }
  return order;
}

}  // namespace

std::optional<double> agreeing(const ProtocolStep& step, const std::vector<Measure>& measures) {
  if (!step.agreement) return std::nullopt;
  for (const Measure& measure : measures)
    if (measure.name == step.agreement->measure) return measure.value;
  return std::nullopt;
}

Agenda::Agenda(const ProtocolSpec& protocol, std::uint64_t seed)
    : protocol_(protocol), seed_(seed) {
  enter_step();
}

void Agenda::enter_step() {
  place_ = 0;
  order_.clear();
  if (step_ == protocol_.steps.size()) return;
  const ProtocolStep& step = protocol_.steps[step_];
  order_ = planned(step, seed_ + step_);
  values_.assign(std::max<std::size_t>(1, step.tasks.size()), {});
  attempts_.assign(values_.size(), 0);
  given_up_.assign(values_.size(), false);
  worked_s_.assign(values_.size(), 0.0);
  bout_worked_s_ = 0.0;
}

std::optional<Agenda::Item> Agenda::next() const {
  if (step_ == protocol_.steps.size()) return std::nullopt;
  const ProtocolStep& step = protocol_.steps[step_];
  Item item{step_, order_[place_], 1, rest_until_s_};
  item.attempt = attempts_[item.task] + 1;
  if (step.kind != ProtocolStep::Kind::task) return item;
  const auto before = ended_s_.find(step.tasks[item.task]);
  if (before != ended_s_.end())
    item.not_before_s = std::max(item.not_before_s, before->second + step.recurrence_s);
  return item;
}

void Agenda::record(const Outcome& outcome) {
  const ProtocolStep& step = protocol_.steps[step_];
  const std::size_t task = order_[place_];
  ++done_;
  ++attempts_[task];
  if (outcome.completed && outcome.agreeing) values_[task].push_back(*outcome.agreeing);
  if (step.kind == ProtocolStep::Kind::task) ended_s_[step.tasks[task]] = outcome.ended_s;
  worked_s_[task] += outcome.worked_s;
  rest_until_s_ = outcome.completed ? outcome.ended_s + rest_after(outcome) : rest_until_s_;
  ++place_;
  if (!outcome.completed) give_up(task);
  if (place_ == order_.size()) plan_more();
  if (place_ < order_.size()) return;
  ++step_;
  enter_step();
}

void Agenda::give_up(std::size_t task) {
  given_up_[task] = true;
  order_.erase(
      std::remove(order_.begin() + static_cast<std::ptrdiff_t>(place_), order_.end(), task),
      order_.end());
}

double Agenda::rest_after(const Outcome& outcome) {
  const ProtocolStep& step = protocol_.steps[step_];
  if (!step.bouts) return step.rest_s;
  bout_worked_s_ += outcome.worked_s;
  if (bout_worked_s_ < step.bouts->bout_s) return step.rest_s;
  bout_worked_s_ = 0.0;
  return step.bouts->rest_s;
}

bool Agenda::has_to_go_on(std::size_t task) const {
  const ProtocolStep& step = protocol_.steps[step_];
  if (given_up_[task]) return false;
  if (step.bouts)
    return worked_s_[task] < step.bouts->work_s && attempts_[task] < kMostAttemptsInBouts;
  return step.agreement && attempts_[task] < step.agreement->most_repetitions &&
         !attempts_agree(values_[task], step.agreement->percent,
                         step.practice ? Compared::last_two : Compared::best_two);
}

void Agenda::plan_more() {
  for (std::size_t task = 0; task < protocol_.steps[step_].tasks.size(); ++task)
    if (has_to_go_on(task)) order_.push_back(task);
}

int Agenda::expected() const {
  int count = done_ + static_cast<int>(order_.size() - place_);
  for (std::size_t i = step_ + 1; i < protocol_.steps.size(); ++i)
    count += static_cast<int>(planned(protocol_.steps[i], seed_).size());
  return count;
}

namespace {

/// Hand out, one second of quiet, hand in again; or an arm that finds its start posture.
constexpr double kPreparation_s = 15.0;
double time_of(const ProtocolSpec& protocol, const std::vector<std::vector<TaskSpec>>& tasks,
               bool worst) {
  Agenda agenda(protocol, 0);
  std::set<std::string> instructed;
  double now_s = 0.0;
  int attempt = 0;
  while (const auto item = agenda.next()) {
    const ProtocolStep& step = protocol.steps[item->step];
    double worked_s = 0.0;
    now_s = std::max(now_s, item->not_before_s);
    if (step.prepares()) {
      now_s += kPreparation_s;
    } else if (step.kind == ProtocolStep::Kind::pause) {
      now_s += step.duration_s;
    } else {
      const Duration duration = tasks[item->step][item->task].duration();
      if (instructed.insert(step.tasks[item->task]).second) now_s += kInstruction_s;
      worked_s = worst ? duration.worst_s : duration.nominal_s;
      now_s += worked_s;
    }
    // Attempts that grow tenfold never agree; equal ones do at once.
    agenda.record({true, worst ? std::pow(10.0, ++attempt) : 1.0, now_s, worked_s});
  }
  return now_s;
}

}  // namespace

Duration duration_of(const ProtocolSpec& protocol,
                     const std::vector<std::vector<TaskSpec>>& tasks) {
  return {time_of(protocol, tasks, false), time_of(protocol, tasks, true)};
}

}  // namespace isograsp::tasks
