// SPDX-License-Identifier: GPL-3.0-or-later
// A sealed text is bound to what its row says: carried into another row, or left in a row that says
// something else, it is refused when it is read, and `db check` names the row.
#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/sealed_text.hpp"
#include "storage/care/migration.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::bound_texts_test {
namespace {

namespace fs = std::filesystem;

/// tests/data/format_9_protected.db: made by the last program that wrote format 9. Two people with
/// two rows of everything that holds a sealed text, and a trial that was left running.
const std::string kOlder = ISOGRASP_SOURCE_DIR "/tests/data/format_9_protected.db";
const std::array<std::string, 2> kCodes{"P-0427", "P-0428"};
constexpr std::size_t kTexts = 34;

std::vector<SealedColumn> all_columns() {
  std::vector<SealedColumn> all(sealed_column::kAll.begin(), sealed_column::kAll.end());
  all.push_back(sealed_column::kIdentity);
  return all;
}

std::vector<StoredText> texts_in(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::vector<StoredText> all;
  for (const SealedColumn& column : all_columns())
    std::ranges::move(stored_texts(sql, column), std::back_inserter(all));
  return all;
}

std::string table_of(const StoredText& text) {
  const std::string name = text.place.column.name;
  return name.substr(0, name.find('.'));
}

struct BoundTexts : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<Access> access;

  BoundTexts() { fs::copy_file(kOlder, path); }
  [[nodiscard]] Result<Migration> migrate(const char* name = "Theo") const {
    const auto before = must(Access::open_to_migrate(path));
    std::string password = std::string(name) + "'s password";
    password[0] = static_cast<char>(password[0] - 'A' + 'a');
    must(before->log_in(name, secret(password.c_str())));
    return migrate_database(path);
  }
  void migrated() {
    must(migrate());
    access = must(Access::open(path));
    must(access->log_in("Ada", secret("ada's password")));
  }
  /// What the readers of a column say of a person; empty: they read.
  [[nodiscard]] std::string reading(const StoredText& text) const {
    const auto store = opened(path, OpenMode::read_only);
    const std::string& code = text.place.code;
    const RowId patient = must(store->find_patient(code))->id;
    const std::string table = table_of(text);
    if (table == "patient_profiles") return refusal(store->profile(patient));
    if (table == "treatment_marks") return refusal(store->treatment_marks(patient));
    if (table == "clinical_scores") return refusal(store->clinical_scores(patient));
    if (table == "primary_measures") return refusal(store->primary_measures(patient));
    if (table == "stable_periods") return refusal(store->stable_periods(patient));
    if (table == "consents") return refusal(consents(*access, code));
    if (table == "identities") return refusal(read_identity(*access, code));
    std::string of_events;
    for (const SessionRecord& session : test::every(must(store->sessions(patient))))
      of_events += refusal(store->events(session.id));
    return of_events;
  }
  void expect_refused(const StoredText& text) const {
    const std::string said = reading(text);
    const bool named = table_of(text) == "identities"
                           ? said.find("the identity of " + text.place.code) != std::string::npos
                           : said.find(table_of(text) + ".") != std::string::npos &&
                                 said.find(" of " + text.place.code) != std::string::npos;
    EXPECT_TRUE(named) << text.place.column.name << ", row " << text.row << ": '" << said << "'";
  }
  [[nodiscard]] std::vector<std::string> problems() const {
    std::vector<std::string> all;
    for (const Text& one : must(opened(path, OpenMode::read_only)->check()))
      all.push_back(english(one));
    return all;
  }
  static std::string row_of(const StoredText& text) {
    return table_of(text) + ": row " + std::to_string(text.row) + " is not what isograsp wrote";
  }
};

/// Somebody who has the file and no password.
struct Attacker {
  explicit Attacker(const std::string& path) : sql(soci::sqlite3, "db=\"" + path + "\"") {
    sql << "PRAGMA synchronous=OFF";
    sql << "PRAGMA ignore_check_constraints=ON";
    sql << "PRAGMA foreign_keys=OFF";
  }
  soci::session sql;
};

