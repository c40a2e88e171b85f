// SPDX-License-Identifier: GPL-3.0-or-later
// The program against files that were made to harm whoever reads them, and what it leaves for
// others to read.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/storage/planted_blocks.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::app::hostile_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;

const std::string kProtocol = ISOGRASP_SOURCE_DIR "/library/protocols/short.toml";
const std::string kScene = ISOGRASP_SOURCE_DIR "/library/scenes/planar_block.toml";
const std::string kTask = ISOGRASP_SOURCE_DIR "/library/tasks/grip_sine.toml";

/// Ended by a signal after a time in which everybody else is done: whoever waits for a pipe's other
/// end waits for ever.
test::CommandResult patiently(const std::string& arguments) {
  return test::run("timeout 60 \"" ISOGRASP_EXECUTABLE "\" " + arguments);
}

struct Hostile : testing::Test {
  test::TemporaryFolder folder;
  std::string db = folder.path("clinic.db");

  void record(const std::string& options = "") const {
    const auto done =
        isograsp("run --protocol-file " + kProtocol +
                 " --device 'sim://healthy?seed=4' --fast --patient T-01 --db " + db + options);
    ASSERT_EQ(done.status, 0) << done.err;
  }
  void execute(const std::string& statement) const {
    soci::session sql(soci::sqlite3, db);
    sql << statement;
  }
};

TEST_F(Hostile, APipeIsRefusedByEveryReaderAndNobodyWaits) {
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string forces =
      folder.write("f.csv", "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N\n0,0,0,1\n0.01,0,0,1\n");
  ASSERT_EQ(isograsp("db init " + db).status, 0);
  const std::string out = " --out " + folder.path("out");
  for (const std::string& arguments :
       {"score --signals " + pipe,
        "score --task " + pipe + " --signals " + forces,
        "simulate --scene " + kScene + " --forces " + pipe + out,
        "simulate --scene " + pipe + " --forces " + forces + out,
        "grasp --scene " + pipe,
        "decode --protocol rft " + pipe + out,
        "decode --protocol net-ft " + pipe + out,
        "decode --protocol rft --config " + pipe + " " + forces + out,
        "convert --mapping " + pipe + out,
        "devices --config " + pipe,
        "import --recording " + pipe + " --from . --db " + db,
        "import --forces " + pipe + " --task " + kTask + " --patient T-02 --db " + db,
        "run --fast --protocol-file " + pipe + " --device sim://healthy --patient T-01 --db " + db,
        "run --fast --protocol-file " + kProtocol + " --device sim://healthy --patient T-01 --db " +
            pipe,
        "monitor --duration 1 --device 'replay://" + pipe + "'",
        "db check " + pipe,
        "db verify " + pipe,
        "report --patient T-01 --db " + pipe + out + ".html",
        "study --db " + db + " --study " + pipe + out + ".csv",
        "db init --protected " + folder.path("p.db") + " --passphrase-file " + pipe,
        "db restore " + db + " --from " + pipe,
        "db merge " + db + " --from " + pipe}) {
    const auto refused = patiently(arguments);
    EXPECT_TRUE(refused.status == 1 || refused.status == 2)
        << arguments << "\nended with " << refused.status << "\n"
        << refused.err;
    EXPECT_NE(refused.err.find("isograsp: error: "), std::string::npos) << arguments;
  }
}

/// Of all commands that have ended until now, the one that had most.
double peak_memory_MiB() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

TEST_F(Hostile, AMegabyteOfADatabaseBecomesNoGigabytesInAnyCommand) {
  // What a sanitizer sets aside when memory is given back is none of the program's.
  const test::Variable sanitizer("ASAN_OPTIONS", "quarantine_size_mb=16");
  record();
  const std::string other = folder.path("other.db");
  ASSERT_EQ(isograsp("db init " + other).status, 0);
  int asked = 0;
  const auto ask_all = [&] {
    const std::string out = " --out " + folder.path("out" + std::to_string(++asked));
    std::vector<std::string> commands = {
        "db check " + db,
        "db verify " + db,
        "db stats " + db,
        "db backup " + db + " --to " + folder.path("copy" + std::to_string(asked)) + ".db",
        "db merge " + other + " --from " + db,
        "db person " + db + " --patient T-01" + out + "-person",
        "report --patient T-01 --db " + db + out + ".html"};
    for (const char* format : {"csv", "hdf5", "bids", "fhir"})
      commands.push_back("export --db " + db + " --format " + format + out + "-" + format);
    for (const auto& arguments : commands) {
      const auto said = isograsp(arguments);
      EXPECT_TRUE(said.status >= 0 && said.status <= 2) << arguments << "\n" << said.err;
    }
  };
  ask_all();
  const double usual_MiB = peak_memory_MiB();
  ASSERT_GT(usual_MiB, 10.0);
  // 64 MiB in each of 80 blocks, 5 GiB in all. One block may be unpacked, as bytes and as numbers.
  constexpr std::size_t kRows = std::size_t{1} << 23;
#ifdef __SANITIZE_ADDRESS__
  constexpr double kMoreAllowed_MiB = 384.0;  // it keeps more of what was given back
#else
  constexpr double kMoreAllowed_MiB = 256.0;
#endif
  for (const test::ZeroBlocks& attack :
       {test::ZeroBlocks{80, kRows, 1, 1}, test::ZeroBlocks{1, kRows, 1, 80}}) {
    test::plant_blocks(db, 1, attack);
    execute("UPDATE trials SET sample_count = " + std::to_string(kRows * attack.seconds) +
            " WHERE id = 1");
    ASSERT_LT(fs::file_size(db), 4'000'000u);
    ask_all();
    EXPECT_LT(peak_memory_MiB(), usual_MiB + kMoreAllowed_MiB);
  }
}

