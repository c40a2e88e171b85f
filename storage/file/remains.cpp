// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/remains.hpp"

#include <soci/soci.h>

namespace isograsp::storage {

std::vector<std::string> remains_of(soci::session& sql, const std::string& code,
                                    const std::string& since_utc, const std::string& until_utc) {
  std::vector<std::string> remains;
  std::string act;
  std::string object;
  std::string detail;
  std::string at_utc;
  // A merge names the other file, a restore the backup and the file that was kept. Who exported all
  // people named no code.
  soci::statement select =
      (sql.prepare
           << "SELECT at_utc, act, object, detail FROM audit_log WHERE result = 'done' AND "
              "at_utc <= :until AND ((act IN ('backup', 'migrate', 'restore', 'merge') AND "
              "at_utc >= :since) OR (act IN ('export', 'export person', 'print', 'report', "
              "'study') "
              "AND (:all = '' OR object = '' OR object = :code COLLATE NOCASE))) ORDER BY id",
       soci::use(until_utc), soci::use(since_utc), soci::use(code), soci::use(code),
       soci::into(at_utc), soci::into(act), soci::into(object), soci::into(detail));
  select.execute();
  while (select.fetch()) {
    const bool named = act == "backup" || act == "migrate" || act == "merge";
    const std::string& file = named ? object : detail;
    remains.push_back(act + " of " + at_utc + (file.empty() ? "" : ": " + file));
  }
  return remains;
}

}  // namespace isograsp::storage