TEST_F(BoundTexts, AnyTwoThatAreSwappedAreRefusedAtReadingAndNamed) {
  migrated();
  const std::vector<StoredText> all = texts_in(path);
  ASSERT_EQ(all.size(), kTexts) << "of every column, of two rows, of two people";
  for (const StoredText& text : all) ASSERT_EQ(reading(text), "");
  Attacker attacker(path);
  int swapped = 0;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      replace_text(attacker.sql, all[a], all[b].text);
      replace_text(attacker.sql, all[b], all[a].text);
      expect_refused(all[a]);
      expect_refused(all[b]);
      // The check takes longer than all else: of every pair of one column, and some of the others.
      constexpr std::size_t kSome = 7;
      if (all[a].place.column.name == all[b].place.column.name || (a + b) % kSome == 0) {
        const auto named = problems();
        for (const StoredText* one : {&all[a], &all[b]})
          EXPECT_EQ(std::ranges::count(named, row_of(*one)), 1) << row_of(*one);
      }
      replace_text(attacker.sql, all[a], all[a].text);
      replace_text(attacker.sql, all[b], all[b].text);
      ++swapped;
    }
  EXPECT_EQ(swapped, static_cast<int>(kTexts * (kTexts - 1) / 2));
  EXPECT_EQ(problems(), std::vector<std::string>{});
}

/// SQL: another value of the same kind.
std::string changed(const std::string& column) {
  if (column == "hand") return "CASE hand WHEN 'left' THEN 'right' ELSE 'left' END";
  return "CASE typeof(" + column + ") WHEN 'text' THEN " + column + " || 'x' ELSE " + column +
         " + 1 END";
}

TEST_F(BoundTexts, ARowThatIsMadeToSaySomethingElseLosesThem) {
  migrated();
  Attacker attacker(path);
  test::AtLeast tried(20);
  for (const StoredText& text : texts_in(path)) {
    std::istringstream words(text.place.column.words);
    std::string word;
    while (std::getline(words, word, ',')) {
      word.erase(0, word.find_first_not_of(' '));
      if (!word.starts_with("x.")) continue;
      const std::string column = word.substr(2);
      const std::string row = " WHERE rowid = " + std::to_string(text.row);
      attacker.sql << "BEGIN";
      attacker.sql << "CREATE TEMP TABLE kept AS SELECT " + column + " FROM main." +
                          table_of(text) + row;
      attacker.sql << "UPDATE main." + table_of(text) + " SET " + column + " = " + changed(column) +
                          row;
      attacker.sql << "COMMIT";
      expect_refused(text);
      attacker.sql << "UPDATE main." + table_of(text) + " SET " + column + " = (SELECT " + column +
                          " FROM temp.kept)" + row;
      attacker.sql << "DROP TABLE temp.kept";
      ++tried;
    }
  }
  EXPECT_EQ(problems(), std::vector<std::string>{});
}

TEST_F(BoundTexts, ANoteThatIsMovedToAnotherTrialOrSessionIsRefused) {
  migrated();
  const auto all = texts_in(path);
  const auto note = std::ranges::find_if(
      all, [](const StoredText& one) { return one.text != "" && table_of(one) == "events"; });
  ASSERT_NE(note, all.end());
  Attacker attacker(path);
  for (const char* where :
       {"trial_id = coalesce(trial_id, 0) + 1", "session_id = session_id + 1"}) {
    const std::string row = " WHERE id = " + std::to_string(note->row);
    attacker.sql << "CREATE TEMP TABLE kept AS SELECT session_id, trial_id FROM events" + row;
    attacker.sql << "UPDATE events SET " + std::string(where) + row;
    std::string refused;
    const auto store = opened(path, OpenMode::read_only);
    for (const SessionRecord& session : test::every(must(store->recent_sessions(9))))
      refused += refusal(store->events(session.id));
    EXPECT_NE(refused.find("events.text of "), std::string::npos) << where;
    attacker.sql << "UPDATE events SET (session_id, trial_id) = (SELECT session_id, trial_id FROM "
                    "temp.kept)" +
                        row;
    attacker.sql << "DROP TABLE temp.kept";
  }
}

