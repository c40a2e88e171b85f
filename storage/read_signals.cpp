// SPDX-License-Identifier: GPL-3.0-or-later
// Signals of a trial: its blocks, checked, put side by side.
#include <algorithm>

#include <soci/soci.h>

#include "storage/block_codec.hpp"
#include "storage/sqlite_store.hpp"

namespace isograsp {

Result<Signals> SqliteStore::signals(const TrialRecord& trial) {
  Signals signals;
  const auto done = database_.guard("reading signals", [&] {
    soci::session& sql = database_.sql();
    const auto damaged = [&](const std::string& group, int second, const std::string& what) {
      return Refusal{{Error::Code::failed,
                      "trial " + std::to_string(trial.number) + " of session " +
                          std::to_string(trial.session_id) + ", group " + group + ", second " +
                          std::to_string(second) + ": " + what,
                      "restore the last backup; other trials can still be read", path(), 0, ""}};
    };
    const auto wanted = static_cast<std::size_t>(trial.samples);
    for (std::size_t g = 0; g < trial.groups.size(); ++g) {
      const SignalGroup& group = trial.groups[g];
      const std::size_t column_count = group.columns.size();
      std::vector<std::vector<double>> columns(column_count);
      for (auto& column : columns) column.reserve(wanted);
      const int position = static_cast<int>(g);
      int second = 0;
      long long row_count = 0;
      long long crc = 0;
      soci::blob data(sql);
      soci::statement select =
          (sql.prepare << "SELECT second, row_count, crc32, float64_shuffled_zstd "
                          "FROM signal_blocks WHERE trial_id = :trial AND position = :position "
                          "ORDER BY second",
           soci::use(trial.id), soci::use(position), soci::into(second), soci::into(row_count),
           soci::into(crc), soci::into(data));
      select.execute();
      int expected = 0;
      std::string bytes;
      while (columns[0].size() < wanted && select.fetch()) {
        if (second != expected) throw damaged(group.name, expected, "the block is missing");
        ++expected;
        bytes.resize(data.get_len());
        data.read(0, bytes.data(), bytes.size());
        if (crc32(bytes) != crc)
          throw damaged(group.name, second, "the block is damaged (checksum)");
        const auto rows = decode_block(bytes, static_cast<std::size_t>(row_count), column_count);
        if (!rows) throw damaged(group.name, second, "the block is damaged (content)");
        for (std::size_t c = 0; c < column_count; ++c)
          for (std::size_t i = c; i < rows->size(); i += column_count)
            columns[c].push_back((*rows)[i]);
      }
      if (columns[0].size() != wanted) throw damaged(group.name, expected, "the block is missing");
      for (std::size_t c = 0; c < column_count; ++c)
        signals.add_column(group.columns[c], std::move(columns[c]));
    }
  });
  if (!done) return done.error();
  return signals;
}

}  // namespace isograsp
