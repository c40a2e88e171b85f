// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recorder.hpp"

#include <cmath>

#include "core/column.hpp"
#include "core/csv.hpp"
#include "session/resting.hpp"
#include "tasks/score.hpp"

namespace isograsp::session {

Recorder::Recorder(std::unique_ptr<SessionWriter> writer, const storage::SessionRecord& session,
                   Ring<RecordItem>& records, bool live_score)
    : store_(std::move(writer)),
      session_(session),
      rows_per_block_(static_cast<std::size_t>(std::lround(session.rate_Hz))),
      records_(records),
      live_score_wanted_(live_score) {}

bool Recorder::pump() {
  while (records_.pop(item_)) take(item_);
  take_remarks();
  return !finished_;
}

void Recorder::look() {
  stored(store_->look());
  if (basis_in_ && !store_->camera_is_allowed())
    stored(failed("the lawful basis for a camera that sees this person was withdrawn: it is not "
                  "looked at any longer, and what was measured before is stored"_text,
                  "speak with the person; a new session needs a basis on record"_text)
               .at(*basis_in_)
               .about("consent"));
}

void Recorder::take_remarks() {
  std::vector<storage::EventRecord> events;
  std::vector<Rating> ratings;
  std::vector<storage::SessionAnswer> answers;
  std::vector<std::pair<storage::RowId, bool>> helped;
  {
    const std::lock_guard lock(mutex_);
    events.swap(events_);
    ratings.swap(ratings_);
    answers.swap(answers_);
    helped.swap(helped_);
  }
  for (auto& event : events) {
    if (!event.trial_id) event.trial_id = trial_id_;
    stored(store_->add_event(event));
  }
  for (const auto& rating : ratings) take_rating(rating.record, rating.corrects);
  if (!answers.empty()) stored(store_->add_answers(answers));
  for (const auto& [trial, mark] : helped) stored(store_->mark_helped(trial, mark));
}

void Recorder::take_rating(storage::RatingRecord rating, bool corrects) {
  rating.session_id = session_.id;
  if (corrects) {
    rating.id = last_rating_id_;
    stored(store_->correct_rating(rating));
    return;
  }
  rating.trial_id = last_trial_id_;
  rating.recorded_utc = utc_at(rating.session_time_s);
  stored(store_->add_rating(rating, last_rating_id_));
}

void Recorder::take(const RecordItem& item) {
  switch (item.kind) {
    case RecordItem::Kind::begin: begin(*item.setup); break;
    case RecordItem::Kind::sample: add_row(item.row.values()); break;
    case RecordItem::Kind::end: end(item); break;
    case RecordItem::Kind::prepared: add_preparation(item); break;
    case RecordItem::Kind::finished: finished_ = true; break;
    case RecordItem::Kind::event: add_event(item); break;
  }
}

void Recorder::add_event(const RecordItem& item) {
  const Text words = item.where ? (*item.where)(item.reason) : Text(item.reason);
  if (!item.told_before)
    stored(store_->add_event({trial_id_, item.session_time_s, item.event_kind, english(words)}));
  if (!item.pauses) return;
  SessionNews news;
  news.fault = words;
  publish(std::move(news));
}

void Recorder::begin(TrialSetup& setup) {
  trial_ = &setup;
  second_ = 0;
  samples_ = 0;
  setup.record.session_time_s = item_.session_time_s;
  for (const auto& [kind, id] : in_force_)
    if (id != 0) setup.record.preparations.push_back(id);
  setup.record.groups = setup.columns();
  std::vector<std::string> names;
  for (const auto& group : setup.record.groups)
    names.insert(names.end(), group.columns.begin(), group.columns.end());
  signals_ = Signals(std::move(names));
  block_.assign(setup.record.groups.size(), {});
  if (stored(store_->begin_trial(setup.record, setup.record.id))) trial_id_ = setup.record.id;
}

void Recorder::add_row(std::span<const double> values) {
  auto next = values.begin();
  for (std::size_t g = 0; g < block_.size(); ++g) {
    const auto end = next + static_cast<std::ptrdiff_t>(trial_->record.groups[g].columns.size());
    block_[g].insert(block_[g].end(), next, end);
    next = end;
  }
  signals_.append_row(values);
  ++samples_;
  if (static_cast<std::size_t>(samples_) % rows_per_block_ != 0) return;
  write_block();
  if (!live_score_wanted_) return;
  auto measures = tasks::score(trial_->spec, signals_);
  const std::lock_guard lock(mutex_);
  live_ = std::move(measures);
}

void Recorder::write_block() {
  stored_up_to(trial_->record.session_time_s + static_cast<double>(samples_) / session_.rate_Hz,
               store_->append_blocks(trial_->record.id, second_, block_));
  ++second_;
  for (auto& group : block_) group.clear();
}

void Recorder::end(const RecordItem& item) {
  if (!block_.empty() && !block_.front().empty()) write_block();
  TrialOutcome outcome;
  outcome.trial = trial_->record;
  outcome.trial.status = item.status;
  outcome.trial.samples = samples_;
  outcome.trial.worst_lateness_s = item.worst_lateness_s;
  outcome.trial.worst_compute_s = item.worst_compute_s;
  outcome.trial.dropped = item.dropped;
  outcome.trial.health_json = trial_->health_json();
  outcome.trial.timing_json = as_json(trial_->timing);
  {
    const std::lock_guard lock(mutex_);
    const ScreenShown screen = std::exchange(screen_, {});
    outcome.trial.display_age_s = screen.age_s;
    storage::set_value(outcome.trial.references, platform::kVisualGain_deg_per_N,
                       screen.gain_deg_per_N);
    outcome.trial.viewing_distance_m = screen.distance_m;
  }
  outcome.reason = item.reason;
  outcome.measures = tasks::score(trial_->spec, signals_);
  if (const auto worked_s = signals_.column(columns::task_time_s); !worked_s.empty())
    outcome.worked_s = worked_s.back();
  if (item.status == storage::TrialStatus::aborted)
    stored(store_->add_event({trial_id_, item.session_time_s, "abort", item.reason.english()}));
  stored_up_to(item.session_time_s, store_->end_trial(outcome.trial, outcome.measures));
  if (item.status == storage::TrialStatus::completed && trial_->spec.kind->rests)
    outcome.rest = add_rest(item);
  trial_ = nullptr;
  last_trial_id_ = std::exchange(trial_id_, std::nullopt);
  SessionNews news;
  news.trial = std::move(outcome);
  publish(std::move(news));
}

std::optional<RestOutcome> Recorder::add_rest(const RecordItem& item) {
  const auto rest = resting_force(signals_);
  if (!rest) return std::nullopt;
  RestOutcome outcome;
  outcome.words = words_of(*rest);
  RestRecord& record = outcome.rest;
  record.trial_id = trial_->record.id;
  record.session_time_s = item.session_time_s;
  record.recorded_utc = utc_at(item.session_time_s);
  record.operator_name = session_.operator_name;
  record.duration_s = trial_->spec.duration().nominal_s;
  record.since_strapping_s = trial_->since_strapping_s;
  record.samples = rest->samples;
  record.mean = rest->mean;
  record.sd = rest->sd;
  stored(store_->add_preparation(as_stored(record), record.id));
  return outcome;
}

void Recorder::add_preparation(const RecordItem& item) {
  SessionNews news;
  PreparationOutcome& outcome = news.prepared.emplace(item.preparation->outcome());
  storage::PreparationRecord& record = outcome.record;
  record.session_time_s = item.session_time_s;
  record.recorded_utc = utc_at(item.session_time_s);
  record.operator_name = session_.operator_name;
  if (outcome.accepted) {
    storage::RowId id = 0;
    stored(store_->add_preparation(record, id));
    record.id = in_force_[record.kind] = id;
  }
  // Stored with a blank behind a remark, as it always was.
  const std::string words =
      outcome.accepted ? english(outcome.remark) + " " : english(outcome.reason);
  if (!outcome.remark.empty() || !outcome.accepted)
    stored(store_->add_event({std::nullopt, item.session_time_s,
                              outcome.name + (outcome.accepted ? "" : " refused"), words}));
  publish(std::move(news));
}

std::string Recorder::utc_at(double session_time_s) const {
  const auto started = time_of_utc(session_.started_utc);
  return started ? utc_text(*started + std::lround(session_time_s)) : "";
}

bool Recorder::stored(const Result<void>& result) {
  if (result) return true;
  {
    const std::lock_guard lock(mutex_);
    if (failure_) return false;
    failure_ = result.error();
  }
  SessionNews news;
  news.failure = result.error();
  publish(std::move(news));
  return false;
}

void Recorder::stored_up_to(double session_time_s, const Result<void>& result) {
  if (!stored(result)) return;
  const std::lock_guard lock(mutex_);
  stored_until_s_ = session_time_s;
}

std::string Recorder::stored_until_utc() const {
  const std::lock_guard lock(mutex_);
  return utc_at(std::floor(stored_until_s_));
}

void Recorder::publish(SessionNews news) {
  {
    const std::lock_guard lock(mutex_);
    news_.push_back(std::move(news));
  }
  changed_.notify_all();
}

std::vector<SessionNews> Recorder::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

void Recorder::wait_for_news(double seconds) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [this] { return !news_.empty(); });
}

