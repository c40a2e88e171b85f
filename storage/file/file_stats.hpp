// SPDX-License-Identifier: GPL-3.0-or-later
// How large a database is, and which parts are how large.
#pragma once

#include <cstdint>
#include <string>

#include "core/result.hpp"

namespace isograsp::storage {

struct FileStats {
  int format = 0;
  std::int64_t patients = 0;
  std::int64_t sessions = 0;
  std::int64_t trials = 0;
  std::int64_t trials_not_packed =
      0;  ///< closed, but still in blocks of a second (db migrate packs)
  std::int64_t measures = 0;
  std::int64_t events = 0;
  std::string first_session_utc;  ///< empty: no session
  std::string last_session_utc;
  double recorded_s = 0.0;        ///< of all trials
  std::int64_t values = 0;        ///< float64 that are stored: samples times columns
  std::int64_t file_bytes = 0;    ///< with the write-ahead log
  std::int64_t free_bytes = 0;    ///< of these, to be filled by the next trials
  std::int64_t signal_bytes = 0;  ///< as compressed
  /// Of the file without its free space, per minute of trial; 0: nothing is recorded.
  [[nodiscard]] double bytes_per_minute() const noexcept {
    constexpr double kMinute_s = 60.0;
    return recorded_s > 0.0 ? static_cast<double>(file_bytes - free_bytes) * kMinute_s / recorded_s
                            : 0.0;
  }
};

/// Reads the counts, not the signals.
[[nodiscard]] Result<FileStats> file_stats(const std::string& path);

}  // namespace isograsp::storage
