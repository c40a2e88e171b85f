// SPDX-License-Identifier: GPL-3.0-or-later
// Protected databases as a user calls them: login of every command, accounts, identity, audit log,
// consent, erasure, export of one person; and what is no code or no folder name.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "storage/access/accounts.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"

namespace isograsp::app::protected_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using Json = nlohmann::json;

struct ProtectedCommands : testing::Test {
  test::TemporaryFolder folder;
  std::string db = folder.path("clinic.db");
  std::string clinic = " --passphrase-file " + folder.write("p", "words of the clinic\n");
  std::string ada_file = folder.write("ada", "ada's long password\n");
  std::string rita_file = folder.write("rita", "rita's long password\n");
  std::string ada = " --user Ada --password-file " + ada_file;
  std::string rita = " --user Rita --password-file " + rita_file;
  std::string session =
      "run --protocol-file " ISOGRASP_SOURCE_DIR
      "/library/protocols/short.toml --device 'sim://healthy?seed=4' --fast --patient T-01 --db " +
      db;

  /// What `db init --protected` makes, with passwords that cost little: a command takes a third of
  /// a second to check one of the others. The recovery key.
  std::string init(const std::vector<std::pair<std::string, storage::Role>>& people = {}) const {
    const storage::Secret passphrase("words of the clinic");
    const auto made = test::must(storage::Access::create(db, passphrase, &storage::kCheapKeyCost));
    test::must(accept_recovery_key(*made.access, made.recovery_key));
    for (const auto& [name, role] : people) {
      const storage::Secret password(name == "Ada" ? "ada's long password"
                                                   : "rita's long password");
      test::must(add_user(*made.access, name, role, password, storage::kCheapKeyCost));
    }
    return std::string(made.recovery_key.text());
  }
  /// Exit status 0; what it printed.
  static std::string must_do(const std::string& arguments) {
    const auto done = isograsp(arguments);
    EXPECT_EQ(done.status, 0) << arguments << "\n" << done.err;
    return done.out;
  }
  static void refused(const std::string& arguments, const std::string& why) {
    const auto done = isograsp(arguments);
    EXPECT_EQ(done.status, 2) << arguments << "\n" << done.out;
    EXPECT_NE(done.err.find(why), std::string::npos) << arguments << "\n" << done.err;
  }
};

TEST_F(ProtectedCommands, EveryCommandAsksForTheLogin) {
  const std::string key = init();
  EXPECT_EQ(key.size(), 69u);
  refused("db init --protected " + folder.path("other.db"), "--protected: no passphrase is given");
  refused(session, "is protected");
  for (const std::string& command :
       {"db check " + db, "db verify " + db, "db audit " + db, "db users list " + db,
        "db backup " + db + " --to " + folder.path("b.db"),
        "export --db " + db + " --out " + folder.path("e"),
        "report --db " + db + " --patient T-01 --out " + folder.path("r.html")})
    refused(command, "--passphrase-file");
  folder.write("wrong", "words of the clinik\n");
  refused("db check " + db + " --passphrase-file " + folder.path("wrong"), "password is wrong");
  must_do(session + clinic);
  for (const std::string& command :
       {"db check " + db, "db verify " + db, "db backup " + db + " --to " + folder.path("b.db"),
        "export --db " + db + " --out " + folder.path("e"),
        "report --db " + db + " --patient T-01 --out " + folder.path("r.html"),
        "report --db " + db + " --all --threads 2 --out " + folder.path("all"),
        "db check " + folder.path("b.db")})
    must_do(command + clinic);
  EXPECT_TRUE(fs::exists(folder.path("all/T-01.html"))) << "written by processes of their own";
  must_do("db check " + db + " --recovery-key-file " + folder.write("key", key));
  const Json log = Json::parse(must_do("db audit --json " + db + clinic));
  EXPECT_TRUE(log.at("problems").empty());
  std::string acts;
  for (const auto& entry : log.at("entries"))
    if (entry.at("act") != "login")
      acts +=
          entry.at("act").get<std::string>() + " " + entry.at("object").get<std::string>() + ";";
  EXPECT_EQ(
      acts,
      "create clinic.db;new recovery key ;add patient T-01;begin session T-01;end session T-01;"
      "backup b.db;export ;report T-01;report ;");
  must_do("db audit " + db + clinic + " --contains " + log.at("head").get<std::string>());
  const auto other = isograsp("db audit " + db + clinic + " --contains 3:" + std::string(64, 'a'));
  EXPECT_EQ(other.status, 1);
}

