// SPDX-License-Identifier: GPL-3.0-or-later
// A trial while it is recorded: its row, a block a second, its end. Every call is one transaction,
// synced to the disk before it returns.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <soci/soci.h>

#include "storage/sqlite/block_codec.hpp"
#include "storage/sqlite/nullable.hpp"
#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

struct SqliteStore::BlockInsert {
  explicit BlockInsert(soci::session& sql)
      : data(sql),
        statement((sql.prepare << "INSERT INTO signal_blocks (trial_id, position, second, "
                                  "row_count, crc32, float64_shuffled_zstd) "
                                  "VALUES (:trial, :position, :second, :rows, :crc, :data)",
                   soci::use(trial), soci::use(position), soci::use(second), soci::use(row_count),
                   soci::use(crc), soci::use(data))) {}
  long long trial = 0;
  int position = 0;
  int second = 0;
  long long row_count = 0;
  long long crc = 0;
  soci::blob data;
  soci::statement statement;
};

SqliteStore::SqliteStore(Database database) : database_(std::move(database)) {}
SqliteStore::~SqliteStore() = default;

Result<RowId> SqliteStore::begin_trial(const TrialRecord& trial) {
  if (recording_)
    return refused("a trial is being recorded"_text, "end it before the next one begins"_text)
        .at(path());
  if (trial.groups.empty())
    return refused("the trial has no signals"_text, "give at least one group"_text).at(path());
  Recording recording;
  for (const SignalGroup& group : trial.groups) {
    const bool nameless =
        std::any_of(group.columns.begin(), group.columns.end(),
                    [](const auto& c) { return c.empty() || c.find('\n') != std::string::npos; });
    if (group.columns.empty() || nameless)
      return refused("signal group '%1' has no columns or one without a name"_text(group.name),
                     "name every column"_text)
          .at(path());
    recording.column_counts.push_back(group.columns.size());
  }
  auto lock = RecordingLock::shared(database_.real_path());
  if (!lock) return lock.error();
  recording.lock = std::move(*lock);

  const std::string seed = trial.seed == 0 ? "" : std::to_string(trial.seed);
  const auto step = trial.place ? std::optional(trial.place->step) : std::nullopt;
  const auto step_task = trial.place ? std::optional(trial.place->task) : std::nullopt;
  const auto done = database_.transact("beginning a trial"_text, [&] {
    soci::session& sql = database_.sql();
    std::string of_session;
    sql << "SELECT rate_Hz, uuid FROM sessions WHERE id = :id", soci::use(trial.session_id),
        soci::into(recording.rate_Hz), soci::into(of_session);
    if (!sql.got_data())
      throw Refusal{
          refused("there is no session %1"_text(trial.session_id), "begin one"_text).at(path())};
    const std::string uuid = trial.uuid.empty()
                                 ? new_uuid(of_session + "\n" + std::to_string(trial.number))
                                 : trial.uuid;
    NewRow(sql, "trials")
        .set("session_id", trial.session_id)
        .set("uuid", uuid)
        .set("number", trial.number)
        .set("step", step)
        .set("step_task", step_task)
        .set("task_name", trial.task_name)
        .set("task_version", trial.task_version)
        .set("task_text", trial.task_text)
        .set("scene_text", trial.scene_text)
        .set("seed", seed)
        .set("practice", trial.practice)
        .set("session_time_s", trial.session_time_s)
        .set("status", std::string_view("running"))
        .insert();
    recording.trial = last_id(sql, "trials");
    insert_references("trial", recording.trial, trial.references);
    for (const RowId preparation : trial.preparations)
      NewRow(sql, "trial_preparations")
          .set("session_id", trial.session_id)
          .set("trial_id", recording.trial)
          .set("preparation_id", preparation)
          .insert();
    for (std::size_t g = 0; g < trial.groups.size(); ++g)
      NewRow(sql, "signal_groups")
          .set("trial_id", recording.trial)
          .set("position", static_cast<std::int64_t>(g))
          .set("name", trial.groups[g].name)
          .set("column_names", as_lines(trial.groups[g].columns))
          .insert();
  });
  if (!done) return done.error();
  recording_ = std::move(recording);
  return recording_->trial;
}

