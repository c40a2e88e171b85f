// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/sealed_text.hpp"

#include <algorithm>
#include <bit>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/file/statement.hpp"

namespace isograsp::storage {

using namespace sqlite_api;

namespace {

std::string table_of(const SealedColumn& column) {
  const std::string name = column.name;
  return name.substr(0, name.find('.'));
}

std::string column_of(const SealedColumn& column) {
  const std::string name = column.name;
  return name.substr(name.find('.') + 1);
}

/// As row_words() says it.
std::string word_of(const RowValue& value) {
  if (value.kind == SQLITE_NULL) return "";
  if (value.kind == SQLITE_INTEGER) return std::to_string(static_cast<std::int64_t>(value.bits));
  if (value.kind == SQLITE_FLOAT) return row_word(std::bit_cast<double>(value.bits));
  return std::string(value.bytes);
}

std::string small_letters(std::string code) {
  for (char& c : code)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return code;
}

/// Programs of before wrote what a rating was in plain text where free text is sealed.
bool is_of_the_program(const StoredText& stored) {
  return std::string_view(stored.place.column.name) == sealed_column::kEventText.name &&
         stored.text.starts_with("Rating corrected: effort ");
}

}  // namespace

std::string row_word(double value) {
  return std::to_string(std::bit_cast<std::uint64_t>(value + 0.0));  // a REAL column has no -0.0
}

std::string row_word(std::optional<int> value) {
  return value ? std::to_string(*value) : "";
}

RowWords row_words(const PatientProfile& profile) {
  const auto name = [](const auto& one) { return one ? std::string(name_of(*one)) : ""; };
  return {name(profile.affected), name(profile.dominant), profile.onset_date, name(profile.sex),
          row_word(profile.birth_year)};
}

RowWords row_words(const TreatmentMark& mark) {
  return {mark.on_date, mark.kind};
}

RowWords row_words(const ClinicalScore& score) {
  return {score.on_date, score.scale, row_word(score.value)};
}

RowWords row_words(const PrimaryMeasure& primary) {
  return {primary.task_name, std::string(name_of(primary.hand)), primary.measure, primary.channel,
          primary.chosen_utc};
}

RowWords row_words(const StablePeriod& period) {
  return {period.from_date, period.until_date, period.judged_utc};
}

RowWords row_words(const EventPlace& place, const EventRecord& event) {
  return {place.session_uuid, place.trial_uuid, row_word(event.session_time_s)};
}

std::string bound_to(const LoginState& state, const TextPlace& place, int format) {
  if (format < kBoundToRowFormat)
    return state.database_id() + "\n" + place.column.name + "\n" + small_letters(place.code);
  // Each part with its length, so that no two places are alike.
  std::string all = "IsoGrasp text 2";
  const auto add = [&all](std::string_view part) {
    all += "\n" + std::to_string(part.size()) + "\n";
    all += part;
  };
  add(state.database_id());
  add(place.column.name);
  add(small_letters(place.code));
  for (const std::string& word : place.row) add(word);
  return all;
}

Result<void> seal_text(const LoginState& state, std::string& text, const TextPlace& place) {
  if (!state.is_protected() || text.empty()) return {};
  const Login login = state.login();
  if (!login.keys || login.keys->text.empty() || text == kWithheld)
    return refusal_of(state, Right::read_texts, "");
  text = seal(login.keys->text, bound_to(state, place), text);
  return {};
}

Result<void> open_text(const LoginState& state, std::string& text, const TextPlace& place,
                       const Database& database) {
  if (!state.is_protected() || text.empty()) return {};
  const Login login = state.login();
  if (!login.user || !login.keys || login.locked)
    return refusal_of(state, Right::read_texts, database.path());
  if (!may(login.user->role, Right::read_texts) || login.keys->text.empty()) {
    text = kWithheld;
    return {};
  }
  const auto opened = unseal(login.keys->text, bound_to(state, place, database.format()), text);
  if (!opened) return changed_text(place, database.path());
  text = opened->text();
  return {};
}

Error changed_text(const TextPlace& place, const std::string& path) {
  return failed("%1 of %2 was changed or is damaged"_text(place.column.name, place.code),
                "restore the last backup"_text)
      .at(path);
}

std::vector<StoredText> stored_texts(soci::session& sql, const SealedColumn& column) {
  const bool of_session = std::string_view(column.name) == sealed_column::kEventText.name;
  const std::string person =
      of_session ? "JOIN sessions s ON s.id = x.session_id JOIN patients p ON p.id = s.patient_id "
                   "WHERE x.kind = '" +
                       std::string(kSealedEvent) + "' AND"
                 : "JOIN patients p ON p.id = x.patient_id WHERE";
  const std::string text = "x." + column_of(column);
  Statement select(sql, "SELECT x.rowid, " + text + ", p.code, " + column.words + " FROM main." +
                            table_of(column) + " x " + person + " " + text + " <> ''");
  const int words = 1 + static_cast<int>(std::ranges::count(std::string_view(column.words), ','));
  constexpr int kFirstWord = 3;
  std::vector<StoredText> all;
  while (select.next()) {
    StoredText one{
        select.number(0), std::string(select.bytes(1)), {column, std::string(select.bytes(2)), {}}};
    for (int i = 0; i < words; ++i) one.place.row.push_back(word_of(select.value(kFirstWord + i)));
    all.push_back(std::move(one));
  }
  return all;
}

void replace_text(soci::session& sql, const StoredText& stored, const std::string& text) {
  const SealedColumn& column = stored.place.column;
  sql << "UPDATE main." + table_of(column) + " SET " + column_of(column) +
             " = :text WHERE rowid = :row",
      soci::use(text), soci::use(stored.row);
}

namespace {

/// As programs write it since texts are bound to rows.
void call_by_its_kind(soci::session& sql, const StoredText& of_the_program) {
  const std::string kind = kCorrectionEvent;
  sql << "UPDATE main.events SET kind = :kind WHERE id = :row", soci::use(kind),
      soci::use(of_the_program.row);
}

}  // namespace

void bind_texts_to_rows(Database& database, const LoginState& state) {
  if (!state.is_protected()) return;
  soci::session& sql = database.sql();
  const Login login = state.login();
  if (!login.keys || login.keys->text.empty() || login.keys->identity.empty())
    throw Refusal{refusal_of(state, Right::read_texts, database.path())};
  const auto bind = [&](const SealedColumn& column, const Secret& key) {
    for (const StoredText& stored : stored_texts(sql, column)) {
      if (is_of_the_program(stored)) {
        call_by_its_kind(sql, stored);
        continue;
      }
      const auto opened =
          unseal(key, bound_to(state, stored.place, kBoundToRowFormat - 1), stored.text);
      if (!opened) throw Refusal{changed_text(stored.place, database.path())};
      replace_text(sql, stored, seal(key, bound_to(state, stored.place), opened->text()));
    }
  };
  for (const SealedColumn& column : sealed_column::kAll) bind(column, login.keys->text);
  bind(sealed_column::kIdentity, login.keys->identity);
}

void bind_notes_to_rows(Database& database, const LoginState& state, std::span<const RowId> added) {
  if (!state.is_protected()) return;
  soci::session& sql = database.sql();
  const Login login = state.login();
  if (!login.keys || login.keys->text.empty())
    throw Refusal{refusal_of(state, Right::read_texts, database.path())};
  const Secret& key = login.keys->text;
  const auto is_added = [added](RowId row) { return std::ranges::find(added, row) != added.end(); };
  const std::vector<StoredText> all = stored_texts(sql, sealed_column::kEventText);
  const auto is_there = [&](const StoredText& note, std::string_view text) {
    return std::ranges::any_of(all, [&](const StoredText& other) {
      if (is_added(other.row) || other.place.row != note.place.row) return false;
      const auto said = unseal(key, bound_to(state, other.place), other.text);
      return said && said->text() == text;
    });
  };
  const auto remove = [&sql](RowId row) {
    sql << "DELETE FROM main.events WHERE id = :row", soci::use(row);
  };
  for (const StoredText& note : all) {
    if (!is_added(note.row)) continue;
    if (is_of_the_program(note)) {
      call_by_its_kind(sql, note);
      int there = 0;
      sql << "SELECT EXISTS (SELECT 1 FROM main.events a JOIN main.events b ON b.session_id = "
             "a.session_id AND b.trial_id IS a.trial_id AND b.session_time_s = a.session_time_s "
             "AND b.kind = a.kind AND b.text = a.text AND b.id < a.id WHERE a.id = :row)",
          soci::use(note.row), soci::into(there);
      if (there != 0) remove(note.row);
      continue;
    }
    const auto opened = unseal(key, bound_to(state, note.place, kBoundToRowFormat - 1), note.text);
    if (!opened) continue;
    if (is_there(note, opened->text()))
      remove(note.row);
    else
      replace_text(sql, note, seal(key, bound_to(state, note.place), opened->text()));
  }
}

}  // namespace isograsp::storage
