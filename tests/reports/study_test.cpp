// SPDX-License-Identifier: GPL-3.0-or-later
// Group reports: the study file says what is compared, the records give the values, and the report
// says the same in HTML and PDF.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "reports/study/study_report.hpp"
#include "reports/study/study_writer.hpp"
#include "storage/access/open_store.hpp"
#include "storage/person/consent.hpp"
#include "storage/records/session_store.hpp"
#include "storage/records/trial_answers.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::study_test {
namespace {

namespace fs = std::filesystem;

const std::string kFile = R"(format = "isograsp-study-1"
title = "Grip over four weeks"
measure = "maximum_force"
channel = "grip"
task = "Maximum grip force"
hand = "right"
analyses = ["anova", "ranks", "reliability"]
[[group]]
name = "all"
patients = ["TK-101", "TK-102", "TK-103", "TK-104", "TK-105", "TK-106", "TK-107"]
[[factor]]
name = "week"
[[factor.level]]
name = "week 0"
days = [0, 3]
[[factor.level]]
name = "week 2"
days = [12, 16]
[[factor.level]]
name = "week 4"
days = [26, 30]
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string refusal(const std::string& text) {
  const auto study = parse_study(text, "study.toml");
  EXPECT_FALSE(study.ok()) << text;
  return study ? "" : study.error().message();
}

TEST(StudyFile, ConditionsAreTheProductOfTheFactors) {
  auto text = replaced(kFile, "hand = \"right\"\n", "");
  text = replaced(text, "[\"anova\", \"ranks\", \"reliability\"]", "[\"anova\"]");
  text +=
      "[[factor]]\nname = \"side\"\n[[factor.level]]\nname = \"affected\"\nhand = \"affected\"\n"
      "[[factor.level]]\nname = \"other\"\nhand = \"other\"\n";
  const auto study = parse_study(text, "study.toml");
  ASSERT_TRUE(study.ok()) << study.error().message();
  const auto conditions = conditions_of(*study);
  ASSERT_EQ(conditions.size(), 6U);
  EXPECT_EQ(conditions[1].name, "week 0, other");
  EXPECT_EQ(conditions[1].selection.hand, StudyHand::other);
  EXPECT_EQ(conditions[1].selection.days->to, 3);
  EXPECT_EQ(conditions[2].name, "week 2, affected");
  EXPECT_EQ(conditions[2].selection.task, "Maximum grip force");
}

TEST(StudyFile, WhatIsWrongIsNamedWithItsLine) {
  EXPECT_EQ(refusal(replaced(kFile, "channel", "chanel")).find("study.toml:4: chanel"), 0U);
  EXPECT_NE(refusal(replaced(kFile, "hand = \"right\"\n", "")).find("hand: is not given"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "TK-102", "TK-101")).find("listed twice"), std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "days = [12, 16]", "days = [16, 12]")).find("study.toml:18:"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "days = [12, 16]", "sessions = [4]")).find("other keys"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "days = [12, 16]", "days = [1.5, 2]")).find("whole number"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "hand = \"right\"", "hand = \"right\"\nsessions = [1]"))
                .find("by sessions or by days"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "hand = \"right\"", "hand = \"right\"\ndays = [1, 2]"))
                .find("given elsewhere too"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "\"ranks\"", "\"rank\"")).find("'rank' is no analysis"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(kFile, "week 2", "week 0")).find("given twice"), std::string::npos);
  EXPECT_NE(refusal(kFile.substr(0, kFile.find("[[factor]]"))).find("0 factors"),
            std::string::npos);
  EXPECT_NE(refusal(kFile.substr(0, kFile.find("[[group]]"))).find("group"), std::string::npos);
}

