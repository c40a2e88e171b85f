// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration clinic shows what the program can do: as the executable makes it, in the
// reports that the executable writes of it.
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/background_command.hpp"
#include "tests/support/command.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::app::demo_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

TEST(DemonstrationMade, AfterAProgramThatWasKilledInItIsMadeAnewAndByOneAtATime) {
  const TemporaryFolder folder;
  const std::string clinic = folder.path("clinic.db");
  const std::string parts = folder.path(".clinic.db.making");
  const std::string make = "demo --clinic " + clinic + " --small --at 2026-03-05T09:30:00Z";
  const std::string program = ISOGRASP_EXECUTABLE;
  const test::BackgroundCommand killed("sh -c 'echo $$ >" + folder.path("pid") + "; exec " +
                                       program + " " + make + "'");
  ASSERT_TRUE(killed.wait_until([&] { return fs::exists(parts + "/2.part"); })) << killed.err();
  const auto beside = isograsp(make);
  EXPECT_EQ(beside.status, 1);
  EXPECT_NE(beside.err.find("another program"), std::string::npos) << beside.err;
  ASSERT_EQ(std::system(("kill -9 $(cat " + folder.path("pid") + ")").c_str()), 0);
  killed.wait_for_end();
  ASSERT_TRUE(fs::exists(parts));
  const auto again = isograsp(make);
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_FALSE(fs::exists(parts));
  const auto checked = isograsp("db check " + clinic);
  EXPECT_EQ(checked.status, 0) << checked.err;
}

/// The clinic that windows open and that `demo --headless` works in, made once.
class DemonstrationClinic : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    data_ = std::make_unique<test::Variable>("XDG_DATA_HOME", folder_->path());
    const auto demo = isograsp("demo --headless");
    ASSERT_EQ(demo.status, 0) << demo.err;
    const auto done = isograsp("report --all --db " + db() + " --out " + folder_->path("reports"));
    ASSERT_EQ(done.status, 0) << done.err;
    store_ = storage::open_store(db(), storage::OpenMode::read_only).value();
  }
  static void TearDownTestSuite() {
    store_.reset();
    data_.reset();
    folder_.reset();
  }
  static std::string db() { return folder_->path("isograsp/demonstration-session.db"); }
  static std::string report(const std::string& code) {
    return read_text(folder_->path("reports/" + code + ".html")).value();
  }
  static std::vector<storage::SessionRecord> sessions(const std::string& code) {
    return store_->sessions(store_->find_patient(code).value().value().id).value();
  }
  /// Mean over the session of the grip maxima of its completed trials.
  static std::vector<double> grips_N(const std::string& code) {
    std::map<storage::RowId, std::vector<double>> of_session;
    for (const auto& session : sessions(code))
      for (const auto& trial : store_->trials(session.id).value())
        if (trial.status == storage::TrialStatus::completed &&
            session.hand == sessions(code)[0].hand)
          for (const auto& measure : store_->measures(trial.id).value())
            if (measure.name == "maximum_force" && measure.channel == "grip" && measure.value)
              of_session[session.id].push_back(*measure.value);
    std::vector<double> means;
    for (const auto& [id, values] : of_session) {
      double sum = 0.0;
      for (const double value : values) sum += value;
      means.push_back(sum / static_cast<double>(values.size()));
    }
    return means;
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::unique_ptr<test::Variable> data_;
  static inline std::unique_ptr<storage::SessionStore> store_;
};

/// What the table at a glance says, row by row.
std::set<std::string> verdicts_in(const std::string& html) {
  std::set<std::string> verdicts;
  const std::regex cell("<strong>([^<]*)</strong><br><small>");
  for (std::sregex_iterator it(html.begin(), html.end(), cell), end; it != end; ++it)
    verdicts.insert((*it)[1]);
  return verdicts;
}

TEST_F(DemonstrationClinic, ItsReportsContainEveryVerdict) {
  std::set<std::string> all;
  for (const char* code : {"DEMO-01", "DEMO-02", "DEMO-03", "DEMO-04"})
    all.merge(verdicts_in(report(code)));
  for (const char* verdict : {"improved (confirmed)", "improved (possible)", "worsened (confirmed)",
                              "not larger than measurement error", "cannot be judged yet"})
    EXPECT_TRUE(all.count(verdict)) << verdict;
  EXPECT_TRUE(verdicts_in(report("DEMO-01")).count("improved (confirmed)"));
  EXPECT_TRUE(verdicts_in(report("DEMO-02")).count("worsened (confirmed)"));
}

