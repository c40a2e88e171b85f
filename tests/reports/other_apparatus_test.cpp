// SPDX-License-Identifier: GPL-3.0-or-later
// An apparatus that is no platform goes the whole way: session, database, measures, report, export,
// replay. tests/support/dynamometer.hpp is all that is special about it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "exports/research_export.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/qt_application.hpp"
#include "reports/paper/report_writer.hpp"
#include "session/protocol/protocol_run.hpp"
#include "session/session.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/score.hpp"
#include "tests/support/dynamometer.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::other_apparatus_test {
namespace {

constexpr const char* kLibrary = ISOGRASP_SOURCE_DIR "/library";
constexpr double kPeak_N = 31.0;

class Handle : public testing::Test {
 protected:
  Handle() {
    static_cast<void>(folder_.write(
        "handling.toml",
        "format = \"isograsp-task-1\"\nname = \"Free handling\"\ninstruction = \"Press.\"\n"
        "version = 1\nkind = \"observe\"\nduration_s = 2\n"));
    protocol_ = folder_.write("p.toml",
                              "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\n"
                              "kind = \"task\"\ntask = \"handling.toml\"\n");
  }
  /// A press and its release; out of sight from `blind_s` on for a quarter of a second.
  std::string forces(double blind_s) {
    std::string text = "t_s,force_N\n";
    for (int k = 0; k < 400; ++k) {
      const double t_s = 0.01 * k;
      const double force_N = kPeak_N * std::exp(-std::pow((t_s - 1.0) / 0.3, 2));
      const bool blind = t_s >= blind_s && t_s < blind_s + 0.25;
      text += std::to_string(t_s) + "," + (blind ? "" : std::to_string(force_N)) + "\n";
    }
    return folder_.write("forces.csv", text);
  }
  session::SessionConfig config(const std::string& uri) {
    session::SessionConfig config;
    config.database = folder_.path("clinic.db");
    config.create_database = true;
    config.patient_code = "H-01";
    config.device_uri = uri;
    config.library = kLibrary;
    config.virtual_time = true;
    config.apparatuses = test::apparatuses_with_handle();
    return config;
  }
  Result<session::ProtocolResult> run(const session::SessionConfig& config) {
    auto session = session::Session::open(config);
    if (!session) return session.error();
    return session::run_protocol(**session, session::read_protocol(protocol_, kLibrary).value(),
                                 {});
  }
  [[nodiscard]] std::unique_ptr<storage::SessionStore> store() const {
    return storage::open_store(folder_.path("clinic.db"), storage::OpenMode::existing).value();
  }

  test::TemporaryFolder folder_;
  std::string protocol_;
};

double value_of(const std::vector<Measure>& measures, std::string_view name) {
  for (const Measure& measure : test::every(measures))
    if (measure.name == name) return measure.value.value_or(std::nan(""));
  return std::nan("");
}

TEST_F(Handle, GoesTheWholeWayFromItsSensorToPaperAndFiles) {
  const auto result = run(config("handle://" + forces(9.0)));
  ASSERT_TRUE(result) << result.error().message();
  const auto clinic = store();
  const auto sessions = clinic->recent_sessions(1).value();
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_EQ(sessions[0].device_description, "A handle, recorded");
  const auto trials = clinic->trials(sessions[0].id).value();
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);

  // Recorded: what every trial has and the one column of the handle, nothing of fingers.
  const auto signals = clinic->signals(trials[0]).value();
  EXPECT_EQ(signals.names(),
            (std::vector<std::string>{"t_s", "task_time_s", "phase", "actual_force_N", "lateness_s",
                                      "compute_s"}));
  // Scored, and scored again from what is stored: the same.
  const auto measures = clinic->measures(trials[0].id).value();
  EXPECT_NEAR(value_of(measures, "peak_force"), kPeak_N, 1e-6) << "written with six digits";
  const auto spec = tasks::parse_task(trials[0].task_text, trials[0].task_name).value();
  const auto again = tasks::score(spec, signals);
  EXPECT_EQ(value_of(again, "peak_force"), value_of(measures, "peak_force"));

  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  ensure_qt_application();
  auto content = gather_progress(*clinic, "H-01");
  ASSERT_TRUE(content) << content.error().message();
  const std::string page = folder_.path("report.html");
  const auto writer = make_report_writer(*std::move(content), page);
  ASSERT_TRUE(write_all(*writer, page));
  EXPECT_NE(read_text(page).value().find("Free handling"), std::string::npos);