TEST(StudyFile, TheExampleOfTheDocumentationIsOne) {
  const auto docs = read_text(std::string(ISOGRASP_SOURCE_DIR) + "/docs/file_formats.md");
  ASSERT_TRUE(docs.ok());
  const auto begin = docs->find("format = \"isograsp-study-1\"");
  ASSERT_NE(begin, std::string::npos);
  const auto study = parse_study(docs->substr(begin, docs->find("```", begin) - begin), "example");
  EXPECT_TRUE(study.ok()) << study.error().message();
}

/// One session with two attempts at the maximum, of which only the measures are stored.
struct Attempts {
  std::string date;
  double maximum_N = 10.0;
  bool simulated = false;
  int task_version = 1;
  std::string time = "09:30:00";
  bool practice = false;
  std::vector<int> answers = {};  ///< of both trials: how natural it was
};

class StudyOfClinic : public testing::Test {
 protected:
  void SetUp() override {
    test::draw_without_a_display();
    auto opened = storage::open_store(folder_.path("clinic.db"), storage::OpenMode::scratch);
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    store_ = std::move(*opened);
  }

  void add(const std::string& code, const Attempts& attempts) {
    const auto found = store_->find_patient(code);
    ASSERT_TRUE(found.ok());
    storage::SessionRecord session;
    session.patient_id = *found ? (*found)->id : store_->add_patient(code)->id;
    session.started_utc = attempts.date + "T" + attempts.time + "Z";
    session.device_uri = "can://can0?protocol=rft";
    session.simulated = attempts.simulated;
    const auto id = store_->begin_session(session);
    ASSERT_TRUE(id.ok()) << id.error().message();
    for (int number = 1; number <= 2; ++number) {
      storage::TrialRecord trial;
      trial.session_id = *id;
      trial.number = number;
      trial.task_name = "Maximum grip force";
      trial.task_version = attempts.task_version;
      trial.practice = attempts.practice;
      trial.groups = {{"task", {"t_s"}}};
      const auto trial_id = store_->begin_trial(trial);
      ASSERT_TRUE(trial_id.ok()) << trial_id.error().message();
      trial.id = *trial_id;
      trial.status = storage::TrialStatus::completed;
      const double value = attempts.maximum_N * (number == 1 ? 0.96 : 1.0);
      const std::vector<Measure> measures{{"maximum_force", "grip", value, "N", 1, 300, 0, ""}};
      ASSERT_TRUE(store_->end_trial(trial, measures).ok());
      for (const int answer : attempts.answers)
        ASSERT_TRUE(
            store_
                ->add_event(*id, {trial.id, 60.0, storage::kAnswerEvent,
                                  storage::answer_text("virtual_grasp.naturalness", answer)})
                .ok());
    }
    ASSERT_TRUE(store_->end_session(*id).ok());
  }

  /// Seven people of different strength, three sessions each; the last person has only two.
  void fill() {
    const char* const dates[] = {"2026-03-02", "2026-03-16", "2026-03-30"};
    for (int person = 0; person < 7; ++person)
      for (int session = 0; session < (person == 6 ? 2 : 3); ++session)
        add("TK-10" + std::to_string(person + 1),
            {dates[session],
             9.0 + 1.3 * person + 1.1 * session + 0.5 * ((person * 3 + session * 5) % 4)});
  }

  Result<StudyData> gather(const std::string& text) {
    const auto study = parse_study(text, "study.toml");
    EXPECT_TRUE(study.ok()) << (study ? "" : study.error().message());
    if (!study) return study.error();
    study_ = *study;
    return gather_study(*store_, *study, "study.toml");
  }