TEST_F(Hostile, ALineOfAHundredThousandColumnsIsRefused) {
  std::string names = "t_s";
  for (int c = 1; c < 120'000; ++c) names += ",target_" + std::to_string(c) + "_N";
  const auto refused = isograsp("score --signals " + folder.write("wide.csv", names + "\n"));
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("wide.csv:1: the header names 120000 columns"), std::string::npos)
      << refused.err.substr(0, 500);
}

/// No control character but line ends and tabs; `lines` at most.
void expect_harmless(const test::CommandResult& said) {
  EXPECT_FALSE(said.out.empty() && said.err.empty()) << "nothing was printed";
  for (const std::string* text : {&said.out, &said.err}) {
    for (const char c : *text) {
      const auto byte = static_cast<unsigned char>(c);
      ASSERT_TRUE(byte >= 0x20 || byte == '\n' || byte == '\t') << *text;
      ASSERT_NE(byte, 0x7F) << *text;
    }
    EXPECT_EQ(text->find("\xC2\x9B"), std::string::npos) << *text;
    EXPECT_EQ(text->find("\nisograsp: error: forged"), std::string::npos) << *text;
    EXPECT_EQ(text->find("\nforged"), std::string::npos) << *text;
  }
}

const std::string kEvil =
    "x\x1b[2J\x1b]0;owned\a\r\nforged: sound\xC2\x9B"
    "31m\x7f";

TEST_F(Hostile, WhatStandsInFilesMovesNoCursorAndForgesNoLine) {
  const std::string toml_evil = R"("x\u001b[2J\u001b]0;owned\u0007\r\nforged\u009b31m\u007f")";
  std::string column = "target_a\x1b[2J\xC2\x9B\xff_N";
  const auto signals = folder.write(
      "s.csv", "t_s," + column + ",actual" + column.substr(6) + "\n0,1,1\n1,2,x\x1b[31m\n");
  expect_harmless(isograsp("score --signals " + signals));
  const auto sound = folder.write(
      "t.csv", "t_s," + column + ",actual" + column.substr(6) + "\n0,1,1\n1,2,2\n2,1,2\n");
  expect_harmless(isograsp("score --signals " + sound));
  const auto json = isograsp("score --json --signals " + sound);
  EXPECT_EQ(json.status, 0) << json.err;
  expect_harmless(json);
  EXPECT_FALSE(nlohmann::json::parse(json.out, nullptr, false).is_discarded()) << json.out;

  std::string scene = test::read_file(kScene);
  const auto name = scene.find("name = ");
  ASSERT_NE(name, std::string::npos);
  scene.replace(name, scene.find('\n', name) - name, "name = " + toml_evil);
  const auto grasp = isograsp("grasp --scene " + folder.write("s.toml", scene));
  EXPECT_EQ(grasp.status, 0) << grasp.err;
  expect_harmless(grasp);
  EXPECT_NE(grasp.out.find("\\x1b[2J"), std::string::npos) << "it is shown";
  expect_harmless(isograsp("grasp --json --scene " + folder.path("s.toml")));
  expect_harmless(isograsp("grasp --scene '" + folder.path(kEvil) + "'"));
  expect_harmless(isograsp("score --task " + folder.write("task.toml", "format = " + toml_evil) +
                           " --signals " + sound));
}

TEST_F(Hostile, NamesOfADatabaseMoveNoCursorAndForgeNoLine) {
  record();
  soci::session sql(soci::sqlite3, db);
  for (const char* change :
       {"UPDATE trials SET task_name = :evil", "UPDATE measures SET name = name || :evil",
        "UPDATE measures SET channel = channel || :evil", "UPDATE events SET text = :evil"})
    sql << change, soci::use(kEvil);
  sql << "UPDATE signal_packs SET values_blake2b = zeroblob(32) WHERE part = 0";
  sql << "UPDATE signal_groups SET name = name || :evil", soci::use(kEvil);
  for (const std::string command : {"db check ", "db verify ", "db audit ", "db stats ",
                                    "db check --json ", "db verify --json ", "db audit --json "}) {
    const auto said = isograsp(command + db);
    EXPECT_GE(said.status, 0);
    EXPECT_LE(said.status, 2) << command;
    expect_harmless(said);
  }
  expect_harmless(isograsp("export --db " + db + " --out " + folder.path("e")));
}

