// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/person/identity.hpp"

#include <algorithm>

#include <soci/soci.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/person/person_rows.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {

namespace {

constexpr char kBetween = '\0';

/// Errors of an identity never repeat it.
Identity identity_in(const Secret& opened) {
  const std::string_view all = opened.text();
  const std::size_t first = all.find(kBetween);
  const std::size_t second = all.find(kBetween, first + 1);
  return {std::string(all.substr(0, first)), std::string(all.substr(first + 1, second - first - 1)),
          std::string(all.substr(second + 1))};
}

/// As the file holds it.
struct SealedIdentity {
  std::string code;
  std::string changed_utc;
  std::string sealed;
};

TextPlace place_of(const SealedIdentity& identity) {
  return {sealed_column::kIdentity, identity.code, {identity.changed_utc}};
}

Result<Identity> open_identity(Access& access, const SealedIdentity& stored) {
  const Login login = access.parts().login->login();
  if (!login.keys || login.keys->identity.empty())
    return refusal_of(*access.parts().login, Right::identities, access.path());
  const auto opened =
      unseal(login.keys->identity,
             bound_to(*access.parts().login, place_of(stored), access.parts().database.format()),
             stored.sealed);
  if (!opened || std::count(opened->text().begin(), opened->text().end(), kBetween) != 2)
    return failed("the identity of %1 was changed or is damaged"_text(stored.code),
                  "restore the last backup"_text)
        .at(access.path());
  return identity_in(*opened);
}

/// What cannot be logged is not shown.
Result<void> require_log(Access& access) {
  if (access.parts().writable) return {};
  return failed("cannot be written, so the reading of an identity could not be logged"_text,
                "copy the file to where you may write"_text)
      .at(access.path());
}

struct Reading {
  const char* act;
  std::string detail;
  bool though_restricted;
};

Result<std::optional<Identity>> read_logged(Access& access, const std::string& code,
                                            const Reading& reading) {
  if (const auto allowed = access.require(Right::identities, reading.act, loggable(code)); !allowed)
    return allowed.error();
  if (const auto log = require_log(access); !log) return log.error();
  const auto person = find_person(access, code);
  if (!person) return person.error();
  AuditEntry entry = entry_of(reading.act, person->code, reading.detail);
  const bool closed = !person->restricted_until.empty() && !reading.though_restricted;
  if (closed) entry.result = "refused";
  SealedIdentity stored{person->code, "", ""};
  const auto done =
      audited(access, "reading an identity"_text, entry, [&](AuditEntry&) {
        access.parts().database.sql()
            << "SELECT changed_utc, sealed FROM identities WHERE patient_id = :id",
            soci::use(person->id), soci::into(stored.changed_utc), soci::into(stored.sealed);
        if (!access.parts().database.sql().got_data()) stored.sealed.clear();
      });
  if (!done) return done.error();
  if (closed)
    return refused("the records of %1 are restricted until %2"_text(person->code,
                                                                    person->restricted_until),
                   "in an emergency give the reason; it is logged"_text)
        .about("patient code");
  if (stored.sealed.empty()) return std::optional<Identity>();
  const auto identity = open_identity(access, stored);
  if (!identity) return identity.error();
  return std::optional(*identity);
}

}  // namespace

Result<void> check_identity(const Identity& identity) {
  const auto check = [](const std::string& text, const char* field, bool lines) -> Result<void> {
    if (text.size() > kMostIdentityText)
      return refused("is longer than 4096 bytes"_text, "shorten it"_text).about(field);
    const bool printable = std::none_of(text.begin(), text.end(), [lines](char c) {
      return static_cast<unsigned char>(c) < ' ' && !(lines && c == '\n');
    });
    if (!printable) return refused("holds a control character"_text, "remove it"_text).about(field);
    return {};
  };
  if (identity.name.empty())
    return refused("is empty"_text, "give the person's name"_text).about("name");
  if (auto good = check(identity.name, "name", false); !good) return good;
  if (auto good = check(identity.contact, "contact", true); !good) return good;
  if (identity.birth_date.empty()) return {};
  if (!check_date(identity.birth_date, "birth_date"))
    return refused("is no day of the calendar in the years 1900 to 2099"_text,
                   "give year, month and day, such as 1950-03-05"_text)
        .about("birth_date");
  return {};
}

Result<void> set_identity(Access& access, const std::string& code, const Identity& identity) {
  if (auto allowed = access.require(Right::identities, "change identity", loggable(code)); !allowed)
    return allowed;
  if (auto good = check_identity(identity); !good) return good;
  const auto person = find_person(access, code);
  if (!person) return person.error();
  std::string text = identity.name + kBetween + identity.birth_date + kBetween + identity.contact;
  const Secret secret = Secret::taken_from(text);
  const Login login = access.parts().login->login();  // another thread may have logged out by now
  if (!login.keys || login.keys->identity.empty())
    return refusal_of(*access.parts().login, Right::identities, access.path());
  SealedIdentity stored{person->code, utc_text(std::time(nullptr)), ""};
  stored.sealed =
      seal(login.keys->identity, bound_to(*access.parts().login, place_of(stored)), secret.text());
  return audited(access, "storing an identity"_text, entry_of("change identity", person->code),
                 [&](AuditEntry&) {
                   access.parts().database.sql()
                       << "INSERT INTO identities (patient_id, changed_utc, sealed) "
                          "VALUES (:id, :utc, :sealed) ON CONFLICT (patient_id) DO UPDATE SET "
                          "changed_utc = excluded.changed_utc, sealed = excluded.sealed",
                       soci::use(person->id), soci::use(stored.changed_utc),
                       soci::use(stored.sealed);
                 });
}

Result<std::optional<Identity>> read_identity(Access& access, const std::string& code,
                                              const std::string& emergency) {
  if (emergency.empty()) return read_logged(access, code, {"read identity", "", false});
  if (const auto good = check_reason(emergency); !good) return good.error();
  return read_logged(access, code, {"emergency access", emergency, true});
}

Result<std::optional<Identity>> read_identity_for_person(Access& access, const std::string& code) {
  return read_logged(access, code, {"read identity", "for the person's own copy", true});
}

Result<std::vector<std::pair<std::string, Identity>>> all_identities(Access& access) {
  if (const auto allowed = access.require(Right::identities, "read all identities", ""); !allowed)
    return allowed.error();
  if (const auto log = require_log(access); !log) return log.error();
  std::vector<SealedIdentity> sealed;
  const auto done = audited(
      access, "reading identities"_text, entry_of("read all identities", ""),
      [&](AuditEntry& entry) {
        SealedIdentity one;
        soci::statement select =
            (access.parts().database.sql().prepare
                 << "SELECT p.code, i.changed_utc, i.sealed FROM identities i JOIN patients p "
                    "ON p.id = i.patient_id WHERE p.id NOT IN "
                    "(SELECT patient_id FROM restrictions) ORDER BY p.id",
             soci::into(one.code), soci::into(one.changed_utc), soci::into(one.sealed));
        select.execute();
        while (select.fetch()) sealed.push_back(one);
        entry.detail = std::to_string(sealed.size()) + " people";
      });
  if (!done) return done.error();
  std::vector<std::pair<std::string, Identity>> all;
  for (const SealedIdentity& stored : sealed) {
    const auto identity = open_identity(access, stored);
    if (!identity) return identity.error();
    all.emplace_back(stored.code, *identity);
  }
  return all;
}

}  // namespace isograsp::storage