  const std::string out = folder_.path("out");
  const auto exported = exports::write_export(*clinic, {"H-01"}, exports::ExportFormat::csv, out);
  ASSERT_TRUE(exported) << exported.error().message();
  EXPECT_EQ(*exported, 1u);
}

/// The newest session once more, with the hands that are told.
void add_again(storage::SessionStore& clinic, std::optional<Hand> hand) {
  storage::SessionRecord session = clinic.recent_sessions(1).value().at(0);
  storage::TrialRecord trial = clinic.trials(session.id).value().at(0);
  const auto measures = clinic.measures(trial.id).value();
  session.uuid = trial.uuid = trial.signals_hash = "";
  session.started_utc = "2026-01-02T10:00:00Z";
  session.hand = hand;
  trial.preparations.clear();
  trial.session_id = clinic.begin_session(session).value();
  trial.id = clinic.begin_trial(trial).value();
  ASSERT_TRUE(clinic.end_trial(trial, measures));
}

TEST_F(Handle, ASessionOfBothHandsIsReportedAsOne) {
  ASSERT_TRUE(run(config("handle://" + forces(9.0))));
  const auto clinic = store();
  add_again(*clinic, std::nullopt);
  const auto content = gather_progress(*clinic, "H-01");
  ASSERT_TRUE(content) << content.error().message();
  std::vector<std::optional<Hand>> hands;
  for (const TaskSection& section : content->sections) hands.push_back(section.hand);
  std::sort(hands.begin(), hands.end());
  EXPECT_EQ(hands, (std::vector<std::optional<Hand>>{std::nullopt, Hand::right}))
      << "never compared with those of one hand";
  for (const TaskSection& section : test::every(content->sections))
    EXPECT_EQ(english(section_subtitle(section)).starts_with("Both hands"), !section.hand);
}

TEST_F(Handle, ReplayedItGivesTheSameBits) {
  const std::string uri = "handle://" + forces(9.0);
  ASSERT_TRUE(run(config(uri)));
  ASSERT_TRUE(run(config(uri)));
  const auto clinic = store();
  const auto sessions = clinic->recent_sessions(2).value();
  ASSERT_EQ(sessions.size(), 2u);
  const auto column = [&](std::size_t session) {
    const auto trials = clinic->trials(sessions[session].id).value();
    const auto signals = clinic->signals(trials.at(0)).value();
    const auto values = signals.column(columns::actual_force_N);
    return std::vector<double>(values.begin(), values.end());
  };
  EXPECT_EQ(column(0), column(1));
  EXPECT_EQ(column(0).size(), 201u) << "two seconds, and the frame that ends them";
}