/// What it is bound to is the same, so that it opens: the seals of rows tell.
TEST_F(BoundTexts, AnOlderOneThatIsPutBackIntoItsOwnRowIsSaidAtTheNextLogin) {
  migrated();
  const StoredText before = texts_in(path).front();
  ASSERT_EQ(before.place.column.name, std::string("patient_profiles.notes"));
  {
    const auto store = opened(path, OpenMode::existing);
    PatientProfile profile = must(store->profile(1));
    profile.notes = "another note";
    must(store->set_profile(1, profile));
  }
  access.reset();
  const auto notices = [this] {
    access = must(Access::open(path));
    must(access->log_in("Theo", secret("theo's password")));
    return access->notices();
  };
  EXPECT_TRUE(notices().empty()) << "a note that is changed is legal";
  access.reset();
  {
    Attacker attacker(path);
    replace_text(attacker.sql, before, before.text);
  }
  ASSERT_EQ(notices().size(), 1u);
  EXPECT_NE(
      english(access->notices()[0]).find("patient_profiles: row 1 is not what isograsp wrote"),
      std::string::npos);
  EXPECT_EQ(problems(), std::vector<std::string>{row_of(before)});
}

/// Otherwise a text of a backup from before could be put into any row of its person.
TEST_F(BoundTexts, AsTheFormatBeforeSealedThemAreNotTaken) {
  const auto before = texts_in(path);
  migrated();
  const auto now = texts_in(path);
  ASSERT_EQ(before.size(), kTexts + 1) << "and what a rating was, which stood there in plain text";
  Attacker attacker(path);
  for (const StoredText& text : test::every(now)) {
    const auto same = std::ranges::find_if(before, [&](const StoredText& one) {
      return one.row == text.row &&
             std::string_view(one.place.column.name) == text.place.column.name;
    });
    ASSERT_NE(same, before.end());
    ASSERT_NE(same->text, text.text);
    replace_text(attacker.sql, text, same->text);
    expect_refused(text);
    EXPECT_EQ(std::ranges::count(problems(), row_of(text)), 1);
    replace_text(attacker.sql, text, text.text);
  }
  EXPECT_EQ(problems(), std::vector<std::string>{});
}

TEST_F(BoundTexts, AFileThatIsMadeToSayItIsOlderIsNotMigrated) {
  migrated();
  access.reset();
  Attacker(path).sql << "PRAGMA user_version=9";
  const std::string before = bytes_of(path);
  const auto refused = migrate();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find(" was changed or is damaged"), std::string::npos)
      << refused.error().message();
  EXPECT_EQ(bytes_of(path), before);
}

TEST_F(BoundTexts, OfAnOlderFileThatWasChangedAreNotBoundAnew) {
  {
    const auto all = texts_in(path);
    Attacker attacker(path);
    const auto of = [&all](const char* text) {
      return *std::ranges::find_if(all, [text](const StoredText& one) {
        return std::string_view(one.place.column.name) == text;
      });
    };
    // Of two rows of one person: the older binding tells nothing of it.
    const StoredText first = of("treatment_marks.text");
    StoredText second = first;
    ++second.row;
    attacker.sql << "UPDATE treatment_marks SET text = (SELECT text FROM treatment_marks WHERE id "
                    "= :other) WHERE id = :row",
        soci::use(second.row), soci::use(first.row);
  }
  const std::string before = bytes_of(path);
  const auto refused = migrate();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find(
                "was changed by another program: treatment_marks: row 1 is not what"),
            std::string::npos)
      << refused.error().message();
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_FALSE(fs::exists(path + ".format-9")) << "no copy either";
}

