// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/file_stats.hpp"

#include <filesystem>

#include <soci/soci.h>

#include "storage/file/database.hpp"
#include "storage/file/open_mode.hpp"

namespace isograsp::storage {

Result<FileStats> file_stats(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  FileStats stats;
  stats.format = database->format();
  const bool has_packs = stats.format >= 6;
  const auto read = database->snapshot("counting"_text, [&] {
    soci::session& sql = database->sql();
    const auto number = [&sql](const std::string& query, auto& to) {
      sql << query, soci::into(to);
    };
    for (const auto& [table, count] : {std::pair{"patients", &stats.patients},
                                       {"sessions", &stats.sessions},
                                       {"trials", &stats.trials},
                                       {"measures", &stats.measures},
                                       {"events", &stats.events}})
      number("SELECT count(*) FROM " + std::string(table), *count);
    sql << "SELECT coalesce(min(started_utc), ''), coalesce(max(started_utc), '') FROM sessions",
        soci::into(stats.first_session_utc), soci::into(stats.last_session_utc);
    number(
        "SELECT coalesce(sum(t.sample_count / s.rate_Hz), 0.0) FROM trials t "
        "JOIN sessions s ON s.id = t.session_id",
        stats.recorded_s);
    number(
        "SELECT coalesce(sum(t.sample_count * (SELECT sum(1 + length(column_names) - "
        "length(replace(column_names, char(10), ''))) FROM signal_groups g "
        "WHERE g.trial_id = t.id)), 0) FROM trials t",
        stats.values);
    number("SELECT coalesce(sum(length(float64_shuffled_zstd)), 0) FROM signal_blocks",
           stats.signal_bytes);
    if (has_packs) {
      std::int64_t packs = 0;
      number("SELECT coalesce(sum(length(float64_shuffled_zstd)), 0) FROM signal_packs", packs);
      stats.signal_bytes += packs;
      number("SELECT count(*) FROM trials WHERE signals_blake2b IS NULL AND status <> 'running'",
             stats.trials_not_packed);
    } else {
      stats.trials_not_packed = stats.trials;
    }
    std::int64_t page_bytes = 0;
    number("PRAGMA page_size", page_bytes);
    number("PRAGMA freelist_count", stats.free_bytes);
    stats.free_bytes *= page_bytes;
  });
  if (!read) return read.error();
  for (const char* suffix : {"", "-wal"}) {
    std::error_code absent;
    const auto size = std::filesystem::file_size(database->real_path() + suffix, absent);
    if (!absent) stats.file_bytes += static_cast<std::int64_t>(size);
  }
  return stats;
}

}  // namespace isograsp::storage