TEST_F(Handle, APreparationOfAnotherKindIsStoredAndTheTrialsRestOnIt) {
  std::string text = "t_s,force_N\n";
  for (int k = 0; k < 400; ++k)  // loaded by its weight, pressed from one second on
    text += std::to_string(0.01 * k) + (k < 100 ? ",1.5\n" : ",11.5\n");
  const auto path = folder_.write("forces.csv", text);
  auto session = session::Session::open(config("handle://" + path + "?live=1&zero=1")).value();
  EXPECT_TRUE(session->known().asks_for(session::PreparationStep::zero));
  EXPECT_FALSE(session->known().asks_for(session::PreparationStep::rest));
  EXPECT_FALSE(session->snapshot().zeroed);
  ASSERT_TRUE(session->start_zero({}));
  const auto news = session->wait_for_news();
  ASSERT_TRUE(news.at(0).prepared && news[0].prepared->accepted);
  EXPECT_TRUE(session->snapshot().zeroed);
  const auto task = session::load_task(folder_.path("handling.toml")).value();
  ASSERT_TRUE(session->start_trial(task, false));
  const auto measures = session->wait_for_news().at(0).trial.value().measures;
  constexpr double kRounding_N = 1e-9;  // a mean of 20 equal numbers
  EXPECT_NEAR(value_of(measures, "peak_force"), 10.0, kRounding_N);
  session->close();
  const auto clinic = store();
  const auto record = clinic->recent_sessions(1).value().at(0);
  const auto kept = clinic->last_preparation(record, "still_handle").value().value();
  EXPECT_EQ(kept.columns, std::vector<std::string>{"force_N"});
  EXPECT_NEAR(kept.mean.at(0), 1.5, kRounding_N);
  EXPECT_EQ(kept.samples, 20);
  EXPECT_FALSE(kept.recorded_utc.empty()) << "the recorder adds when and who";
  EXPECT_EQ(clinic->trials(record.id).value().at(0).preparations,
            std::vector<storage::RowId>{kept.id});
}

TEST_F(Handle, OutOfSightIsNoFaultAndTheTrialGoesOnByItself) {
  const auto result = run(config("handle://" + forces(0.5)));
  ASSERT_TRUE(result) << result.error().message();
  const auto clinic = store();
  const auto session = clinic->recent_sessions(1).value().at(0);
  const auto trial = clinic->trials(session.id).value().at(0);
  EXPECT_EQ(trial.status, storage::TrialStatus::completed);
  std::vector<std::string> kinds;
  for (const auto& event : test::every(clinic->events(session.id).value()))
    kinds.push_back(event.kind);
  EXPECT_EQ(kinds, (std::vector<std::string>{"occluded", "resume"}));
  constexpr std::int64_t kBlindFrames = 25;
  EXPECT_EQ(trial.samples, 201 + kBlindFrames) << "the task's clock stood still";
}

TEST_F(Handle, TasksDecideTheApparatusAndADeviceThatDoesNotFitIsRefused) {
  auto wanted = config("handle://" + forces(9.0));
  wanted.apparatus = "platform";
  const auto opened = session::Session::open(wanted);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, Error::Code::bad_input) << "status 2";
  EXPECT_NE(opened.error().message().find("need another device (platform)"), std::string::npos)
      << opened.error().message();
  EXPECT_FALSE(std::filesystem::exists(wanted.database)) << "nothing is written";

  auto session = session::Session::open(config(wanted.device_uri));
  ASSERT_TRUE(session) << session.error().message();
  const auto path = session::find_in_library(kLibrary, "tasks", "grip_sine").value();
  const auto refused = (*session)->start_trial(session::load_task(path).value(), false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "device");
  EXPECT_FALSE((*session)->start_zero({true})) << "it has none";
}

TEST(ApparatusTable, EveryNameOfASimulationThatNoRowKnowsIsThePlatform) {
  for (const char* text : {"sim://healthy", "sim://paretic?seed=3"}) {
    auto opened = session::open_apparatus({Uri::parse(text).value(), Hand::right, kLibrary, {}},
                                          test::apparatuses_with_handle());
    ASSERT_TRUE(opened) << opened.error().message();
    EXPECT_EQ((*opened)->info().kind, "platform");
    EXPECT_EQ((*opened)->steps().size(), 2u);
  }
  const auto unknown =
      session::open_apparatus({Uri::parse("nothing://there").value(), Hand::right, kLibrary, {}});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("no device is called nothing://"), std::string::npos)
      << unknown.error().message();
}

}  // namespace
}  // namespace isograsp::reports::other_apparatus_test
