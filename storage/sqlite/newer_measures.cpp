// SPDX-License-Identifier: GPL-3.0-or-later
// Results in several versions: what a trial was scored with when it ended, and beside it what a
// corrected measure makes of the same signals. Nothing of it is ever overwritten; readers take the
// newest version.
#include <algorithm>
#include <cmath>

#include <soci/soci.h>

#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

bool is_same(const Measure& a, const Measure& b) {
  return a.name == b.name && a.channel == b.channel && a.unit == b.unit;
}

/// Of `scored` what is stored with older versions only.
std::vector<Measure> newer_than(const std::vector<Measure>& stored,
                                const std::vector<Measure>& scored) {
  std::vector<Measure> newer;
  for (const Measure& one : scored) {
    const auto there = std::find_if(stored.begin(), stored.end(),
                                    [&](const Measure& other) { return is_same(one, other); });
    if (there != stored.end() && there->version < one.version &&
        (!one.value || std::isfinite(*one.value)))
      newer.push_back(one);
  }
  return newer;
}

}  // namespace

void keep_newest(std::vector<Measure>& measures) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    Measure& one = measures[i];
    const auto end = measures.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto there = std::find_if(measures.begin(), end,
                                    [&](const Measure& other) { return is_same(one, other); });
    if (there == end || there->version == one.version) {
      if (kept != i) measures[kept] = std::move(one);
      ++kept;
      continue;
    }
    if (one.version > there->version) *there = std::move(one);
    there->recomputed = true;
  }
  measures.resize(kept);
}

void SqliteStore::insert_measures(RowId trial, std::span<const Measure> measures) {
  for (const Measure& measure : measures) {
    const double value = measure.value.value_or(0.0);
    auto value_present = measure.value ? soci::i_ok : soci::i_null;
    database_.sql() << "INSERT INTO measures (trial_id, name, channel, value, unit, version, "
                       "sample_count, excluded_count, reason) VALUES (:trial, :name, :channel, "
                       ":value, :unit, :version, :samples, :excluded, :reason)",
        soci::use(trial), soci::use(measure.name), soci::use(measure.channel),
        soci::use(value, value_present), soci::use(measure.unit), soci::use(measure.version),
        soci::use(measure.samples), soci::use(measure.excluded), soci::use(measure.reason);
  }
}

Result<bool> SqliteStore::insert_newer_measures(
    RowId patient, std::span<const ScoredTrial> trials,
    const std::function<void(const Added&)>& before_commit) {
  if (database_.is_read_only()) return false;
  // A recorder that wants to begin a trial now waits for this transaction (milliseconds).
  const auto lock = RecordingLock::exclusive_if_free(database_.real_path());
  if (!lock) return lock.error();
  if (!lock->held()) return false;
  return database_.transact_if_free("keeping results of a newer version"_text, [&] {
    Added added;
    for (const ScoredTrial& trial : trials) {
      int allowed = 0;
      database_.sql() << "SELECT count(*) FROM trials t JOIN sessions s ON s.id = t.session_id "
                         "WHERE t.id = :trial AND t.status <> 'running' "
                         "AND s.patient_id = :patient "
                         "AND s.patient_id NOT IN (SELECT patient_id FROM restrictions)",
          soci::use(trial.trial_id), soci::use(patient), soci::into(allowed);
      if (allowed == 0) continue;
      const auto stored = measures(trial.trial_id);
      if (!stored) throw Refusal{stored.error()};
      const auto newer = newer_than(*stored, trial.measures);
      insert_measures(trial.trial_id, newer);
      added.results += static_cast<int>(newer.size());
      added.trials += newer.empty() ? 0 : 1;
    }
    before_commit(added);
  });
}

Result<bool> SqliteStore::add_newer_measures(RowId patient, std::span<const ScoredTrial> trials) {
  return insert_newer_measures(patient, trials, [](const Added&) {});
}

}  // namespace isograsp::storage