  /// The mean of what is stored of a session's maximum trials.
  double stored(const std::string& code, int session) {
    const auto patient = store_->find_patient(code);
    const auto sessions = store_->sessions((*patient)->id);
    double sum = 0.0;
    int count = 0;
    const auto points = store_->progress((*patient)->id);
    for (const auto& point : *points)
      if (point.session_id == (*sessions)[static_cast<std::size_t>(session)].id &&
          point.measure.name == "maximum_force" && point.measure.channel == "grip") {
        sum += *point.measure.value;
        ++count;
      }
    EXPECT_EQ(count, 2);
    return sum / count;
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<storage::SessionStore> store_;
  Study study_;
};

TEST_F(StudyOfClinic, ValuesAreTheMeansOfTheStoredTrials) {
  fill();
  const auto data = gather(kFile);
  ASSERT_TRUE(data.ok()) << data.error().message();
  ASSERT_EQ(data->groups.size(), 1U);
  EXPECT_EQ(data->unit, "N");
  const auto table = data->groups[0].table();
  ASSERT_EQ(table.rows(), 7);
  ASSERT_EQ(table.cols(), 3);
  for (int person = 0; person < 6; ++person)
    for (int session = 0; session < 3; ++session)
      EXPECT_DOUBLE_EQ(table(person, session),
                       stored("TK-10" + std::to_string(person + 1), session));
  const auto& missing = data->groups[0].cells[6][2];
  EXPECT_FALSE(missing.value);
  EXPECT_EQ(english(missing.reason), "no such session");
  const auto analysis = analyse(study_, data->groups[0]);
  EXPECT_EQ(analysis.complete.kept.size(), 6U);
  EXPECT_TRUE(analysis.one_way->effect.p.value);
  EXPECT_TRUE(analysis.friedman->p.value);
  EXPECT_TRUE(analysis.reliability->icc.value);
  EXPECT_EQ(analysis.signed_ranks.size(), 3U);
}

TEST_F(StudyOfClinic, AnswersToQuestionsAreComparedLikeMeasuresAlsoOfPractice) {
  for (int person = 0; person < 7; ++person)
    for (const char* date : {"2026-03-02", "2026-03-16", "2026-03-30"}) {
      Attempts attempts{date};
      attempts.practice = true;
      attempts.answers = {1, 3 + person};  // said last
      add("TK-10" + std::to_string(person + 1), attempts);
    }
  const auto asked = replaced(replaced(kFile, "maximum_force", "virtual_grasp.naturalness"),
                              "channel = \"grip\"\n", "");
  EXPECT_FALSE(gather(asked).ok()) << "practice is not asked for";
  const auto data = gather(replaced(asked, "hand = ", "practice = true\nhand = "));
  ASSERT_TRUE(data.ok()) << data.error().message();
  EXPECT_EQ(data->unit, "of 10");
  const auto table = data->groups[0].table();
  for (int person = 0; person < 7; ++person) EXPECT_EQ(table(person, 2), 3.0 + person);
}

TEST_F(StudyOfClinic, SimulatedAndOtherTasksDoNotMix) {
  fill();
  Attempts attempts{"2026-03-31"};
  attempts.simulated = true;
  add("TK-107", attempts);
  auto data = gather(kFile);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(english(data->groups[0].cells[6][2].reason), "other source of forces");
  attempts.simulated = false;
  attempts.task_version = 2;
  add("TK-107", attempts);
  data = gather(kFile);
  ASSERT_TRUE(data.ok());
  EXPECT_EQ(english(data->groups[0].cells[6][2].reason), "other version of the task");
  ASSERT_EQ(data->left_out.size(), 1U);
  EXPECT_EQ(english(data->left_out[0]), "2 trials: other version of the task");
}

TEST_F(StudyOfClinic, WhoIsNotReleasedForResearchStandsInNone) {
  fill();
  const auto access = storage::Access::open(folder_.path("clinic.db"));
  ASSERT_TRUE(access.ok()) << access.error().message();
  const auto say = [&](const char* state) {
    const storage::Consent said{0, "2026-04-02", "research", "consent", state, "", "", ""};
    EXPECT_TRUE(storage::add_consent(**access, "TK-103", said).ok());
    return gather(kFile);
  };
  EXPECT_TRUE(say("given").ok());
  const auto data = say("withdrawn");
  ASSERT_FALSE(data.ok());
  EXPECT_NE(data.error().message().find("TK-103 are not released for research"), std::string::npos);
  EXPECT_EQ(data.error().field, "patients");
}

TEST_F(StudyOfClinic, ADayOfAConditionIsAWholeDayThoughItsSessionIsEarlier) {
  fill();
  // A fortnight but an hour after the first session.
  Attempts early{"2026-03-16"};
  early.time = "08:30:00";
  add("TK-108", {"2026-03-02"});
  add("TK-108", early);
  add("TK-108", {"2026-03-30"});
  const auto data = gather(replaced(replaced(kFile, "[12, 16]", "[14, 14]"), "TK-107", "TK-108"));
  ASSERT_TRUE(data.ok()) << data.error().message();
  EXPECT_TRUE(data->groups[0].cells[6][1].value) << english(data->groups[0].cells[6][1].reason);
}

TEST_F(StudyOfClinic, WhatMakesNoSenseIsRefused) {
  fill();
  const auto message = [this](const std::string& text) {
    const auto data = gather(text);
    EXPECT_FALSE(data.ok());
    return data ? "" : data.error().message();
  };
  EXPECT_NE(message(replaced(kFile, "[12, 16]", "[0, 16]")).find("S01 stands in \"week 0\""),
            std::string::npos);
  EXPECT_NE(message(replaced(kFile, "TK-103", "TK-303")).find("TK-303"), std::string::npos);
  EXPECT_NE(
      message(replaced(kFile, "\"maximum_force\"", "\"no_force\"")).find("nobody has a value"),
      std::string::npos);
  EXPECT_NE(message(replaced(kFile, "hand = \"right\"", "hand = \"affected\"")).find("nobody"),
            std::string::npos);
}

TEST_F(StudyOfClinic, HtmlAndPdfSayTheSameAndNameNobody) {
  fill();
  const auto data = gather(kFile);
  ASSERT_TRUE(data.ok());
  const std::vector<GroupAnalysis> analyses{analyse(study_, data->groups[0])};
  const auto report = study_report(study_, *data, analyses);
  const auto html = study_html(report);
  const auto pdf = folder_.path("study.pdf");
  ASSERT_TRUE(write_text(pdf, study_pdf(report)).ok());
  if (const char* keep = std::getenv("ISOGRASP_KEEP_REPORTS"); keep != nullptr) {
    fs::copy_file(pdf, fs::path(keep) / "study.pdf", fs::copy_options::overwrite_existing);
    ASSERT_TRUE(write_text(fs::path(keep) / "study.html", html).ok());
  }
  const auto csv = study_csv(study_, *data);
  const auto json = study_json(study_, *data, analyses);
  for (const auto& text : {html, csv, json}) EXPECT_EQ(text.find("TK-10"), std::string::npos);
  EXPECT_EQ(html.find("SIMULATED"), std::string::npos);
  EXPECT_NE(csv.find("all,S07,week 4,week 4,,N,0,0,no such session"), std::string::npos);
  const auto parsed = nlohmann::json::parse(json);
  EXPECT_EQ(parsed["groups"][0]["n"], 6);
  EXPECT_EQ(parsed["groups"][0]["anova"]["effect"]["f"], *analyses[0].one_way->effect.f.value);
  // No verdicts.
  for (const char* word : {"significant", "improved", "worsened", "better than", "proves"})
    EXPECT_EQ(html.find(word), std::string::npos) << word;
  if (std::system("command -v pdftotext > /dev/null") != 0)
    GTEST_SKIP() << "pdftotext is not installed";
  const auto text_file = folder_.path("text.txt");
  ASSERT_EQ(std::system(("pdftotext -layout '" + pdf + "' '" + text_file + "'").c_str()), 0);
  const auto text = test::read_file(text_file);
  EXPECT_EQ(text.find("TK-10"), std::string::npos);
  // Every cell of every table that is one word stands in both.
  int cells = 0;
  for (const auto& block : test::every(report.blocks))
    if (const auto* table = std::get_if<StudyTable>(&block))
      for (const auto& row : test::every(table->rows))
        for (const auto& cell : test::every(row)) {
          if (cell.empty() || cell.find(' ') != std::string::npos ||
              cell.find_first_of("<>") != std::string::npos)
            continue;
          EXPECT_NE(html.find(cell), std::string::npos) << cell;
          EXPECT_NE(text.find(cell), std::string::npos) << cell;
          ++cells;
        }
  EXPECT_GT(cells, 40);
}

/// Every leaf of a result: no null, and what is undefined says why.
void expect_told(const nlohmann::json& json, const std::string& path) {
  EXPECT_FALSE(json.is_null()) << path;
  if (json.is_object() && json.contains("undefined")) {
    EXPECT_NE(json["undefined"], "") << path;
  }
  if (json.is_structured())
    for (const auto& [key, value] : json.items()) expect_told(value, path + "/" + key);
}

TEST_F(StudyOfClinic, ValuesNearTheLargestNumberHaveMeansAndWhatHasNoFigureSaysWhy) {
  const char* const dates[] = {"2026-03-02", "2026-03-16", "2026-03-30"};
  const auto maximum_N = [](int person, int session) {
    return 1e307 * (9.0 + 0.9 * person + ((person * 3 + session * 5) % 4));
  };
  for (int person = 0; person < 7; ++person)
    for (int session = 0; session < 3; ++session)
      add("TK-10" + std::to_string(person + 1), {dates[session], maximum_N(person, session)});
  const auto data = gather(kFile);
  ASSERT_TRUE(data.ok()) << data.error().message();
  const std::vector<GroupAnalysis> analyses{analyse(study_, data->groups[0])};
  for (int person = 0; person < 7; ++person)
    for (int session = 0; session < 3; ++session)
      EXPECT_DOUBLE_EQ(
          *data->groups[0]
               .cells[static_cast<std::size_t>(person)][static_cast<std::size_t>(session)]
               .value,
          0.98 * maximum_N(person, session));
  for (const auto& condition : test::every(analyses[0].conditions)) {
    ASSERT_TRUE(condition.mean.value);
    EXPECT_TRUE(std::isfinite(*condition.mean.value));
    ASSERT_TRUE(condition.sd.value) << english(condition.sd.reason);
    EXPECT_TRUE(std::isfinite(*condition.sd.value));
  }
  const auto json = nlohmann::json::parse(study_json(study_, *data, analyses));
  expect_told(json, "");
  EXPECT_TRUE(json["groups"][0]["wilcoxon"][0]["p"].is_number());
  EXPECT_NE(json["groups"][0]["anova"]["effect"]["f"]["undefined"], "");
  EXPECT_EQ(study_csv(study_, *data).find("inf"), std::string::npos);
  const auto report = study_report(study_, *data, analyses);
  EXPECT_EQ(study_html(report).find(">inf"), std::string::npos);
  EXPECT_FALSE(study_pdf(report).empty());
}

TEST_F(StudyOfClinic, FewPeopleGetReasonsAndSimulatedOnesAWatermark) {
  for (const char* date : {"2026-03-02", "2026-03-16", "2026-03-30"})
    add("TK-101", {date, 10.0, true});
  auto text = replaced(
      kFile, ", \"TK-102\", \"TK-103\", \"TK-104\", \"TK-105\", \"TK-106\", \"TK-107\"", "");
  const auto data = gather(replaced(text, "hand =", "source = \"simulated\"\nhand ="));
  ASSERT_TRUE(data.ok()) << data.error().message();
  const auto html = study_html(study_report(study_, *data, {analyse(study_, data->groups[0])}));
  EXPECT_NE(html.find("not defined: needs at least 2 subjects, has 1"), std::string::npos);
  EXPECT_NE(html.find("SIMULATED DEVICE"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::reports::study_test
