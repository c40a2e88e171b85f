// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of a second become blocks of ten seconds when a trial is closed: smaller, read faster,
// each with the hash of its values, and the trial with the hash of all of them.
#include <soci/soci.h>

#include "storage/sqlite/block_codec.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

void put(soci::blob& blob, std::string_view bytes) {
  if (blob.get_len() > 0) blob.trim(0);
  blob.append(bytes.data(), bytes.size());
}

}  // namespace

void add_group(const SignalGroup& group, ContentHasher& whole) {
  whole.add_text(group.name);
  whole.add_number(group.columns.size());
  for (const std::string& column : group.columns) whole.add_text(column);
}

Result<std::vector<RowId>> SqliteStore::unpacked() {
  std::vector<RowId> all;
  const auto done = database_.guard("reading trials"_text, [&] {
    RowId id = 0;
    soci::statement select =
        (database_.sql().prepare << "SELECT id FROM trials WHERE signals_blake2b IS NULL "
                                    "AND status <> 'running' ORDER BY id",
         soci::into(id));
    select.execute();
    while (select.fetch()) all.push_back(id);
  });
  if (!done) return done.error();
  return all;
}

void SqliteStore::read_parts(const TrialRecord& trial, std::size_t group, ContentHasher& whole,
                             const PartWork& work) {
  const auto wanted = static_cast<std::size_t>(trial.samples);
  std::size_t rows = 0;
  for (int part = 0; rows < wanted; ++part) {
    std::vector<std::vector<double>> columns(trial.groups[group].columns.size());
    TrialRecord rest = trial;  // what is still to come
    rest.samples = static_cast<std::int64_t>(wanted - rows);
    read_blocks(rest, group, kSecondsPerPart * part, kSecondsPerPart, columns);
    const Planes planes = shuffle_columns(columns);
    const ContentHash values = content_hash(planes.bytes());
    whole.add_number(columns.front().size());
    whole.add(bytes_of(values));
    if (work) work(part, columns.front().size(), planes, values);
    rows += columns.front().size();
  }
}

void SqliteStore::pack_group(const TrialRecord& trial, std::size_t group, ContentHasher& whole) {
  soci::session& sql = database_.sql();
  const int position = static_cast<int>(group);
  soci::blob hash(sql);
  soci::blob data(sql);
  read_parts(trial, group, whole,
             [&](int part, std::size_t rows, const Planes& planes, const ContentHash& values) {
               const std::string bytes = compress(planes);
               // Checked, because the only copy of a patient's work is removed next.
               const auto back = decompress(bytes, rows, trial.groups[group].columns.size());
               if (!back || back->bytes() != planes.bytes())
                 throw damaged(trial, {}, "the signals cannot be packed without loss"_text);
               const int from = kSecondsPerPart * part;
               const int until = from + kSecondsPerPart;
               const auto row_count = static_cast<long long>(rows);
               // First removed, then added: the file does not grow.
               sql << "DELETE FROM signal_blocks WHERE trial_id = :trial AND position = :position "
                      "AND second >= :from AND second < :until",
                   soci::use(trial.id), soci::use(position), soci::use(from), soci::use(until);
               put(hash, bytes_of(values));
               put(data, bytes);
               sql << "INSERT INTO signal_packs (trial_id, position, part, row_count, "
                      "values_blake2b, float64_shuffled_zstd) VALUES (:trial, :position, :part, "
                      ":rows, :hash, :data)",
                   soci::use(trial.id), soci::use(position), soci::use(part), soci::use(row_count),
                   soci::use(hash), soci::use(data);
             });
}

std::optional<TrialRecord> SqliteStore::unpacked_trial(RowId id) {
  TrialRecord trial;
  trial.id = id;
  database_.sql() << "SELECT session_id, number, sample_count FROM trials WHERE id = :id "
                     "AND signals_blake2b IS NULL AND status <> 'running'",
      soci::use(id), soci::into(trial.session_id), soci::into(trial.number),
      soci::into(trial.samples);
  if (!database_.sql().got_data()) return std::nullopt;
  trial.groups = groups_of(id);
  return trial;
}

Result<std::optional<ContentHash>> SqliteStore::hash_of_blocks(RowId id) {
  std::optional<ContentHash> hash;
  const auto done = database_.snapshot("reading signals"_text, [&] {
    const auto trial = unpacked_trial(id);
    if (!trial) return;
    ContentHasher whole;
    for (std::size_t g = 0; g < trial->groups.size(); ++g) {
      add_group(trial->groups[g], whole);
      read_parts(*trial, g, whole, {});
    }
    hash = whole.hash();
  });
  if (!done) return done.error();
  return hash;
}

Result<void> SqliteStore::pack_trial(RowId id) {
  return database_.transact("packing signals"_text, [&] {
    const auto trial = unpacked_trial(id);
    if (!trial) return;  // somebody else has done it
    if (!is_as_sealed("trials", id))
      throw Refusal{failed("%1: row %2 is not what isograsp wrote"_text("trials", id),
                           "run isograsp db check, then restore the last backup"_text)
                        .at(path())};
    ContentHasher whole;
    for (std::size_t g = 0; g < trial->groups.size(); ++g) {
      add_group(trial->groups[g], whole);
      pack_group(*trial, g, whole);
    }
    soci::session& sql = database_.sql();
    soci::blob hash(sql);
    put(hash, bytes_of(whole.hash()));
    sql << "UPDATE trials SET signals_blake2b = :hash WHERE id = :id", soci::use(hash),
        soci::use(id);
  });
}

void SqliteStore::pack_or_note(RowId trial) {
  const auto packed = pack_trial(trial);
  if (packed) return;
  const std::string text =
      "The signals stay in blocks of a second: " + english(packed.error().what) + ".";
  // Where even this cannot be stored, `db stats` still counts the trial.
  static_cast<void>(database_.transact("storing an event"_text, [&] {
    database_.sql() << "INSERT INTO events (session_id, trial_id, session_time_s, kind, text) "
                       "SELECT session_id, id, session_time_s, 'storage', :text FROM trials "
                       "WHERE id = :id",
        soci::use(text), soci::use(trial);
  }));
}

}  // namespace isograsp::storage