TEST_F(Hostile, ReportsOfWhateverStandsInTheRowsEndWithAStatus) {
  record();
  execute("UPDATE trials SET health_json = '{\"kernel_drops\":\"many\",\"thumb\":{\"lost\":{}}}'");
  for (const char* name : {"r.pdf", "r.html"}) {
    const auto done = test::run("QT_QPA_PLATFORM=offscreen \"" ISOGRASP_EXECUTABLE
                                "\" report --patient T-01 --db " +
                                db + " --out " + folder.path(name));
    EXPECT_EQ(done.status, 0) << done.err;
  }
}

TEST_F(Hostile, WhatTheProgramMakesIsForItsOwnerOnly) {
  const fs::path all = folder.path("all");
  const std::string home = "umask 000; cd " + all.string() + "; HOME=" + all.string() +
                           " XDG_STATE_HOME=" + all.string() +
                           "/state XDG_DATA_HOME=" + all.string() +
                           "/data QT_QPA_PLATFORM=offscreen ";
  fs::create_directory(all);
  fs::permissions(all, fs::perms::owner_all);
  const auto must_do = [&](const std::string& arguments) {
    const auto done = test::run(home + "\"" ISOGRASP_EXECUTABLE "\" " + arguments);
    EXPECT_EQ(done.status, 0) << arguments << "\n" << done.err;
  };
  folder.write("pass", "words of the clinic\n");
  must_do("run --protocol-file " + kProtocol +
          " --device 'sim://healthy?seed=4' --fast --patient T-01 --db c.db");
  must_do("db init --protected p.db --passphrase-file " + folder.path("pass"));
  must_do("report --db c.db --patient T-01 --out r.pdf");
  must_do("report --db c.db --patient T-01 --out r.html");
  for (const char* format : {"csv", "hdf5", "bids", "fhir"})
    must_do("export --db c.db --format " + std::string(format) + " --out e-" + format);
  must_do("db backup c.db --to b.db");
  must_do("db backup c.db --scheduled");
  must_do("db restore r.db --from b.db");
  must_do("db person c.db --patient T-01 --out person");
  must_do("record --device 'sim://healthy?seed=1' --duration 0.1 --out rec.csv");
  int files = 0;
  for (const auto& entry : test::every(fs::recursive_directory_iterator(all))) {
    const auto mode = static_cast<int>(entry.status().permissions());
    EXPECT_EQ(mode, entry.is_directory() ? 0700 : 0600) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 30);
}

TEST_F(Hostile, SomebodyWithoutIdentityAndConsentGetsTheirCopyToo) {
  record();
  const auto out = folder.path("T-01");
  const auto done = isograsp("db person " + db + " --patient T-01 --out " + out);
  EXPECT_EQ(done.status, 0) << done.err;
  const auto json = nlohmann::json::parse(test::read_file(out + "/person.json"));
  EXPECT_EQ(json.at("code"), "T-01");
  EXPECT_EQ(json.at("sessions").size(), 1u);
  EXPECT_TRUE(fs::exists(out + "/measures.csv"));
  EXPECT_TRUE(fs::exists(out + "/session_1/trial_1.csv"));
}

TEST_F(Hostile, NoTableHoldsAFormulaAndNumbersStayNumbers) {
  record();
  soci::session sql(soci::sqlite3, db);
  const std::string formula = "=HYPERLINK(\"http://x\",\"y\")";
  sql << "UPDATE trials SET task_name = :evil", soci::use(formula);
  sql << "UPDATE measures SET channel = '@SUM(1)', unit = '+1+1', value = -1.5, reason = ''";
  sql << "UPDATE events SET text = '-2+3'";
  sql << "UPDATE sessions SET started_utc = '=1,2'";
  const auto out = folder.path("T-01");
  ASSERT_EQ(isograsp("db person " + db + " --patient T-01 --out " + out).status, 0);
  const std::string table = test::read_file(out + "/measures.csv");
  EXPECT_NE(table.find(",\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\","), std::string::npos)
      << table.substr(0, 500);
  EXPECT_NE(table.find(",'@SUM(1),-1.5,'+1+1,"), std::string::npos);
  for (const char* cell : {",=", ",@", ",+", "\n=", "\n@", "\n+", "\"=", "\"@"})
    EXPECT_EQ(table.find(cell), std::string::npos) << cell;
  ASSERT_EQ(isograsp("export --db " + db + " --format bids --out " + folder.path("b")).status, 0);
  test::AtLeast tables(1);
  for (const auto& entry : test::every(fs::recursive_directory_iterator(folder.path("b"))))
    if (entry.path().string().ends_with("events.tsv")) {
      const std::string events = test::read_file(entry.path());
      EXPECT_EQ(events.find("\t-2+3"), std::string::npos) << events;
      ++tables;
    }
}

}  // namespace
}  // namespace isograsp::app::hostile_test
