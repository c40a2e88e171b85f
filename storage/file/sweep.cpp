// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/sweep.hpp"

#include <soci/soci.h>

namespace isograsp::storage {

Result<void> overwrite_what_is_removed(Database& database) {
  return database.guard("erasing"_text, [&] { database.sql() << "PRAGMA secure_delete=ON"; });
}

Result<void> sweep(Database& database) {
  return database.guard("rewriting the file"_text, [&] {
    soci::session& sql = database.sql();
    const auto checkpoint = [&] {
      int busy = 0;
      int unused = 0;
      sql << "PRAGMA wal_checkpoint(TRUNCATE)", soci::into(busy), soci::into(unused),
          soci::into(unused);
      if (busy != 0)
        throw Refusal{
            failed(
                "what was removed may still stand in the file and its log: another program reads "
                "them"_text,
                "close it, then do the same again"_text)
                .at(database.path())};
    };
    checkpoint();
    sql << "VACUUM";
    checkpoint();
  });
}

}  // namespace isograsp::storage
