// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/resume.hpp"

#include <algorithm>
#include <string_view>

#include "core/time.hpp"
#include "hand/hand_columns.hpp"
#include "hand/platform_records.hpp"
#include "hand/two_hands_columns.hpp"
#include "session/arm/passive_range.hpp"

namespace isograsp::session {

namespace {

Error nothing_to_resume(Text why) {
  return refused("there is nothing to resume: %1"_text(std::move(why)), "begin a new session"_text)
      .about("resume");
}

/// Seconds from one time to another; 0 where a text is no time.
double seconds_between(const std::string& from_utc, const std::string& to_utc) {
  const auto from = time_of_utc(from_utc);
  const auto to = time_of_utc(to_utc);
  return from && to ? static_cast<double>(*to - *from) : 0.0;
}

/// The newest session of the same hand and kind of device, and those it resumes, newest first.
Result<std::vector<storage::SessionRecord>> chain_before(storage::SessionStore& store,
                                                         const storage::SessionRecord& session) {
  const auto sessions = store.sessions(session.patient_id);
  if (!sessions) return sessions.error();
  std::vector<storage::SessionRecord> chain;
  for (auto earlier = sessions->rbegin(); earlier != sessions->rend(); ++earlier) {
    const bool wanted = chain.empty()
                            ? earlier->hand == session.hand &&
                                  earlier->simulated == session.simulated && !earlier->recorded
                            : chain.back().resumes_id == earlier->id;
    if (wanted) chain.push_back(*earlier);
    if (!chain.empty() && !chain.back().resumes_id) break;
  }
  return chain;
}

/// How many objects a tracked hand began to place in a trial.
Result<int> placements_in(storage::SessionStore& store, const storage::TrialRecord& trial) {
  const bool places = std::ranges::any_of(trial.groups, [](const storage::SignalGroup& group) {
    return std::ranges::find(group.columns, std::string_view(columns::placement)) !=
           group.columns.end();
  });
  if (!places) return 0;
  const auto signals = store.signals(trial);
  if (!signals) return signals.error();
  const auto numbers = signals->column(columns::placement);
  return numbers.empty() ? 0 : 1 + static_cast<int>(*std::ranges::max_element(numbers));
}

Result<void> add_trials_of(storage::SessionStore& store, const storage::SessionRecord& earlier,
                           const storage::SessionRecord& session, EarlierWork& work) {
  const auto trials = store.trials(earlier.id);
  if (!trials) return trials.error();
  work.trials_made += trials->size();
  const double began_s = -seconds_between(earlier.started_utc, session.started_utc);
  for (const storage::TrialRecord& trial : *trials) {
    if (const auto spec = tasks::parse_task(trial.task_text, trial.task_name))
      work.carries.add(*spec);
    const auto placements = placements_in(store, trial);
    if (!placements) return placements.error();
    work.placements += *placements;
    if (trial.status != storage::TrialStatus::completed || !trial.place) continue;
    auto measures = store.measures(trial.id);
    if (!measures) return measures.error();
    const double lasted_s = static_cast<double>(trial.samples) / earlier.rate_Hz;
    const double ended_s = std::min(0.0, began_s + trial.session_time_s + lasted_s);
    work.trials.push_back({trial, *std::move(measures), ended_s, lasted_s});
  }
  return {};
}

}  // namespace

Result<EarlierWork> read_earlier_work(storage::SessionStore& store,
                                      const storage::SessionRecord& session) {
  const auto chain = chain_before(store, session);
  if (!chain) return chain.error();
  if (chain->empty()) return nothing_to_resume("this hand has had no session yet"_text);
  const storage::SessionRecord& last = chain->front();
  if (last.protocol_text != session.protocol_text)
    return nothing_to_resume(
        "the last session of this hand followed the protocol '%1', or another version of this one"_text(
            last.protocol_name));
  if (seconds_between(last.started_utc, session.started_utc) > kLongestBreak_s)
    return nothing_to_resume("the last session of this hand began more than four hours ago"_text);
  EarlierWork work;
  work.first_id = chain->back().id;
  work.last_id = last.id;
  work.allowed = last.allowed;
  work.ceiling_N = storage::value_of(last.references, platform::kCeiling_N);
  for (const Hand hand : kBothHands)
    work.ceilings_N[hand] = storage::value_of(last.references, platform::kCeilings_N[hand]);
  if (const auto side = storage::value_of(last.references, columns::affected_hand))
    work.affected = *side == 0.0 ? Hand::left : Hand::right;
  const auto answers = store.answers(last.id);
  if (!answers) return answers.error();
  auto passive = passive_limits_in(*answers);
  if (!passive) return passive.error();
  work.passive = *std::move(passive);
  for (auto earlier = chain->rbegin(); earlier != chain->rend(); ++earlier)
    if (auto added = add_trials_of(store, *earlier, session, work); !added) return added.error();
  const auto protocol = tasks::parse_protocol(session.protocol_text, session.protocol_name);
  if (!protocol) return protocol.error();
  tasks::Agenda agenda(*protocol, order_seed(session, work));
  tell(agenda, *protocol, work);
  if (!agenda.next()) return nothing_to_resume("the last session finished its protocol"_text);
  return work;
}

void tell(tasks::Agenda& agenda, const tasks::ProtocolSpec& protocol, const EarlierWork& earlier) {
  auto next = earlier.trials.begin();
  double ended_s = next == earlier.trials.end() ? 0.0 : next->ended_s;
  while (next != earlier.trials.end()) {
    const auto item = agenda.next();
    if (!item) return;
    const tasks::ProtocolStep& step = protocol.steps[item->step];
    tasks::Agenda::Outcome outcome;
    if (step.kind == tasks::ProtocolStep::Kind::task) {
      const storage::TrialPlace place{static_cast<int>(item->step), static_cast<int>(item->task)};
      outcome.completed = next->record.place == place;
      if (outcome.completed) {
        ended_s = next->ended_s;
        outcome.worked_s = next->lasted_s;
        if (!next->record.helped) outcome.agreeing = tasks::agreeing(step, next->measures);
        ++next;
      }
    }
    outcome.ended_s = ended_s;
    agenda.record(outcome);
  }
}

std::uint64_t order_seed(const storage::SessionRecord& session, const EarlierWork& earlier) {
  if (session.seed != 0) return session.seed;
  return static_cast<std::uint64_t>(earlier.first_id.value_or(session.id));
}

std::optional<Text> reason_to_stop(const std::vector<storage::RatingRecord>& ratings) {
  constexpr int kMostOfScale = 10;
  constexpr int kMostPain = 4;  // at this work stops
  constexpr int kMostRise = 2;  // since the first rating of the session
  if (ratings.empty()) return std::nullopt;
  const storage::RatingRecord& first = ratings.front();
  const storage::RatingRecord& last = ratings.back();
  if (last.pain >= kMostPain)
    return "Pain %1 of %2: stop the work of this hand for today."_text(last.pain, kMostOfScale);
  if (last.pain - first.pain >= kMostRise)
    return "Pain %1 of %2, %3 more than at first: stop the work of this hand for today."_text(
        last.pain, kMostOfScale, last.pain - first.pain);
  if (!last.shoulder_pain) return std::nullopt;
  const int shoulder = *last.shoulder_pain;
  const int rise = shoulder - first.shoulder_pain.value_or(shoulder);
  if (shoulder >= kMostPain)
    return "Shoulder pain %1 of %2: stop the work of this hand for today."_text(shoulder,
                                                                                kMostOfScale);
  if (rise >= kMostRise)
    return "Shoulder pain %1 of %2, %3 more than at first: stop the work of this hand for today."_text(
        shoulder, kMostOfScale, rise);
  return std::nullopt;
}

}  // namespace isograsp::session