TEST_F(ProtectedCommands, RolesDecideWhoSeesIdentities) {
  init({{"Ada", storage::Role::therapist}, {"Rita", storage::Role::researcher}});
  refused(
      "db users add " + db + clinic + " --role janitor --name Joe --new-password-file " + ada_file,
      "is no role");
  EXPECT_EQ(must_do("db users list " + db + ada), "Ada  therapist\nRita  researcher\n");
  must_do(session + ada);
  const std::string person = folder.write(
      "person.json", R"({"name": "Vera Novak", "birth_date": "1950-03-05", "contact": "Berlin"})");
  const std::string set = "db identity set " + db + " --patient T-01 --from ";
  must_do(set + person + ada);
  const std::string show = "db identity show " + db + " --patient T-01";
  EXPECT_EQ(must_do(show + ada), "T-01: Vera Novak, born 1950-03-05\nBerlin\n");
  refused(show + rita, "may not see who people are");
  refused(session + rita, "may not change records");
  must_do("export --db " + db + " --out " + folder.path("e") + rita);
  must_do("db verify " + db + rita);
  for (const char* bad : {"[]", "{", R"({"name": 1})", R"({"surname": "Novak"})", "[[[[[["}) {
    const auto done = isograsp(set + folder.write("bad.json", bad) + ada);
    EXPECT_EQ(done.status, 2) << bad;
    EXPECT_EQ(done.err.find("Novak"), std::string::npos) << done.err;
  }
  const std::string out = folder.path("T-01");
  refused("db person " + db + " --patient T-01 --out " + out + rita, "may not see");
  must_do("db person " + db + " --patient T-01 --out " + out + ada);
  const Json all = Json::parse(*read_text(out + "/person.json"));
  EXPECT_EQ(all.at("identity").at("name"), "Vera Novak");
  EXPECT_EQ(all.at("sessions").at(0).at("trials").size(), 4u);
  EXPECT_GT(read_signals(out + "/session_1/trial_2.csv")->rows(), 100u);
  EXPECT_NE(read_text(out + "/measures.csv")->find(",rmse,force,"), std::string::npos);
  refused("db person " + db + " --patient T-01 --out " + out + ada, "exists already");
  EXPECT_TRUE(fs::exists(out + "/person.json"));
}

TEST_F(ProtectedCommands, ARestrictedPersonStillGetsTheirOwnData) {
  init();
  must_do(session + clinic);
  const std::string of = db + " --patient T-01";
  must_do("db identity set " + of + " --from " +
          folder.write("person.json", R"({"name": "Vera Novak"})") + clinic);
  must_do("db erase " + of + " --reason 'letter of 5 March'" + clinic);
  refused("db identity show " + of + clinic, "restricted until");
  must_do("db person " + of + " --out " + folder.path("T-01") + clinic);
  const Json all = Json::parse(*read_text(folder.path("T-01") + "/person.json"));
  EXPECT_EQ(all.at("identity").at("name"), "Vera Novak");
  EXPECT_NE(must_do("db audit " + db + clinic + " --object T-01").find("for the person's own copy"),
            std::string::npos);
}

TEST_F(ProtectedCommands, ABackupIsPutBackOnPurposeAndThatIsLogged) {
  init();
  must_do(session + clinic);
  must_do("db backup " + db + " --to " + folder.path("b.db") + clinic);
  must_do("db users add " + db + clinic + " --name Ada --new-password-file " + ada_file);
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(db + suffix);
  fs::copy_file(folder.path("b.db"), db);
  EXPECT_EQ(isograsp("db check " + db + clinic).status, 1) << "put back in silence";
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(db + suffix);
  must_do("db restore " + db + " --from " + folder.path("b.db") + clinic);
  must_do("db check " + db + clinic);
  EXPECT_TRUE(fs::exists(db + "-audit.old"));
  EXPECT_NE(must_do("db audit " + db + clinic).find("restore  done  (b.db)"), std::string::npos);
}

TEST_F(ProtectedCommands, ADatabaseMadeWithoutItIsProtectedLater) {
  must_do("db init " + db);
  must_do(session);
  refused("db protect " + db, "no passphrase is given");
  const Json done = Json::parse(must_do("db protect --json " + db + clinic));
  EXPECT_EQ(done.at("recovery_key").get<std::string>().size(), 69u);
  EXPECT_TRUE(done.at("swept"));
  EXPECT_EQ(done.at("copy"), db + ".before-protection");
  refused("db verify " + db, "--passphrase-file");
  for (const std::string command : {"db check ", "db verify ", "db audit "})
    must_do(command + db + clinic);
  must_do("db users add " + db + clinic + " --name Ada --new-password-file " + ada_file);
  must_do(session + ada);
  must_do("db verify " + done.at("copy").get<std::string>());
  EXPECT_NE(must_do("db protect " + db + clinic).find("is protected already"), std::string::npos);
}

