// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp db identity, consent, erase, person: what the clinic owes one person.
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/db/db_commands.hpp"
#include "app/db/person_export.hpp"
#include "core/files.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/erasure.hpp"
#include "storage/person/identity.hpp"
#include "storage/records/patient_code.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct PersonOptions {
  AccessOptions common;
  std::string patient;
  std::string from;
  std::string emergency;
  std::string out;
  std::string reason;
  bool plan = false;
  bool lift = false;
  bool is_new = false;
  storage::Consent consent;
};

constexpr Words kIdentityShape =
    "give {\"name\": \"…\", \"birth_date\": \"1950-03-05\", \"contact\": \"…\"}"_text;

/// Errors never repeat what the file holds.
Result<storage::Identity> read_identity_file(const std::string& path) {
  constexpr std::size_t kMost = std::size_t{64} << 10;
  auto text = read_text(path);
  if (!text) return text.error();
  if (text->size() > kMost) return refused("is larger than 64 KiB"_text, kIdentityShape).at(path);
  const Json json = Json::parse(*text, nullptr, false);
  (void)storage::Secret::taken_from(*text);
  if (!json.is_object()) return refused("is no JSON object"_text, kIdentityShape).at(path);
  storage::Identity identity;
  for (const auto& [key, value] : json.items()) {
    std::string* const field = key == "name"         ? &identity.name
                               : key == "birth_date" ? &identity.birth_date
                               : key == "contact"    ? &identity.contact
                                                     : nullptr;
    if (field == nullptr)
      return refused("has a key other than name, birth_date, contact"_text, kIdentityShape)
          .at(path);
    if (!value.is_string())
      return refused("holds something other than text"_text, kIdentityShape).at(path);
    *field = value.get<std::string>();
  }
  return identity;
}

Result<void> show(storage::Access& access, const PersonOptions& options) {
  const auto identity = storage::read_identity(access, options.patient, options.emergency);
  if (!identity) return identity.error();
  if (!*identity) {
    print_answer(options.common.json, {{"patient", options.patient}, {"identity", nullptr}},
                 "%1: not told"_text(options.patient));
    return {};
  }
  const storage::Identity& one = **identity;
  Lines text = one.birth_date.empty()
                   ? "%1: %2"_text(options.patient, one.name)
                   : "%1: %2, born %3"_text(options.patient, one.name, one.birth_date);
  if (!one.contact.empty()) text.add_row(one.contact);
  print_answer(options.common.json,
               {{"patient", options.patient},
                {"identity",
                 {{"name", one.name}, {"birth_date", one.birth_date}, {"contact", one.contact}}}},
               text);
  return {};
}

Result<void> set(storage::Access& access, const PersonOptions& options) {
  const auto identity = read_identity_file(options.from);
  if (!identity) return identity.error();
  if (auto done = storage::set_identity(access, options.patient, *identity); !done) return done;
  print_answer(options.common.json, {{"patient", options.patient}, {"stored", true}},
               "%1: identity stored"_text(options.patient));
  return {};
}

Result<void> list_consents(storage::Access& access, const PersonOptions& options) {
  const auto all = storage::consents(access, options.patient);
  if (!all) return all.error();
  Json json = Json::array();
  Lines text;
  for (const storage::Consent& one : *all) {
    json.push_back({{"on_date", one.on_date},
                    {"purpose", one.purpose},
                    {"basis", one.basis},
                    {"state", one.state},
                    {"text", one.text},
                    {"recorded_utc", one.recorded_utc},
                    {"recorded_by", one.recorded_by}});
    text.add_row(one.on_date + "  " + one.purpose + "  " + one.state + "  (" + one.basis + ")" +
                 (one.text.empty() ? "" : "  " + one.text));
  }
  print_answer(options.common.json, json, text.empty() ? Lines("nothing recorded"_text) : text);
  return {};
}

Result<void> record_consent(storage::Access& access, const PersonOptions& options) {
  if (options.is_new) {
    if (auto good = storage::check_patient_code(options.patient); !good) return good;
    auto store = storage::open_store(options.common.file, storage::OpenMode::existing);
    if (!store) return store.error();
    if (const auto added = (*store)->add_patient(options.patient); !added) return added.error();
  }
  const auto id = storage::add_consent(access, options.patient, options.consent);
  if (!id) return id.error();
  print_answer(options.common.json, {{"patient", options.patient}, {"stored", true}},
               "%1: %2 %3"_text(options.patient, options.consent.purpose, options.consent.state));
  return {};
}

