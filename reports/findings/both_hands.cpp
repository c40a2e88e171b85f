// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/both_hands.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "hand/two_hands_columns.hpp"
#include "reports/findings/comparable.hpp"
#include "tasks/kinds/two_hands/bilateral_tracking.hpp"

namespace isograsp::reports {

namespace {

using Trials = std::vector<const StoredTrial*>;

/// Of the trials of a session that have a value of this measure; nothing: none has.
std::optional<double> mean_of(const Trials& trials, std::string_view name,
                              std::string_view channel) {
  double sum = 0.0;
  int count = 0;
  for (const StoredTrial* trial : trials)
    for (const Measure& measure : trial->measures)
      if (measure.name == name && measure.channel == channel && measure.value) {
        sum += *measure.value;
        ++count;
      }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// As its session had it; nothing: it was not known.
std::optional<Hand> affected_in(const Trials& trials) {
  const auto side =
      storage::value_of(trials.front()->session_record->references, columns::affected_hand);
  if (!side) return std::nullopt;
  return *side == 0.0 ? Hand::left : Hand::right;
}

/// Of the maxima that the trials were made with, in per cent.
std::optional<double> capacity_share(const Trials& trials, Hand affected) {
  double sum = 0.0;
  for (const StoredTrial* trial : trials) {
    const auto own =
        storage::value_of(trial->trial.references, columns::hand_maximum_force_N[affected]);
    const auto other = storage::value_of(trial->trial.references,
                                         columns::hand_maximum_force_N[other_than(affected)]);
    if (!own || !other || !(*own + *other > 0.0)) return std::nullopt;
    sum += 100.0 * *own / (*own + *other);
  }
  return sum / static_cast<double>(trials.size());
}

HandsShared shared_in(const TaskSection& section, std::size_t session, const Trials& trials) {
  HandsShared row;
  row.session = session;
  row.task = section.task;
  for (const Hand hand : kBothHands)
    row.above_rest_N[hand] = mean_of(trials, "force_above_rest", name_of(hand));
  row.affected = affected_in(trials);
  if (!row.affected) return row;
  const std::string_view side = name_of(*row.affected);
  row.share_percent = mean_of(trials, "share_affected", side);
  row.effort_percent = mean_of(trials, "effort_share_affected", side);
  row.capacity_percent = capacity_share(trials, *row.affected);
  row.lag_s = mean_of(trials, "hand_lag", side);
  row.synergy = mean_of(trials, "hand_synergy", side);
  return row;
}

HandsMoved moved_in(const TaskSection& section, std::size_t session, const Trials& trials) {
  HandsMoved row;
  row.session = session;
  row.task = section.task;
  row.carry = section.spec->hands_carry();
  for (const StoredTrial* trial : trials)
    for (const Measure& measure : trial->measures) {
      if (measure.name == "targets_reached" && measure.value)
        row.done += static_cast<int>(*measure.value);
      if (measure.name == "drops" && measure.value) row.drops += static_cast<int>(*measure.value);
    }
  row.asked = section.spec->repetitions() * static_cast<int>(trials.size());
  row.time_s = mean_of(trials, "restricted_mean_time", "targets");
  row.tilt_rad = mean_of(trials, "object_tilt", "angle");
  if (const auto side = affected_in(trials))
    row.raise_percent = mean_of(trials, "raise_share_affected", name_of(*side));
  return row;
}

}  // namespace

void add_both_hands(const TaskSection& section, const std::vector<const StoredTrial*>& all,
                    BothHands& both) {
  if (!section.spec || section.hand) return;
  const auto* tracking = section.spec->kind.get_if<tasks::BilateralTrackingSpec>();
  const bool shares =
      tracking != nullptr && tracking->goal == tasks::BilateralTrackingSpec::Goal::sum;
  const bool moves = section.spec->hands_load() || section.spec->hands_carry();
  if (!shares && !moves) return;
  std::map<std::size_t, Trials> sessions;
  for (const StoredTrial* trial : all)
    if (counts(trial->trial) && difference(*trial, *all.back()).empty())
      sessions[trial->session].push_back(trial);
  for (const auto& [session, trials] : sessions) {
    if (shares) both.shared.push_back(shared_in(section, session, trials));
    if (moves) both.moved.push_back(moved_in(section, session, trials));
  }
}

void finish_both_hands(BothHands& both) {
  const auto newest = std::max_element(
      both.shared.begin(), both.shared.end(),
      [](const HandsShared& a, const HandsShared& b) { return a.session < b.session; });
  if (newest != both.shared.end()) {
    const std::string task = newest->task;
    std::set<std::string> others;
    for (const HandsShared& row : both.shared)
      if (row.task != task) others.insert(row.task);
    both.other_tasks.assign(others.begin(), others.end());
    std::erase_if(both.shared, [&](const HandsShared& row) { return row.task != task; });
  }
  std::sort(both.shared.begin(), both.shared.end(),
            [](const HandsShared& a, const HandsShared& b) { return a.session < b.session; });
  std::stable_sort(both.moved.begin(), both.moved.end(),
                   [](const HandsMoved& a, const HandsMoved& b) { return a.session < b.session; });
}

}  // namespace isograsp::reports