TEST_F(BoundTexts, OfAnOlderFileAreAllKept) {
  const auto refused = migrate("Rita");
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("researcher"), std::string::npos);
  const auto seals_of = [this] {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    int count = 0;
    sql << "SELECT count(*) FROM row_seals", soci::into(count);
    return count;
  };
  const int seals = seals_of();
  migrated();
  EXPECT_GE(seals_of(), seals + static_cast<int>(kTexts) / 2);
  EXPECT_LE(seals_of(), seals + 2 * static_cast<int>(kTexts)) << "rows that stay keep their seals";
  const auto store = opened(path, OpenMode::existing);
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
  for (const std::string& code : kCodes) {
    const std::string of = " of " + code;
    const RowId patient = must(store->find_patient(code))->id;
    const PatientProfile profile = must(store->profile(patient));
    EXPECT_EQ(profile.notes, "a note" + of);
    EXPECT_EQ(profile.goals, "a goal" + of);
    const auto expect_two = [&](const std::string& first, const std::string& second,
                                const std::string& what) {
      EXPECT_EQ(first, "first " + what + of);
      EXPECT_EQ(second, "second " + what + of);
    };
    const auto marks = must(store->treatment_marks(patient));
    expect_two(marks.at(0).text, marks.at(1).text, "mark");
    const auto scores = must(store->clinical_scores(patient));
    expect_two(scores.at(0).text, scores.at(1).text, "score");
    const auto primaries = must(store->primary_measures(patient));
    expect_two(primaries.at(0).chosen_by, primaries.at(1).chosen_by, "chooser");
    const auto periods = must(store->stable_periods(patient));
    expect_two(periods.at(0).judged_by, periods.at(1).judged_by, "judge");
    expect_two(periods.at(0).text, periods.at(1).text, "stable");
    const auto forms = must(consents(*access, code));
    expect_two(forms.at(0).text, forms.at(1).text, "form");
    const auto events = must(store->events(must(store->sessions(patient)).at(0).id));
    expect_two(events.at(0).text, events.at(1).text, "event");
    EXPECT_EQ(events.at(2).text, "key");
    EXPECT_EQ(must(read_identity(*access, code))->name, "Vera Novak" + of);
  }
  // What a rating was stood in plain text among the sealed notes, which could not be read then.
  const auto events = must(store->events(must(store->sessions(2)).at(0).id));
  EXPECT_EQ(events.back().kind, kCorrectionEvent);
  EXPECT_EQ(events.back().text, "Rating corrected: effort 4, pain 0; before: effort 3, pain 0");
  const auto left = must(store->trials(must(store->sessions(1)).at(1).id));
  EXPECT_EQ(left.at(0).status, TrialStatus::interrupted) << "as by any program that may write";
}

/// The window reads no file of an older format; a program that has logged in to migrate could.
TEST_F(BoundTexts, OfAnOlderFileAreReadAsTheyWereSealed) {
  const auto before = must(Access::open_to_migrate(path));
  must(before->log_in("Theo", secret("theo's password")));
  const auto store = opened(path, OpenMode::read_only);
  EXPECT_EQ(must(store->profile(1)).notes, "a note of P-0427");
  EXPECT_EQ(must(store->treatment_marks(2)).at(1).text, "second mark of P-0428");
  EXPECT_EQ(must(consents(*before, "P-0427")).at(0).text, "first form of P-0427");
}

TEST_F(BoundTexts, ARatingThatIsCorrectedLeavesTheNotesReadable) {
  migrated();
  const auto store = opened(path, OpenMode::existing);
  RatingRecord rating = must(store->ratings(2)).at(0);
  rating.session_time_s = 5.0;
  rating.effort = 7;
  must(store->correct_rating(rating));
  const auto events = must(store->events(2));
  EXPECT_EQ(events.at(0).text, "first event of P-0428");
  EXPECT_EQ(events.back().text, "Rating corrected: effort 7, pain 0; before: effort 4, pain 0");
}

}  // namespace
}  // namespace isograsp::storage::bound_texts_test
