// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/person/person_rows.hpp"

#include <algorithm>

#include <soci/soci.h>

#include "storage/access/login.hpp"
#include "storage/records/patient_code.hpp"

namespace isograsp::storage {

PersonRow required_person(soci::session& sql, const std::string& code) {
  PersonRow person;
  sql << "SELECT id, code, created_utc, coalesce((SELECT until_date FROM restrictions "
         "WHERE patient_id = patients.id), '') FROM patients WHERE code = :code",
      soci::use(code), soci::into(person.id), soci::into(person.code),
      soci::into(person.created_utc), soci::into(person.restricted_until);
  if (!sql.got_data())
    throw Refusal{refused("there is no patient of this code"_text, "see the list of patients"_text)
                      .about("patient code")};
  return person;
}

Result<PersonRow> find_person(Access& access, const std::string& code) {
  if (const auto good = check_patient_code(code); !good) return good.error();
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  PersonRow person;
  const auto done = parts.database.guard(
      "reading a patient"_text, [&] { person = required_person(parts.database.sql(), code); });
  if (!done) return done.error();
  return person;
}

std::string loggable(const std::string& code) {
  return check_patient_code(code) ? code : "";
}

Result<void> check_reason(const std::string& reason) {
  constexpr std::size_t kMost = 200;
  const bool one_line = std::none_of(reason.begin(), reason.end(),
                                     [](char c) { return static_cast<unsigned char>(c) < ' '; });
  if (reason.empty() || reason.size() > kMost || !one_line)
    return refused(reason.empty() ? "no reason is given"_text
                                  : "is no reason of one line of 200 bytes"_text,
                   "say in a few words why; it is logged, so name nobody"_text)
        .about("reason");
  return {};
}

}  // namespace isograsp::storage
