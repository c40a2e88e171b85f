// SPDX-License-Identifier: GPL-3.0-or-later
// A database that was made to harm: blocks of nothing but zeros, small in the file and large in
// memory.
#pragma once

#include <string>
#include <vector>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/sqlite/block_codec.hpp"

namespace isograsp::test {

struct ZeroBlocks {
  int seconds = 0;          ///< blocks in each group
  std::size_t rows = 0;     ///< in each block
  std::size_t columns = 0;  ///< in each group
  int groups = 0;
};

/// The signals of the trial become these.
inline void plant_blocks(const std::string& database, long long trial_id, const ZeroBlocks& what) {
  const std::string bytes = storage::compress(
      storage::shuffle_rows(std::vector<double>(what.rows * what.columns), what.columns));
  soci::session sql(soci::sqlite3, database);
  soci::transaction whole(sql);
  sql << "UPDATE trials SET signals_blake2b = NULL WHERE id = :trial", soci::use(trial_id);
  for (const char* table : {"signal_packs", "signal_blocks", "signal_groups"})
    sql << "DELETE FROM " << table << " WHERE trial_id = :trial", soci::use(trial_id);
  std::string names = "c0";
  for (std::size_t c = 1; c < what.columns; ++c) names += "\nc" + std::to_string(c);
  const long long crc = storage::crc32(bytes);
  const auto row_count = static_cast<long long>(what.rows);
  for (int g = 0; g < what.groups; ++g) {
    const std::string name = "g" + std::to_string(g);
    sql << "INSERT INTO signal_groups (trial_id, position, name, column_names) "
           "VALUES (:trial, :position, :name, :names)",
        soci::use(trial_id), soci::use(g), soci::use(name), soci::use(names);
    for (int second = 0; second < what.seconds; ++second) {
      soci::blob data(sql);
      data.append(bytes.data(), bytes.size());
      sql << "INSERT INTO signal_blocks (trial_id, position, second, row_count, crc32, "
             "float64_shuffled_zstd) VALUES (:trial, :g, :s, :rows, :crc, :data)",
          soci::use(trial_id), soci::use(g), soci::use(second), soci::use(row_count),
          soci::use(crc), soci::use(data);
    }
  }
  whole.commit();
}

}  // namespace isograsp::test
