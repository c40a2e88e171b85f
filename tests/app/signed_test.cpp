// SPDX-License-Identifier: GPL-3.0-or-later
// Signed backups and exports as a user proves them: words and status.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace isograsp::app::signed_test {
namespace {

using Json = nlohmann::json;
using test::isograsp;

class Signed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<test::TemporaryFolder>();
    const auto run = isograsp("run --protocol-file " ISOGRASP_SOURCE_DIR
                              "/library/protocols/short.toml --device 'sim://healthy?seed=4' "
                              "--fast --patient T-01 --db " +
                              at("clinic.db"));
    ASSERT_EQ(run.status, 0) << run.err;
    ASSERT_EQ(isograsp("db backup " + at("clinic.db") + " --to " + at("monday.db")).status, 0);
    ASSERT_EQ(isograsp("export --db " + at("clinic.db") + " --out " + at("study")).status, 0);
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string at(const std::string& name) { return folder_->path(name); }
  static std::string key() {
    return Json::parse(isograsp("db audit --json " + at("clinic.db")).out).at("key");
  }
  static void add_a_byte(const std::string& name) {
    std::ofstream(at(name), std::ios::binary | std::ios::app) << '\0';
  }

  static inline std::unique_ptr<test::TemporaryFolder> folder_;
  static inline const std::string kOther = std::string(64, '0');
};

TEST_F(Signed, ABackupIsProvedWithTheKeyOfTheLogAndSaysWhoseKeyItWas) {
  const std::string check = "db check --signed " + at("monday.db");
  const auto open = isograsp(check);
  EXPECT_EQ(open.status, 0) << open.err;
  EXPECT_NE(open.out.find(key() + ", which nobody vouches for here"), std::string::npos);
  const auto given = isograsp(check + " --key " + key());
  EXPECT_EQ(given.status, 0) << given.err;
  EXPECT_NE(given.out.find("the key that was given"), std::string::npos);
  EXPECT_EQ(isograsp(check + " --key " + kOther).status, 1);
  EXPECT_EQ(isograsp(check + " --key 12").status, 2);
  EXPECT_EQ(isograsp(check + " --key ''").status, 2) << "as a variable that is not set";
  EXPECT_EQ(isograsp("db check " + at("monday.db") + " --key " + key()).status, 2);
}

TEST_F(Signed, ABackupThatWasAlteredAndOneThatIsNotSignedAreTold) {
  for (const char* name : {"tuesday.db", "tuesday.db.sig"})
    std::filesystem::copy_file(at("monday" + std::string(name).substr(7)), at(name));
  add_a_byte("tuesday.db");
  const auto altered = isograsp("db check --signed " + at("tuesday.db"));
  EXPECT_EQ(altered.status, 1);
  EXPECT_NE(altered.err.find("is not what was signed"), std::string::npos) << altered.err;
  const auto none = isograsp("db check --signed " + at("clinic.db"));
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("is not signed"), std::string::npos) << none.err;
}

TEST_F(Signed, ABackupThatIsPutBackIsSaidToBeSignedOrNot) {
  const auto restore = [&](const std::string& name) {
    return isograsp("db restore " + at("back.db") + " --from " + at(name)).out;
  };
  EXPECT_NE(restore("monday.db").find("signed with the key " + key()), std::string::npos);
  std::filesystem::copy_file(at("monday.db"), at("bare.db"));
  EXPECT_NE(restore("bare.db").find("the backup was not signed"), std::string::npos);
}

TEST_F(Signed, AnExportIsProvedAndTheFileThatWasAlteredIsNamed) {
  const std::string verify = "verify-export " + at("study") + " --key " + key();
  const auto good = isograsp(verify);
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_EQ(test::run("cd " + at("study") + " && sha256sum --strict -c SHA256SUMS").status, 0)
      << "as everybody can prove it";
  const std::string file = "study/patient_1/session_1/trial_1_signals.csv";
  add_a_byte(file);
  const auto bad = isograsp(verify);
  EXPECT_EQ(bad.status, 1);
  EXPECT_NE(bad.out.find("trial_1_signals.csv was altered"), std::string::npos) << bad.out;
  EXPECT_EQ(Json::parse(isograsp(verify + " --json").out).at("problems").size(), 1U);
  std::filesystem::remove(at("study/SHA256SUMS.sig"));
  const auto unsigned_one = isograsp(verify);
  EXPECT_EQ(unsigned_one.status, 1);
  EXPECT_EQ(isograsp("verify-export " + at("absent")).status, 2);
}

TEST_F(Signed, AnExportWithoutASignatureIsSaidToBeSo) {
  const std::string out = at("bare");
  ASSERT_EQ(isograsp("export --db " + at("clinic.db") + " --out " + out).status, 0);
  std::filesystem::remove(out + "/SHA256SUMS.sig");
  const auto bare = isograsp("verify-export " + out);
  EXPECT_EQ(bare.status, 1);
  EXPECT_NE(bare.err.find("is not signed"), std::string::npos) << bare.err;
}

TEST_F(Signed, AReportEndsWithTheKey) {
  const std::string report = at("report.html");
  ASSERT_EQ(isograsp("report --db " + at("clinic.db") + " --patient T-01 --out " + report).status,
            0);
  std::ifstream in(report);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("signed with the key " + key()), std::string::npos);
}

}  // namespace
}  // namespace isograsp::app::signed_test
