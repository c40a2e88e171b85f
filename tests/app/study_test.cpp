// SPDX-License-Identifier: GPL-3.0-or-later
// `isograsp study`: from recorded sessions to a group report.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace isograsp::app::study_test {
namespace {

using test::CommandResult;

const std::string kStudy = R"(format = "isograsp-study-1"
title = "First and second session"
measure = "maximum_force"
channel = "grip"
task = "Maximum grip force"
hand = "right"
source = "simulated"
analyses = ["anova", "ranks"]
[[group]]
name = "everybody"
patients = ["P-101", "P-102", "P-103"]
[[factor]]
name = "session"
[[factor.level]]
name = "first"
sessions = [1]
[[factor.level]]
name = "second"
sessions = [2]
)";

TEST(Study, OfRecordedSessionsIsWrittenInEveryForm) {
  const test::TemporaryFolder folder;
  const std::string db = folder.path("clinic.db");
  int seed = 0;
  for (const char* patient : {"P-101", "P-102", "P-103"})
    for (int session = 0; session < 2; ++session) {
      const auto run =
          test::isograsp("run --fast --db " + db + " --patient " + patient +
                         " --device 'sim://mild?seed=" + std::to_string(++seed) +
                         "' --protocol-file " ISOGRASP_SOURCE_DIR "/library/protocols/short.toml");
      ASSERT_EQ(run.status, 0) << run.err;
    }
  const auto study = folder.write("study.toml", kStudy);
  const std::string command = "study --db " + db + " --study " + study;
  for (const char* name : {"study.html", "study.pdf", "study.csv"}) {
    const auto done = test::isograsp(command + " --out " + folder.path(name));
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_GT(std::filesystem::file_size(folder.path(name)), 100U);
  }
  EXPECT_NE(test::read_file(folder.path("study.html")).find("SIMULATED DEVICE"), std::string::npos);
  EXPECT_NE(test::read_file(folder.path("study.csv")).find(",simulated device\n"),
            std::string::npos)
      << "each row says where its forces came from";
  const CommandResult json = test::isograsp(command + " --json");
  ASSERT_EQ(json.status, 0) << json.err;
  const auto group = nlohmann::json::parse(json.out)["groups"][0];
  EXPECT_EQ(group["n"], 3);
  EXPECT_EQ(group["anova"]["pairs"].size(), 1U);
}

const char* const kTechniques[] = {"clutch", "bubble", "clutch_pinch", "bubble_pinch"};
const char* const kTechniqueTasks[] = {"Two hands, carry: clutch", "Two hands, carry: bubbles",
                                       "Two hands, carry: clutch and pinch",
                                       "Two hands, carry: bubbles and pinch"};

TEST(Study, OfFourWaysToCarryWithBothHandsComparesThemByRanksWithinPeople) {
  const test::TemporaryFolder folder;
  const std::string db = folder.path("clinic.db");
  std::string steps =
      "format = \"isograsp-protocol-1\"\nname = \"Four ways\"\n[[step]]\nkind = "
      "\"instrument_zero\"\n";
  const auto step = [&steps](const std::string& task) {
    steps += "[[step]]\nkind = \"task\"\ntask = \"" + task + ".toml\"\n";
  };
  step("two_hands_rest");
  step("two_hands_maximum");
  for (const char* how : kTechniques) step(std::string("two_hands_carry_") + how);
  const auto protocol = folder.write("four.toml", steps);
  std::string people;
  for (int person = 1; person <= 4; ++person) {
    const std::string pair = "'sim://pair?file=healthy&seed=" + std::to_string(person) + "'";
    const std::string code = "V-" + std::to_string(person);
    people += (person > 1 ? ", \"" : "\"") + code + "\"";
    const auto run =
        test::isograsp("run --fast --db " + db + " --patient " + code + " --device-left " + pair +
                       " --device-right " + pair + " --protocol-file " + protocol);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  std::string text =
      "format = \"isograsp-study-1\"\ntitle = \"Carrying\"\nmeasure = "
      "\"restricted_mean_time\"\nchannel = \"targets\"\nhand = \"both\"\nsource = "
      "\"simulated\"\nanalyses = [\"ranks\"]\n[[group]]\nname = \"volunteers\"\npatients = [" +
      people + "]\n[[factor]]\nname = \"technique\"\n";
  for (std::size_t k = 0; k < 4; ++k)
    text += std::string("[[factor.level]]\nname = \"") + kTechniques[k] + "\"\ntask = \"" +
            kTechniqueTasks[k] + "\"\n";
  const auto study = folder.write("study.toml", text);
  const std::string command = "study --db " + db + " --study " + study;
  for (const char* name : {"study.html", "study.pdf", "study.csv"}) {
    const auto done = test::isograsp(command + " --out " + folder.path(name));
    ASSERT_EQ(done.status, 0) << done.err;
  }
  const CommandResult json = test::isograsp(command + " --json");
  ASSERT_EQ(json.status, 0) << json.err;
  const auto group = nlohmann::json::parse(json.out)["groups"][0];
  EXPECT_EQ(group["n"], 4);
  EXPECT_EQ(group["friedman"]["df"], 3) << group.dump();
  EXPECT_EQ(group["wilcoxon"].size(), 6U) << group.dump();
}

TEST(Study, WhatCannotBeReadIsNamedAndNothingIsWritten) {
  const test::TemporaryFolder folder;
  const auto study = folder.write("study.toml", "format = \"isograsp-study-1\"\nmeasures = 1\n");
  const auto out = folder.path("study.pdf");
  const auto bad = test::isograsp("study --db none.db --study " + study + " --out " + out);
  EXPECT_EQ(bad.status, 2);
  EXPECT_NE(bad.err.find("study.toml"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
  const auto docx = test::isograsp("study --db none.db --study " + study + " --out study.docx");
  EXPECT_NE(docx.err.find(".html, .pdf or .csv"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::app::study_test