Result<void> SqliteStore::check_blocks(int second,
                                       std::span<const std::vector<double>> rows) const {
  const Recording& now = *recording_;
  if (second != now.next_second)
    return refused("second %1 came instead of %2"_text(second, now.next_second),
                   "append the seconds in order"_text)
        .at(path());
  if (now.short_block_seen)
    return refused("a second follows one that was not full"_text,
                   "end the trial after the last second"_text)
        .at(path());
  if (rows.size() != now.column_counts.size())
    return refused("blocks for %1 instead of %2 groups"_text(rows.size(), now.column_counts.size()),
                   "give all groups of the trial at once"_text)
        .at(path());
  const std::size_t row_count = rows[0].size() / now.column_counts[0];
  for (std::size_t g = 0; g < rows.size(); ++g)
    if (row_count == 0 || rows[g].size() != row_count * now.column_counts[g])
      return refused(
                 "the groups of second %1 do not hold the same number of whole rows"_text(second),
                 "give every group one row per sample"_text)
          .at(path());
  if (static_cast<double>(row_count) > std::ceil(now.rate_Hz))
    return refused("second %1 holds %2 rows, more than one second"_text(second, row_count),
                   "append one second at a time"_text)
        .at(path());
  const auto columns =
      std::accumulate(now.column_counts.begin(), now.column_counts.end(), std::size_t{0});
  const double rows_then = second * std::ceil(now.rate_Hz) + static_cast<double>(row_count);
  if (rows_then * static_cast<double>(columns) > static_cast<double>(kMostTrialValues))
    return refused("the trial holds more values than can be read again"_text,
                   "end it and go on with another one"_text)
        .at(path());
  return {};
}

void SqliteStore::require_lock() const {
  if (recording_->lock.in_place(database_.real_path())) return;
  throw Refusal{
      failed("the lock (-lock) beside the file was deleted or replaced while it was recorded "
             "into: other programs take the running trial for an interrupted one"_text,
             "leave the file -lock where it is while a program records"_text)
          .at(path())};
}

Result<void> SqliteStore::in_place() {
  if (auto there = database_.in_place(); !there) return there;
  return database_.guard("recording"_text, [this] {
    if (recording_) require_lock();
  });
}

Result<void> SqliteStore::append_blocks(RowId trial, int second,
                                        std::span<const std::vector<double>> rows) {
  if (!recording_ || recording_->trial != trial)
    return refused("trial %1 is not being recorded"_text(trial), "begin it first"_text).at(path());
  if (const auto sound = check_blocks(second, rows); !sound) return sound.error();
  const auto row_count = static_cast<long long>(rows[0].size() / recording_->column_counts[0]);
  const auto done = database_.transact("storing a second of signals"_text, [&] {
    if (!block_insert_) block_insert_ = std::make_unique<BlockInsert>(database_.sql());
    BlockInsert& insert = *block_insert_;
    insert.trial = trial;
    insert.second = second;
    insert.row_count = row_count;
    for (std::size_t g = 0; g < rows.size(); ++g) {
      const std::string bytes = encode_block(rows[g], recording_->column_counts[g]);
      insert.position = static_cast<int>(g);
      insert.crc = crc32(bytes);
      if (insert.data.get_len() > 0) insert.data.trim(0);
      insert.data.append(bytes.data(), bytes.size());
      insert.statement.execute(true);
    }
    require_lock();
  });
  if (!done) {
    block_insert_.reset();  // a statement that failed half-way is not used again
    return done.error();
  }
  ++recording_->next_second;
  recording_->short_block_seen = static_cast<double>(row_count) < std::floor(recording_->rate_Hz);
  return {};
}

Result<void> SqliteStore::end_trial(const TrialRecord& end, std::span<const Measure> measures) {
  if (!recording_ || recording_->trial != end.id)
    return refused("trial %1 is not being recorded"_text(end.id), "begin it first"_text).at(path());
  if (end.status == TrialStatus::running)
    return refused("a trial cannot end as running"_text, "say completed or aborted"_text)
        .at(path());
  for (const Measure& measure : measures)
    if (measure.value && !std::isfinite(*measure.value))
      return refused("measure %1 is not a finite number"_text(measure.name),
                     "leave the value out and give the reason"_text)
          .at(path());
  const std::string status(name_of(end.status));
  NullableNumber age(end.display_age_s);
  NullableNumber distance(end.viewing_distance_m);
  const auto done = database_.transact("closing a trial"_text, [&] {
    soci::session& sql = database_.sql();
    soci::statement update =
        (sql.prepare
             << "UPDATE trials SET status = :status, dropped_count = :dropped, "
                "worst_lateness_s = :lateness, worst_compute_s = :compute, health_json = :health, "
                "timing_json = :timing, display_age_s = :age, "
                "viewing_distance_m = :distance, "
                "sample_count = (SELECT coalesce(sum(row_count), 0) FROM signal_blocks "
                "WHERE trial_id = trials.id AND position = 0) WHERE id = :id AND status = "
                "'running'",
         soci::use(status), soci::use(end.dropped), soci::use(end.worst_lateness_s),
         soci::use(end.worst_compute_s), soci::use(end.health_json), soci::use(end.timing_json),
         soci::use(age.value, age.present), soci::use(distance.value, distance.present),
         soci::use(end.id));
    update.execute(true);
    if (update.get_affected_rows() != 1)
      throw Refusal{failed("closing a trial: another program has closed or removed it"_text,
                           "let only one program record into a file"_text)
                        .at(path())};
    require_lock();
    insert_references("trial", end.id, end.references);
    insert_measures(end.id, measures);
  });
  if (!done) return done.error();
  recording_.reset();
  pack_or_note(end.id);
  return {};
}

}  // namespace isograsp::storage