void print_erasure(const PersonOptions& options, const storage::ErasureDone& done) {
  const storage::ErasurePlan& plan = done.plan;
  Json json{{"patient", plan.code},
            {"erased", done.erased},
            {"swept", done.erased && !done.not_swept},
            {"restricted", plan.restricted},
            {"may_erase", plan.may_erase},
            {"last_record_date", plan.last_record_date},
            {"keep_until_date", plan.keep_until_date},
            {"rows", Json::object()},
            {"remains", done.remains}};
  Lines text;
  if (done.erased) {
    text.add("%1: erased"_text(plan.code));
    for (const auto& [table, rows] : done.rows) {
      json["rows"][table] = rows;
      text.add("  %1 of %2"_text(rows, table));
    }
  } else if (plan.restricted) {
    text.add(
        "%1: restricted; the law asks to keep the records until %2, erase again after that day"_text(
            plan.code, plan.keep_until_date));
  } else {
    text.add(plan.may_erase
                 ? "%1: last record of %2, to be kept until %3; would be erased now"_text(
                       plan.code, plan.last_record_date, plan.keep_until_date)
                 : "%1: last record of %2, to be kept until %3; would be restricted now"_text(
                       plan.code, plan.last_record_date, plan.keep_until_date));
  }
  if (!done.remains.empty()) {
    text.add("What may still hold the person, and is for you to remove:"_text);
    for (const auto& one : done.remains) text.add_row("  " + one);
  }
  print_answer(options.common.json, json, text);
}

Result<void> erase(storage::Access& access, const PersonOptions& options) {
  if (options.plan) {
    const auto plan = storage::plan_erasure(access, options.patient);
    if (!plan) return plan.error();
    storage::ErasureDone nothing;
    nothing.plan = *plan;
    print_erasure(options, nothing);
    return {};
  }
  if (options.lift) {
    if (auto done = storage::lift_restriction(access, options.patient, options.reason); !done)
      return done;
    print_answer(options.common.json, {{"patient", options.patient}, {"restricted", false}},
                 "%1: no longer restricted"_text(options.patient));
    return {};
  }
  const auto done = storage::erase_patient(access, options.patient, options.reason);
  if (!done) return done.error();
  print_erasure(options, *done);
  if (done->not_swept) return *done->not_swept;
  return {};
}

Result<void> person(storage::Access& access, const PersonOptions& options) {
  const auto trials = export_person(access, options.patient, options.out);
  if (!trials) return trials.error();
  print_answer(
      options.common.json,
      {{"patient", options.patient}, {"out", options.out}, {"trials", *trials}},
      "%1: all of it, with %2 trials, written to %3"_text(options.patient, *trials, options.out));
  return {};
}

}  // namespace

void add_db_person(Subcommand db) {
  auto options = std::make_shared<PersonOptions>();
  const auto add_one = [&](Subcommand parent, const char* name, const char* description,
                           const char* example, auto work) {
    Subcommand command =
        add_access_command<PersonOptions>(parent, name, description, example, options, work);
    command.option("--patient", options->patient, "Patient code").required();
    return command;
  };
  Subcommand identity = db.subcommand("identity", "Who a code is (protected databases)");
  identity.requires_subcommand();
  add_one(identity, "show", "Name, birth date, contact; the reading is logged",
          "identity show clinic.db --patient P-0427 --user Ada --password-file ADA", show)
      .option("--emergency", options->emergency, "Reason to see a restricted person; it is logged");
  add_one(identity, "set", "Store it",
          "identity set clinic.db --patient P-0427 --from person.json --user Ada "
          "--password-file ADA",
          set)
      .option("--from", options->from, "JSON file with name, birth_date, contact")
      .required();

  Subcommand consent = db.subcommand("consent", "Lawful basis and consent");
  consent.requires_subcommand();
  add_one(consent, "list", "What was said, in order", "consent list clinic.db --patient P-0427",
          list_consents);
  Subcommand add = add_one(consent, "add", "Record it",
                           "consent add clinic.db --patient P-0427 --purpose research --basis "
                           "consent --state given --date 2026-03-05",
                           record_consent);
  add.option("--purpose", options->consent.purpose, "treatment, research or teaching").required();
  add.option("--basis", options->consent.basis,
             "consent, contract, legal_obligation, vital_interests, public_interest, "
             "legitimate_interest, care or research")
      .required();
  add.option("--state", options->consent.state, "given, refused or withdrawn").required();
  add.option("--date", options->consent.on_date, "Day it was said, e.g. 2026-03-05").required();
  add.option("--text", options->consent.text, "Such as the version of the form");
  add.flag("--new", options->is_new, "The patient code is new: make its record");

  Subcommand erased =
      add_one(db, "erase", "Restrict or erase a person's records on request",
              "erase clinic.db --patient P-0427 --reason 'letter of 5 March'", erase);
  erased.option("--reason", options->reason, "Logged: name nobody");
  erased.flag("--plan", options->plan, "Only say what would happen");
  erased.flag("--lift", options->lift, "End a restriction");

  add_one(db, "person", "All that is stored about one person, for that person",
          "person clinic.db --patient P-0427 --out P-0427 --passphrase-file P", person)
      .option("--out", options->out, "Folder to make")
      .required();
}

}  // namespace isograsp::app
