// SPDX-License-Identifier: GPL-3.0-or-later
// The emergency file of a protected database: made while nobody asks for a passphrase, as sealed as
// the database is, and taken in again by who may open that.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "storage/access/access.hpp"
#include "storage/crypto/seal.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::app::protected_emergency_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using Json = nlohmann::json;

class ProtectedEmergency : public testing::Test {
 protected:
  ProtectedEmergency() {
    const auto task = [&](const char* file, const char* keys) {
      static_cast<void>(
          folder_.write(file, std::string("format = \"isograsp-task-1\"\nname = \"") + file +
                                  "\"\ninstruction = \"Move.\"\nversion = 1\n" + keys));
    };
    task("rest.toml", "kind = \"rest\"\nduration_s = 1\n");
    task("first.toml", "kind = \"observe\"\nscene = \"firm_block\"\nduration_s = 1\n");
    task("second.toml", "kind = \"observe\"\nscene = \"firm_block\"\nduration_s = 600\n");
    protocol_ = folder_.write(
        "p.toml",
        "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\nkind = \"instrument_zero\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"rest.toml\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"maximum_grip.toml\"\n"  // left out, with a note
        "[[step]]\nkind = \"task\"\ntask = \"first.toml\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"second.toml\"\n");
    test::must(storage::Access::create(db_, storage::Secret("words of the clinic"),
                                       &storage::kCheapKeyCost));
    must_do("run --protocol-file " ISOGRASP_SOURCE_DIR
            "/library/protocols/short.toml --device 'sim://healthy?seed=4' --fast --patient T-01 "
            "--db " +
            db_ + login_);
    must_do("db identity set " + db_ + " --patient T-01 --from " +
            folder_.write("person.json", R"({"name": "Vera Novak", "birth_date": "1950-03-05"})") +
            login_);
  }
  static std::string must_do(const std::string& arguments) {
    const auto done = isograsp(arguments);
    EXPECT_EQ(done.status, 0) << arguments << "\n" << done.err;
    return done.out;
  }
  [[nodiscard]] std::string asked(const std::string& file, const std::string& query) const {
    return test::run("sqlite3 -readonly '" + file + "' \"" + query + "\"").out;
  }
  [[nodiscard]] std::vector<std::string> emergency_files() const {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const auto& entry :
         fs::directory_iterator(folder_.path("state/isograsp/emergency"), ignored))
      if (entry.path().extension() == ".db") files.push_back(entry.path());
    return files;
  }
  /// Records in real time until `fate` comes over the file in the last trial.
  void record(const std::function<void()>& fate) {
    const test::BackgroundCommand session(
        "\"" ISOGRASP_EXECUTABLE "\" run --protocol-file " + protocol_ +
        " --device 'sim://healthy?seed=4' --patient T-01 --allowed comfortable --db " + db_ +
        login_);
    ASSERT_TRUE(session.wait_until([&] {
      return asked(db_,
                   "SELECT count(*) FROM signal_blocks b JOIN trials t ON t.id = b.trial_id WHERE "
                   "t.task_name = 'second.toml' AND b.second = 1 AND b.position = 0") == "1\n";
    })) << session.err();
    fate();
    session.wait_for_end();
    EXPECT_EQ(session.status(), 1) << session.err();
    EXPECT_EQ(session.out().find("[completed]"), std::string::npos);
    ASSERT_EQ(emergency_files().size(), 1u) << session.err();
  }
  void expect_as_sealed_as_the_database() const {
    int looked_at = 0;
    bool task_text = false;
    for (const auto& entry :
         test::every(fs::directory_iterator(folder_.path("state/isograsp/emergency")))) {
      const std::string bytes = test::read_file(entry.path());
      ++looked_at;
      task_text = task_text || bytes.find("duration_s = 600") != std::string::npos;
      for (const char* plain : {"Vera", "Novak", "1950-03-05", "Left out", "words of the clinic"})
        EXPECT_EQ(bytes.find(plain), std::string::npos) << entry.path() << ": " << plain;
    }
    EXPECT_GE(looked_at, 1);
    EXPECT_TRUE(task_text) << "what is no secret is found so";
    EXPECT_EQ(asked(emergency_files()[0], "SELECT count(*) FROM events WHERE kind = 'note'"),
              "1\n");
    EXPECT_EQ(asked(emergency_files()[0], "SELECT count(*) FROM identities"), "0\n");
  }
  void expect_refused(const std::string& login, const std::string& why) const {
    const auto refused = isograsp("db rescue " + db_ + login);
    EXPECT_EQ(refused.status, 2) << refused.out;
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
    EXPECT_EQ(emergency_files().size(), 1u);
  }
  /// All of it is in the database, and can be read there by who has its passphrase.
  void expect_taken_in_with_the_passphrase() const {
    expect_refused("", "--passphrase-file");
    expect_refused(" --passphrase-file " + folder_.write("wrong", "words of the klinik\n"),
                   "password is wrong");
    must_do("db rescue " + db_ + login_);
    EXPECT_TRUE(emergency_files().empty());
    must_do("db check " + db_ + login_);
    must_do("db verify " + db_ + login_);
    must_do("db person " + db_ + " --patient T-01 --out " + folder_.path("person") + login_);
    const Json all = Json::parse(test::read_file(folder_.path("person/person.json")));
    EXPECT_EQ(all.at("identity").at("name"), "Vera Novak");
    ASSERT_EQ(all.at("sessions").size(), 2u);
    const Json& session = all.at("sessions").at(1);
    ASSERT_EQ(session.at("trials").size(), 3u);
    EXPECT_EQ(session.at("trials").at(1).at("status"), "completed");
    EXPECT_EQ(session.at("trials").at(2).at("status"), "aborted");
    EXPECT_GE(session.at("trials").at(2).at("samples"), 200);
    EXPECT_NE(session.at("events").dump().find("Left out"), std::string::npos)
        << "the note is unsealed with the keys of the database";
  }

  test::TemporaryFolder folder_;
  test::Variable state_{"XDG_STATE_HOME", folder_.path("state")};
  std::string db_ = folder_.path("clinic.db");
  std::string login_ = " --passphrase-file " + folder_.write("words", "words of the clinic\n");
  std::string protocol_;
};

TEST_F(ProtectedEmergency, OfAFileThatWasMovedAwayIsSealedAndTakenInWithThePassphrase) {
  ASSERT_NO_FATAL_FAILURE(record([&] {
    fs::rename(db_, db_ + ".away");
    while (emergency_files().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    fs::rename(db_ + ".away", db_);
  }));
  expect_as_sealed_as_the_database();
  fs::copy_file(db_, folder_.path("elsewhere.db"));
  for (const std::string& file : {db_, folder_.path("elsewhere.db")})
    EXPECT_NE(must_do("db rescue --list " + file).find("T-01"), std::string::npos)
        << "told by its number, wherever it is and whoever asks";
  expect_taken_in_with_the_passphrase();
}

TEST_F(ProtectedEmergency, OfADeletedFileKeepsItWholeAndSealed) {
  ASSERT_NO_FATAL_FAILURE(record([&] { fs::remove(db_); }));
  ASSERT_TRUE(fs::exists(emergency_files()[0] + ".whole"));
  expect_as_sealed_as_the_database();
  expect_taken_in_with_the_passphrase();
}

}  // namespace
}  // namespace isograsp::app::protected_emergency_test
