// SPDX-License-Identifier: GPL-3.0-or-later
// Who of the other file is who here: by UUID, or by a code of which it is said so. Who was erased
// in one of them does not come back.
#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include <soci/soci.h>

#include "storage/care/merge_tables.hpp"
#include "storage/file/database.hpp"

namespace isograsp::storage {

namespace {

class People {
 public:
  People(soci::session& sql, std::span<const std::string> same_patients, MergeReport& report)
      : sql_(sql), same_patients_(same_patients), report_(report) {}

  void merge() {
    auto ours = patients("main");
    RowId next = 0;
    for (const Patient& patient : ours) next = std::max(next, patient.id);
    for (const Patient& our : ours)
      if (was_erased("other", our.code))
        report_.conflicts.push_back(
            "patient %1 was erased in the other file on request: erase it here, too"_text(
                our.code));
    std::set<std::string> used;
    for (const Patient& theirs : patients("other")) {
      std::vector<Patient*> known;
      Patient* same = nullptr;
      for (Patient& our : ours) {
        if (std::any_of(theirs.uuids.begin(), theirs.uuids.end(),
                        [&](const std::string& uuid) { return our.uuids.contains(uuid); }))
          known.push_back(&our);
        if (same_code(our.code, theirs.code)) same = &our;
      }
      const bool told = std::any_of(same_patients_.begin(), same_patients_.end(),
                                    [&](const auto& code) { return same_code(code, theirs.code); });
      if (told) used.insert(lower(theirs.code));
      if (known.size() > 1 || (!known.empty() && known.front() != same)) {
        report_.conflicts.push_back(
            "patient %1 is %2 here: their codes must agree"_text(theirs.code, known.front()->code));
      } else if (same != nullptr && known.empty() && !told) {
        report_.conflicts.push_back(
            "the code %1 was given in both files separately: only if it is the same person, say "
            "--same-patient %2"_text(theirs.code, theirs.code));
      } else if (same != nullptr) {
        join(*same, theirs);
        number(theirs.id, same->id, false);
      } else if (was_erased("main", theirs.code)) {
        report_.conflicts.push_back(
            "patient %1 was erased here on request and must not come back"_text(theirs.code));
      } else {
        number(theirs.id, ++next, true);
        add_patient(theirs, next);
      }
    }
    for (const std::string& code : same_patients_)
      if (!used.contains(lower(code)))
        throw Refusal{
            refused("patient %1 is not in both files"_text(code), "give a code that both have"_text)
                .about("--same-patient")};
    take_tombstones();
  }

 private:
  struct Patient {
    RowId id = 0;
    std::string code;
    std::string created_utc;
    std::set<std::string> uuids;
  };

  std::vector<Patient> patients(const std::string& file) {
    std::vector<Patient> all;
    {
      Patient one;
      std::string uuid;
      const std::string query = "SELECT id, code, created_utc, uuid FROM " + file +
                                ".patients "
                                "ORDER BY id";
      soci::statement select = (sql_.prepare << query, soci::into(one.id), soci::into(one.code),
                                soci::into(one.created_utc), soci::into(uuid));
      select.execute();
      while (select.fetch()) {
        one.uuids = {uuid};
        all.push_back(one);
      }
    }
    RowId id = 0;
    std::string alias;
    const std::string query = "SELECT patient_id, uuid FROM " + file + ".patient_aliases";
    soci::statement select = (sql_.prepare << query, soci::into(id), soci::into(alias));
    select.execute();
    while (select.fetch())
      for (Patient& patient : all)
        if (patient.id == id) patient.uuids.insert(alias);
    return all;
  }

  static bool same_code(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
      return std::tolower(x) == std::tolower(y);
    });
  }

  bool was_erased(const std::string& file, const std::string& code) {
    int stones = 0;
    sql_ << "SELECT count(*) FROM " + file + ".tombstones WHERE code = :code COLLATE NOCASE",
        soci::use(code), soci::into(stones);
    return stones > 0;
  }

  /// Who was erased in one file is erased in both; the first time counts.
  void take_tombstones() {
    sql_ << "INSERT INTO main.tombstones (code, erased_utc, erased_by) "
            "SELECT code, erased_utc, erased_by FROM other.tombstones WHERE true ORDER BY id "
            "ON CONFLICT (code) DO UPDATE SET code = excluded.code, "
            "erased_utc = excluded.erased_utc, erased_by = excluded.erased_by WHERE "
            "(excluded.erased_utc, excluded.erased_by, excluded.code) < "
            "(erased_utc, erased_by, code)";
  }

  static std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }

  /// The same person under two UUIDs: whichever file is taken into the other, the smaller one is
  /// theirs and the other is known.
  void join(Patient& ours, const Patient& theirs) {
    ours.uuids.insert(theirs.uuids.begin(), theirs.uuids.end());
    ours.created_utc = std::min(ours.created_utc, theirs.created_utc);
    ours.code = std::min(ours.code, theirs.code);
    sql_ << "DELETE FROM main.patient_aliases WHERE patient_id = :id", soci::use(ours.id);
    sql_ << "UPDATE main.patients SET uuid = :uuid, created_utc = :created, code = :code "
            "WHERE id = :id",
        soci::use(*ours.uuids.begin()), soci::use(ours.created_utc), soci::use(ours.code),
        soci::use(ours.id);
    add_aliases(ours, ours.id);
  }

  void add_patient(const Patient& theirs, RowId id) {
    sql_ << "INSERT INTO main.patients (id, code, created_utc, uuid, salt) "
            "SELECT :id, :code, :created, :uuid, salt FROM other.patients WHERE id = :there",
        soci::use(id), soci::use(theirs.code), soci::use(theirs.created_utc),
        soci::use(*theirs.uuids.begin()), soci::use(theirs.id);
    add_aliases(theirs, id);
    ++report_.patients_added;
  }

  void add_aliases(const Patient& of, RowId id) {
    for (auto uuid = std::next(of.uuids.begin()); uuid != of.uuids.end(); ++uuid)
      sql_ << "INSERT INTO main.patient_aliases (uuid, patient_id) VALUES (:uuid, :id)",
          soci::use(*uuid), soci::use(id);
  }

  void number(RowId there, RowId own, bool added) {
    const int mark = added ? 1 : 0;
    sql_ << "INSERT INTO temp.numbers VALUES ('patients', :there, :here, :added)", soci::use(there),
        soci::use(own), soci::use(mark);
  }

  soci::session& sql_;
  std::span<const std::string> same_patients_;
  MergeReport& report_;
};

}  // namespace

void merge_people(soci::session& sql, std::span<const std::string> same_patients,
                  MergeReport& report) {
  People(sql, same_patients, report).merge();
}

}  // namespace isograsp::storage
