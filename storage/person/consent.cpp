// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/person/consent.hpp"

#include <algorithm>

#include <soci/soci.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/person/person_rows.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {

namespace {

template <class Names>
Result<void> check_word(const std::string& word, const char* field, const Names& names) {
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  std::string listed;
  for (const auto& name : names) listed += (listed.empty() ? "" : ", ") + std::string(name);
  return refused("'%1' is not known"_text(word), "give one of: %1"_text(listed)).about(field);
}

TextPlace place_of(const Consent& consent, const std::string& code) {
  return {sealed_column::kConsentText,
          code,
          {consent.on_date, consent.purpose, consent.basis, consent.state, consent.recorded_utc,
           consent.recorded_by}};
}

}  // namespace

Result<void> check_consent(const Consent& consent) {
  if (auto good = check_date(consent.on_date, "on_date"); !good) return good;
  if (auto good = check_word(consent.purpose, "purpose", kPurposes); !good) return good;
  if (auto good = check_word(consent.basis, "basis", kLawfulBases); !good) return good;
  return check_word(consent.state, "state", kConsentStates);
}

Result<RowId> add_consent(Access& access, const std::string& code, const Consent& consent) {
  if (const auto allowed = access.require(Right::write_records, "add consent", loggable(code));
      !allowed)
    return allowed.error();
  if (const auto good = check_consent(consent); !good) return good.error();
  const auto person = find_person(access, code);
  if (!person) return person.error();
  Consent sealed = consent;
  const auto user = access.user();
  sealed.recorded_utc = utc_text(std::time(nullptr));
  sealed.recorded_by = user ? user->name : "";
  if (const auto done =
          seal_text(*access.parts().login, sealed.text, place_of(sealed, person->code));
      !done)
    return done.error();
  RowId id = 0;
  const auto done = audited(
      access, "storing a consent"_text,
      entry_of("add consent", person->code,
               consent.purpose + ", " + consent.basis + ", " + consent.state),
      [&](AuditEntry&) {
        soci::session& sql = access.parts().database.sql();
        sql << "INSERT INTO consents (patient_id, on_date, purpose, basis, state, text, "
               "recorded_utc, recorded_by) VALUES (:id, :date, :purpose, :basis, :state, :text, "
               ":utc, :by)",
            soci::use(person->id), soci::use(sealed.on_date), soci::use(sealed.purpose),
            soci::use(sealed.basis), soci::use(sealed.state), soci::use(sealed.text),
            soci::use(sealed.recorded_utc), soci::use(sealed.recorded_by);
        sql << "SELECT max(id) FROM consents", soci::into(id);
      });
  if (!done) return done.error();
  return id;
}

Result<std::vector<Consent>> consents(Access& access, const std::string& code) {
  if (const auto allowed = access.require(Right::read_records, "read consent", loggable(code));
      !allowed)
    return allowed.error();
  const auto person = find_person(access, code);
  if (!person) return person.error();
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  std::vector<Consent> all;
  const auto done = parts.database.guard("reading consents"_text, [&] {
    Consent one;
    soci::statement select =
        (parts.database.sql().prepare
             << "SELECT id, on_date, purpose, basis, state, text, recorded_utc, recorded_by "
                "FROM consents WHERE patient_id = :id ORDER BY recorded_utc, id",
         soci::use(person->id), soci::into(one.id), soci::into(one.on_date),
         soci::into(one.purpose), soci::into(one.basis), soci::into(one.state),
         soci::into(one.text), soci::into(one.recorded_utc), soci::into(one.recorded_by));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  for (Consent& consent : all)
    if (const auto opened =
            open_text(*parts.login, consent.text, place_of(consent, person->code), parts.database);
        !opened)
      return opened.error();
  return all;
}

std::vector<Consent> standing(std::span<const Consent> recorded) {
  std::vector<Consent> last;
  for (const std::string_view purpose : kPurposes) {
    const auto of_purpose = [&](const Consent& one) { return one.purpose == purpose; };
    const auto newest = std::find_if(recorded.rbegin(), recorded.rend(), of_purpose);
    if (newest != recorded.rend()) last.push_back(*newest);
  }
  return last;
}

bool allow_cameras(std::span<const Consent> recorded) {
  return std::ranges::any_of(standing(recorded), [](const Consent& one) {
    return one.state == "given" &&
           std::ranges::find(kPurposesOfCameras, one.purpose) != kPurposesOfCameras.end();
  });
}

}  // namespace isograsp::storage