TEST_F(ProtectedCommands, SecretsAreMadeAndChangedByFiles) {
  const Json made = Json::parse(must_do("db init --json --protected " + db + clinic));
  EXPECT_EQ(made.at("recovery_key").get<std::string>().size(), 69u);
  const std::string add = "db users add " + db + clinic + " --role ";
  must_do(add + "therapist --name Ada --new-password-file " + ada_file);
  must_do(add + "researcher --name Rita --new-password-file " + rita_file);
  EXPECT_EQ(must_do("db users list " + db + rita), "Ada  therapist\nRita  researcher\n");
  folder.write("new", "another long password");
  folder.write("pin", "2580");
  must_do("db users pin " + db + ada + " --new-pin-file " + folder.path("pin"));
  must_do("db users password " + db + ada + " --new-password-file " + folder.path("new"));
  refused("db check " + db + ada, "password is wrong");
  must_do("db check " + db + " --user ada --password-file " + folder.path("new"));
  must_do("db passphrase " + db + clinic + " --new-passphrase-file " + folder.path("new"));
  refused("db check " + db + clinic, "password is wrong");
  must_do("db check " + db + " --passphrase-file " + folder.path("new"));
  refused("db check " + db + " --passphrase-file " + folder.path("absent"), "cannot be opened");
  refused("db check " + db + " --user Ada", "--password-file");
}

TEST_F(ProtectedCommands, AnUnprotectedDatabaseHasConsentErasureAndLogWithoutALogin) {
  must_do("db init " + db);
  must_do(session);
  refused("db check " + db + clinic, "asks for no login");
  refused("db init " + folder.path("other.db") + clinic, "add --protected");
  refused("db identity show " + db + " --patient T-01", "isograsp db protect");
  refused("db users list " + db + ada, "asks for no login");
  const std::string person = " --patient T-01";
  must_do("db consent add " + db + person +
          " --purpose research --basis consent --state given --date 2026-03-05 --text 'form 2'");
  EXPECT_EQ(must_do("db consent list " + db + person),
            "2026-03-05  research  given  (consent)  form 2\n");
  must_do("db person " + db + person + " --out " + folder.path("T-01"));
  refused("db erase " + db + person, "no reason is given");
  const Json kept =
      Json::parse(must_do("db erase --json " + db + person + " --reason 'letter of 5 March'"));
  EXPECT_FALSE(kept.at("erased"));
  EXPECT_TRUE(kept.at("restricted"));
  refused(session, "restricted until");
  must_do("db erase " + db + person + " --lift --reason 'wishes to go on'");
  must_do("db policy " + db + " --retention-years 0");
  const Json gone =
      Json::parse(must_do("db erase --json " + db + person + " --reason 'letter of 5 March'"));
  EXPECT_TRUE(gone.at("erased"));
  EXPECT_EQ(gone.at("rows").at("trials"), 4);
  EXPECT_EQ(gone.at("remains").size(), 1u) << "the export of the person";
  refused(session, "was erased");
  must_do("db check " + db);
  must_do("db verify " + db);
}

TEST_F(ProtectedCommands, NoTextLeavesItsPlace) {
  must_do("db init " + db);
  must_do(session);
  for (const char* code : {"../../T-01", "T-01/../../x", "/etc/passwd1",
                           "'; DROP TABLE patients; --1", "T-01%00", "$(touch x)1", "T 1"}) {
    std::string quoted = " --patient='";
    for (const char letter : std::string_view(code))
      letter == '\'' ? quoted.append("'\\''") : quoted.append(1, letter);
    quoted += "' ";  // whatever a shell would make of it reaches the program
    for (const std::string& command :
         {"export --db " + db + quoted + "--out " + folder.path("out"),
          "report --db " + db + quoted + "--out " + folder.path("out.html"),
          "db person " + db + quoted + "--out " + folder.path("out"),
          "db erase " + db + quoted + "--reason test",
          "target --db " + db + quoted + "--out " + folder.path("out.toml"),
          session.substr(0, session.find("--patient")) + quoted + "--db " + db}) {
      const auto done = isograsp(command);
      EXPECT_EQ(done.status, 2) << command << done.out;
      EXPECT_LT(done.err.size(), 1000u);
    }
  }
  EXPECT_FALSE(fs::exists(folder.path("out")));
  must_do("db check " + db);
  const Json log = Json::parse(must_do("db audit --json " + db));
  for (const auto& entry : test::every(log.at("entries"))) {
    const std::string object = entry.at("object");
    EXPECT_TRUE(object == "T-01" || object.empty()) << object;
  }
}

}  // namespace
}  // namespace isograsp::app::protected_test
