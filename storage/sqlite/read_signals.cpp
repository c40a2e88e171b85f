// SPDX-License-Identifier: GPL-3.0-or-later
// Signals of a trial: its blocks or packs, checked, put side by side.
#include <algorithm>
#include <limits>

#include <soci/soci.h>

#include "storage/sqlite/block_codec.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

/// The number of samples may be damaged, too: it must not ask for all memory [values].
constexpr std::size_t kMostReserved = std::size_t{1} << 23;

std::string_view read_blob(soci::blob& blob, std::string& bytes) {
  bytes.resize(blob.get_len());
  blob.read(0, bytes.data(), bytes.size());
  return bytes;
}

/// A column that may be NULL counts as empty.
std::string_view read_blob(soci::blob& blob, soci::indicator present, std::string& bytes) {
  return present == soci::i_ok ? read_blob(blob, bytes) : std::string_view();
}

}  // namespace

Refusal SqliteStore::damaged(const TrialRecord& trial, const Text& where, const Text& what) const {
  return {failed("trial %1 of session %2%3: %4"_text(trial.number, trial.session_id, where, what),
                 "restore the last backup; other trials can still be read"_text)
              .at(path())};
}

std::size_t SqliteStore::most_rows(const TrialRecord& trial) const {
  std::size_t columns = 0;
  for (const SignalGroup& group : trial.groups) {
    if (group.columns.empty()) throw damaged(trial, {}, "a group of signals has no columns"_text);
    columns += group.columns.size();
  }
  const std::size_t most = columns == 0 ? kMostTrialValues : kMostTrialValues / columns;
  if (trial.samples < 0 || static_cast<std::size_t>(trial.samples) > most)
    throw damaged(trial, {},
                  "it says that it has %1 samples of %2 columns, more than any trial"_text(
                      trial.samples, columns));
  return most;
}

int SqliteStore::read_blocks(const TrialRecord& trial, std::size_t group, int from, int most,
                             std::span<std::vector<double>> columns) {
  soci::session& sql = database_.sql();
  const auto wanted = static_cast<std::size_t>(trial.samples);
  const std::size_t most_in_trial = most_rows(trial);
  const int position = static_cast<int>(group);
  const int until = from + most;
  int second = 0;
  long long row_count = 0;
  long long crc = 0;
  soci::blob data(sql);
  soci::statement select =
      (sql.prepare << "SELECT second, row_count, crc32, float64_shuffled_zstd FROM signal_blocks "
                      "WHERE trial_id = :trial AND position = :position "
                      "AND second >= :from AND second < :until ORDER BY second",
       soci::use(trial.id), soci::use(position), soci::use(from), soci::use(until),
       soci::into(second), soci::into(row_count), soci::into(crc), soci::into(data));
  select.execute();
  int expected = from;
  std::string bytes;
  const auto refuse_block = [&](const Text& what) {
    return damaged(trial, ", group %1, second %2"_text(trial.groups[group].name, expected),
                   "the block is %1"_text(what));
  };
  while (columns.front().size() < wanted && select.fetch()) {
    if (second != expected) throw refuse_block("missing"_text);
    if (crc32(read_blob(data, bytes)) != crc) throw refuse_block("damaged (checksum)"_text);
    if (row_count < 0 ||
        columns.front().size() + static_cast<std::size_t>(row_count) > most_in_trial)
      throw refuse_block("longer than any trial"_text);
    if (!decode_block(bytes, static_cast<std::size_t>(row_count), columns))
      throw refuse_block("damaged (content)"_text);
    ++expected;
  }
  if (expected < until && columns.front().size() < wanted) throw refuse_block("missing"_text);
  return expected - from;
}

void SqliteStore::read_packs(const TrialRecord& trial, std::size_t group,
                             std::span<std::vector<double>> columns, ContentHasher& whole) {
  soci::session& sql = database_.sql();
  const int position = static_cast<int>(group);
  const auto wanted = static_cast<std::size_t>(trial.samples);
  const std::size_t most = most_rows(trial);
  int part = 0;
  long long row_count = 0;
  soci::blob told(sql);
  soci::blob data(sql);
  soci::statement select =
      (sql.prepare << "SELECT part, row_count, values_blake2b, float64_shuffled_zstd "
                      "FROM signal_packs WHERE trial_id = :trial AND position = :position "
                      "ORDER BY part",
       soci::use(trial.id), soci::use(position), soci::into(part), soci::into(row_count),
       soci::into(told), soci::into(data));
  select.execute();
  int expected = 0;
  std::string hash;
  std::string bytes;
  const auto refuse_part = [&](const Text& what) {
    const int from = kSecondsPerPart * expected;
    return damaged(trial,
                   ", group %1, seconds %2 to %3"_text(trial.groups[group].name, from,
                                                       from + kSecondsPerPart - 1),
                   "the block is %1"_text(what));
  };
  while (columns.front().size() < wanted && select.fetch()) {
    if (part != expected) throw refuse_part("missing"_text);
    if (row_count < 0 || columns.front().size() + static_cast<std::size_t>(row_count) > most)
      throw refuse_part("longer than any trial"_text);
    const auto rows = static_cast<std::size_t>(row_count);
    const auto planes = decompress(read_blob(data, bytes), rows, columns.size());
    if (!planes) throw refuse_part("damaged (content)"_text);
    if (bytes_of(content_hash(planes->bytes())) != read_blob(told, hash))
      throw refuse_part("damaged (content hash)"_text);
    unshuffle(*planes, columns);
    whole.add_number(rows);
    whole.add(hash);
    ++expected;
  }
  if (columns.front().size() < wanted) throw refuse_part("missing"_text);
}

Result<Signals> SqliteStore::signals(const TrialRecord& trial) {
  Signals signals;
  const auto done = database_.snapshot("reading signals"_text, [&] {
    soci::session& sql = database_.sql();
    soci::blob told(sql);
    soci::indicator packed = soci::i_null;
    std::int64_t samples = 0;
    std::size_t groups = 0;
    const std::string query = "SELECT coalesce(sample_count, 0), " +
                              std::string("signals_blake2b") +
                              ", (SELECT count(*) FROM signal_groups WHERE trial_id = trials.id) "
                              "FROM trials WHERE id = :id";
    sql << query, soci::use(trial.id), soci::into(samples), soci::into(told, packed),
        soci::into(groups);
    std::string hash;
    const bool in_packs = !read_blob(told, packed, hash).empty();
    ContentHasher whole;
    const auto wanted = static_cast<std::size_t>(trial.samples);
    static_cast<void>(most_rows(trial));
    for (std::size_t g = 0; g < trial.groups.size(); ++g) {
      const SignalGroup& group = trial.groups[g];
      std::vector<std::vector<double>> columns(group.columns.size());
      for (auto& column : columns)
        column.reserve(std::min(wanted, kMostReserved / group.columns.size()));
      if (in_packs) {
        add_group(group, whole);
        read_packs(trial, g, columns, whole);
      } else {
        constexpr int kAll = std::numeric_limits<int>::max();
        read_blocks(trial, g, 0, kAll, columns);
      }
      for (std::size_t c = 0; c < columns.size(); ++c) {
        columns[c].resize(wanted);  // the last block may hold more than was asked for
        signals.add_column(group.columns[c], std::move(columns[c]));
      }
    }
    const bool all = trial.samples == samples && trial.groups.size() == groups;
    if (in_packs && all && bytes_of(whole.hash()) != hash)
      throw damaged(trial, {}, "the signals are not those that were recorded (content hash)"_text);
  });
  if (!done) return done.error();
  return signals;
}

}  // namespace isograsp::storage
