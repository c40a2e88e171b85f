// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_writer.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "storage/access/open_store.hpp"
#include "storage/care/emergency.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/person/consent.hpp"

namespace isograsp::session {

namespace {

bool same_value(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// `rows`: row-major, columns of one group; they stand in `read` from `row` and `column` on.
bool same_rows(const Signals& read, std::size_t row, std::size_t column, std::size_t columns,
               const std::vector<double>& rows) {
  if (row + rows.size() / columns > read.rows()) return false;
  for (std::size_t at = 0; at < rows.size(); ++at)
    if (!same_value(read.column(column + at % columns)[row + at / columns], rows[at])) return false;
  return true;
}

bool same_signals_as(const Signals& read, const std::vector<storage::SignalGroup>& groups,
                     std::span<const SecondOfSignals> seconds) {
  std::size_t row = 0;
  for (const SecondOfSignals& second : seconds) {
    std::size_t column = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::size_t columns = groups[g].columns.size();
      if (!same_rows(read, row, column, columns, second[g])) return false;
      column += columns;
    }
    row += second[0].size() / groups[0].columns.size();
  }
  return row == read.rows();
}

/// A number that no other row was given.
storage::RowId unused(const std::map<storage::RowId, storage::RowId>& rows, storage::RowId wanted) {
  return rows.empty() ? wanted : std::max(wanted, rows.rbegin()->first + 1);
}

}  // namespace

Result<void> read_back(const std::string& database, const storage::TrialRecord& ended,
                       std::span<const Measure> measures,
                       std::span<const SecondOfSignals> seconds) {
  const auto wrong = [&](const Text& what) {
    return failed("reading back trial %1: %2"_text(ended.number, what),
                  "check the disk, and restore the last backup"_text)
        .at(database);
  };
  const auto store = storage::open_store(database, storage::OpenMode::read_only);
  if (!store) return wrong(store.error().what);
  const auto trials = (*store)->trials(ended.session_id);
  if (!trials) return wrong(trials.error().what);
  const auto trial =
      std::find_if(trials->begin(), trials->end(),
                   [&](const storage::TrialRecord& one) { return one.uuid == ended.uuid; });
  if (trial == trials->end()) return wrong("it is not there"_text);
  if (trial->status != ended.status || trial->samples != ended.samples)
    return wrong("it is there as '%1' with %2 samples instead of '%3' with %4"_text(
        storage::name_of(trial->status), trial->samples, storage::name_of(ended.status),
        ended.samples));
  const auto stored = (*store)->measures(trial->id);
  if (!stored) return wrong(stored.error().what);
  if (!std::equal(stored->begin(), stored->end(), measures.begin(), measures.end()))
    return wrong("its measures are not those that were stored"_text);
  const auto signals = (*store)->signals(*trial);
  if (!signals) return wrong(signals.error().what);
  if (!same_signals_as(*signals, trial->groups, seconds))
    return wrong("its signals are not those that were stored"_text);
  return {};
}

SessionWriter::SessionWriter(std::unique_ptr<storage::SessionStore> store,
                             storage::PatientRecord patient, storage::SessionRecord session,
                             std::vector<storage::SessionAnswer> answers, bool safe)
    : store_(std::move(store)),
      patient_(std::move(patient)),
      session_(std::move(session)),
      answers_(std::move(answers)),
      safe_(safe) {
  numbers_.session = session_.id;
  // Read now: later the file may be gone.
  if (const auto id = store_->database_id()) database_id_ = *id;
}

SessionWriter::~SessionWriter() = default;

Result<void> SessionWriter::perform(Operation operation) {
  if (lost_) return {};
  auto done = operation(*store_, numbers_);
  if (safe_) done_.push_back(std::move(operation));
  if (done) return done;
  return go_to_emergency(done.error());
}

Error SessionWriter::go_to_emergency(const Error& why) {
  Error error = why;
  error.code = Error::Code::failed;
  lost_ = true;
  if (!safe_) return error;
  if (left_) {
    error.what = "%1; this was the emergency file"_text(error.what);
    return error;
  }
  const auto file = storage::make_emergency_file(
      {"", store_->path(), database_id_, english(why.what), "", "", 0});
  const auto written = file ? write_anew(file->path) : Result<void>(file.error());
  if (!written) {
    error.what = "%1; an emergency file could not be made either: %2"_text(
        error.what, words_of(written.error()));
    return error;
  }
  lost_ = false;
  emergency_path_ = file->path;
  error.remedy = "%1; all of this session is in %2: isograsp db rescue %3 takes it in"_text(
      error.remedy, emergency_path_, left_->path());
  return error;
}

Result<void> SessionWriter::write_anew(const std::string& path) {
  auto opened = storage::open_store(path, storage::OpenMode::existing);
  if (!opened) return opened.error();
  storage::SessionStore& store = **opened;
  const auto patient = store.add_patient(patient_.code, patient_.created_utc, patient_.uuid);
  if (!patient) return patient.error();
  storage::SessionRecord session = session_;
  session.patient_id = patient->id;
  session.resumes_id.reset();  // that session is not here
  const auto id = store.begin_session(session, answers_);
  if (!id) return id.error();
  Numbers numbers;
  numbers.session = *id;
  for (const Operation& operation : done_)
    // What the file itself refuses was refused before.
    if (const auto done = operation(store, numbers);
        !done && done.error().code == Error::Code::failed)
      return done.error();
  left_ = std::exchange(store_, *std::move(opened));
  numbers_ = std::move(numbers);
  return {};
}

Result<void> SessionWriter::begin_trial(storage::TrialRecord trial, storage::RowId& id) {
  auto given = std::make_shared<storage::RowId>(0);
  auto kept = std::make_shared<KeptTrial>();
  if (safe_) trial.uuid = kept->uuid = storage::random_uuid();
  auto done = perform([trial = std::move(trial), given](storage::SessionStore& store,
                                                        Numbers& numbers) -> Result<void> {
    storage::TrialRecord here = trial;
    here.session_id = numbers.session;
    for (storage::RowId& one : here.preparations) one = numbers.of_preparation(one);
    const auto row = store.begin_trial(here);
    if (!row) return row.error();
    if (*given == 0) *given = unused(numbers.trials, *row);
    numbers.trials[*given] = *row;
    return {};
  });
  id = *given;
  if (id != 0) trials_[id] = std::move(kept);
  return done;
}

Result<void> SessionWriter::append_blocks(storage::RowId trial, int second,
                                          const SecondOfSignals& rows) {
  const auto kept = trials_.find(trial);
  if (kept == trials_.end()) return {};  // its beginning failed, and that was said
  if (!safe_)
    return perform([&](storage::SessionStore& store, Numbers&) {
      return store.append_blocks(trial, second, rows);
    });
  kept->second->seconds.push_back(rows);
  return perform(
      [trial, second, keeping = kept->second](storage::SessionStore& store, Numbers& numbers) {
        return store.append_blocks(numbers.of_trial(trial), second,
                                   keeping->seconds[static_cast<std::size_t>(second)]);
      });
}

Result<void> SessionWriter::end_trial(const storage::TrialRecord& end,
                                      const std::vector<Measure>& measures) {
  const auto found = trials_.find(end.id);
  if (found == trials_.end()) return {};
  const auto kept = found->second;
  kept->end = end;
  kept->end.uuid = kept->uuid;
  kept->measures = measures;
  kept->ended = true;
  return perform(
      [kept, safe = safe_](storage::SessionStore& store, Numbers& numbers) -> Result<void> {
        storage::TrialRecord here = kept->end;
        here.session_id = numbers.session;
        here.id = numbers.of_trial(kept->end.id);
        auto done = store.end_trial(here, kept->measures);
        if (!done || !safe) return done;
        return read_back(store.path(), here, kept->measures, kept->seconds);
      });
}

Result<void> SessionWriter::add_event(const storage::EventRecord& event) {
  if (lost_) return {};
  // As the database holds it, while its keys are there.
  storage::SessionStore* const database = left_ ? left_.get() : store_.get();
  const auto trial = event.trial_id ? trials_.find(*event.trial_id) : trials_.end();
  const storage::EventPlace place{patient_.code, session_.uuid,
                                  trial != trials_.end() ? trial->second->uuid : ""};
  const auto stored = safe_ ? database->as_stored(place, event) : event;
  return perform(
      [event, database, sealed = stored ? *stored : storage::EventRecord{}, ok = stored.ok()](
          storage::SessionStore& store, Numbers& numbers) -> Result<void> {
        const bool elsewhere = &store != database;
        if (elsewhere && !ok) return {};  // better without it than in plain text
        storage::EventRecord here = elsewhere ? sealed : event;
        here.trial_id = numbers.of_trial(event.trial_id);
        return store.add_event(numbers.session, here);
      });
}

Result<void> SessionWriter::add_rating(const storage::RatingRecord& rating, storage::RowId& id) {
  auto given = std::make_shared<storage::RowId>(0);
  auto done =
      perform([rating, given](storage::SessionStore& store, Numbers& numbers) -> Result<void> {
        storage::RatingRecord here = rating;
        here.session_id = numbers.session;
        here.trial_id = numbers.of_trial(rating.trial_id);
        const auto row = store.add_rating(here);
        if (!row) return row.error();
        if (*given == 0) *given = unused(numbers.ratings, *row);
        numbers.ratings[*given] = *row;
        return {};
      });
  id = *given;
  return done;
}

Result<void> SessionWriter::correct_rating(const storage::RatingRecord& rating) {
  return perform([rating](storage::SessionStore& store, Numbers& numbers) {
    storage::RatingRecord here = rating;
    here.id = numbers.of_rating(rating.id);
    here.session_id = numbers.session;
    here.trial_id = numbers.of_trial(rating.trial_id);
    return store.correct_rating(here);
  });
}

Result<void> SessionWriter::add_answers(const std::vector<storage::SessionAnswer>& answers) {
  return perform([answers](storage::SessionStore& store, Numbers& numbers) {
    return store.add_answers(numbers.session, answers);
  });
}

Result<void> SessionWriter::mark_helped(storage::RowId trial, bool helped) {
  return perform([trial, helped](storage::SessionStore& store, Numbers& numbers) {
    return store.mark_helped(numbers.of_trial(trial), helped);
  });
}

Result<void> SessionWriter::add_preparation(const storage::PreparationRecord& preparation,
                                            storage::RowId& id) {
  auto given = std::make_shared<storage::RowId>(0);
  auto done =
      perform([preparation, given](storage::SessionStore& store, Numbers& numbers) -> Result<void> {
        storage::PreparationRecord here = preparation;
        here.session_id = numbers.session;
        here.trial_id = numbers.of_trial(preparation.trial_id);
        const auto row = store.add_preparation(here);
        if (!row) return row.error();
        if (*given == 0) *given = unused(numbers.preparations, *row);
        numbers.preparations[*given] = *row;
        return {};
      });
  id = *given;
  return done;
}

Result<void> SessionWriter::end_session(const std::string& ended_utc) {
  auto done = perform([ended_utc](storage::SessionStore& store, Numbers& numbers) {
    return store.end_session(numbers.session, ended_utc);
  });
  if (done && safe_ && !lost_ && !left_)
    if (const auto all = read_back_all(); !all) done = go_to_emergency(all.error());
  if (left_) keep_whole();
  return done;
}

Result<void> SessionWriter::read_back_all() {
  for (const auto& [id, kept] : trials_) {
    if (!kept->ended) continue;
    storage::TrialRecord here = kept->end;
    here.session_id = numbers_.session;
    if (auto good = read_back(store_->path(), here, kept->measures, kept->seconds); !good)
      return good;
  }
  return {};
}

Result<void> SessionWriter::look() {
  if (lost_ || left_ || !safe_) return {};
  const auto there = store_->in_place();
  if (there) return {};
  return go_to_emergency(there.error());
}

bool SessionWriter::camera_is_allowed() {
  if (lost_ || left_) return true;
  return std::any_of(storage::kPurposesOfCameras.begin(), storage::kPurposesOfCameras.end(),
                     [this](std::string_view purpose) {
                       const auto state = store_->consent_state(patient_.id, std::string(purpose));
                       return !state || *state == "given";
                     });
}

void SessionWriter::keep_whole() {
  if (!left_->is_last_hold() || emergency_path_.empty()) return;
  storage::EmergencyFile file;
  file.path = emergency_path_;
  // Where it cannot be kept, the emergency file still has the session.
  static_cast<void>(left_->save_copy(file.whole()));
}

}  // namespace isograsp::session