std::vector<Measure> Recorder::live_score() const {
  const std::lock_guard lock(mutex_);
  return live_;
}

void Recorder::add_event(const storage::EventRecord& event) {
  const std::lock_guard lock(mutex_);
  events_.push_back(event);
}

void Recorder::add_rating(const storage::RatingRecord& rating) {
  const std::lock_guard lock(mutex_);
  ratings_.push_back({rating, false});
}

void Recorder::correct_rating(const storage::RatingRecord& rating) {
  const std::lock_guard lock(mutex_);
  ratings_.push_back({rating, true});
}

void Recorder::add_answers(const std::vector<storage::SessionAnswer>& answers) {
  const std::lock_guard lock(mutex_);
  answers_.insert(answers_.end(), answers.begin(), answers.end());
}

void Recorder::set_screen(const ScreenShown& screen) {
  const std::lock_guard lock(mutex_);
  screen_ = screen;
}

void Recorder::mark_helped(storage::RowId trial, bool helped) {
  const std::lock_guard lock(mutex_);
  helped_.emplace_back(trial, helped);
}

void Recorder::end_session(std::optional<double> session_time_s) {
  stored(store_->end_session(session_time_s ? utc_at(*session_time_s) : ""));
}

std::optional<Error> Recorder::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

}  // namespace isograsp::session