TEST_F(DemonstrationClinic, ItsReportsContainGoalsScoresMarksPainAndABandOfHealthyPeople) {
  const std::string html = report("DEMO-01");
  for (const char* text :
       {"Goal: Hold a cup of tea", "ARAT", "FMA-UE", "n\u00a022)", ">T</text>", "SIMULATED DEVICE"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  const std::regex band("healthy [0-9.]+ to [0-9.]+");
  EXPECT_TRUE(std::regex_search(html, band));
  EXPECT_NE(report("DEMO-03").find(">B</text>"), std::string::npos) << "botulinum toxin";
  EXPECT_EQ(html.find("No primary measure"), std::string::npos);
}

TEST_F(DemonstrationClinic, EndsWithAReportOfSomebodyWhoComesForTwoMonths) {
  const std::string pdf = read_text(folder_->path("isograsp/demonstration-session.pdf")).value();
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  const auto all = sessions("DEMO-01");
  EXPECT_GE(all.size(), 9u);
  EXPECT_EQ(all.back().protocol_name, "Demonstration");
}

TEST_F(DemonstrationClinic, HasPeopleEnoughForVerdictsAndBands) {
  int stable = 0;
  int healthy = 0;
  for (const auto& patient : store_->patients().value()) {
    stable += store_->stable_periods(patient.id).value().empty() ? 0 : 1;
    healthy += store_->profile(patient.id).value().affected == storage::Side::none ? 1 : 0;
  }
  EXPECT_GE(stable, 11) << "ten besides the one who is judged";
  EXPECT_GE(healthy, 20);
}

TEST_F(DemonstrationClinic, HasCoursesThatAClinicianBelieves) {
  const auto better = grips_N("DEMO-01");
  EXPECT_GE(better.size(), 9u);
  EXPECT_GT(better.back(), 1.2 * better.front());
  EXPECT_LT(better.back(), 2.0 * better.front()) << "in eight weeks";
  for (std::size_t i = 1; i < better.size(); ++i)
    EXPECT_LT(std::abs(std::log(better[i] / better[i - 1])), 0.6) << "from one visit to the next";
  const auto worse = grips_N("DEMO-02");
  EXPECT_LT(worse.back(), 0.7 * worse.front());
  EXPECT_GT(worse.back(), 0.3 * worse.front());
}

TEST_F(DemonstrationClinic, HasASessionOfTodayThatCanBeGoneOnWith) {
  const auto last = sessions("DEMO-04").back();
  EXPECT_EQ(last.protocol_name, "Battery");
  const auto trials = store_->trials(last.id).value();
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials.front().status, storage::TrialStatus::completed);
  EXPECT_EQ(trials.back().status, storage::TrialStatus::aborted);
  const auto on = isograsp(
      "run --resume --patient DEMO-04 --device 'sim://moderate?seed=41' --fast "
      "--protocol-file " ISOGRASP_SOURCE_DIR "/library/protocols/battery.toml --db " +
      db());
  EXPECT_EQ(on.status, 0) << on.err;
  ASSERT_GE(trials.size(), 2u);
  EXPECT_EQ(on.out.find(trials[1].task_name), std::string::npos) << "what was done is not repeated";
  EXPECT_NE(on.out.find(trials.back().task_name), std::string::npos) << "what was broken off is";
}

TEST(LargeDemonstrationClinic, TakesATimeThatIsNone) {
  const TemporaryFolder folder;
  const auto wrong = isograsp("demo --at yesterday --clinic " + folder.path("clinic.db"));
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("2026-03-05T09:30:00Z"), std::string::npos) << wrong.err;
  EXPECT_FALSE(fs::exists(folder.path("clinic.db")));
}

/// Both clinics are made by the same function; the small one takes a second.
TEST(LargeDemonstrationClinic, OfTheSameTimeIsTheSameFileWithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "3"}) {
    const auto made =
        isograsp("demo --small --at 2026-03-05T09:30:00Z --threads " + std::string(threads) +
                 " --clinic " + folder.path(std::string(threads) + ".db"));
    ASSERT_EQ(made.status, 0) << made.err;
  }
  EXPECT_TRUE(read_text(folder.path("1.db")).value() == read_text(folder.path("3.db")).value());
}

}  // namespace
}  // namespace isograsp::app::demo_test
