// SPDX-License-Identifier: GPL-3.0-or-later
// Questions of a task: their names lead back to them, and a task file names a questionnaire.
#include "tasks/questions/questionnaire.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tasks/facts/measure_words.hpp"
#include "tasks/task_spec.hpp"
#include "tests/support/every.hpp"

namespace isograsp::tasks::questionnaire_test {
namespace {

const std::string kTask = R"(format = "isograsp-task-1"
name = "Rest"
instruction = "Rest."
version = 1
kind = "rest"
duration_s = 10
)";

TEST(Questionnaire, EveryQuestionHasOneNameThatLeadsBackToIt) {
  std::set<std::string> names;
  for (const Questionnaire& one : test::every(questionnaires())) {
    EXPECT_LT(one.least, one.most);
    for (const Question& question : test::every(one.questions)) {
      const std::string name = AskedQuestion{&one, &question}.full_name();
      EXPECT_TRUE(names.insert(name).second) << name;
      const auto found = question_named(name);
      ASSERT_TRUE(found) << name;
      EXPECT_EQ(found->question, &question);
      EXPECT_EQ(found->of, &one);
      EXPECT_EQ(english(words_of(name, "").title), english(question.title));
    }
  }
}

TEST(Questionnaire, OtherNamesAreNoQuestions) {
  for (const char* name : {"", ".", "virtual_grasp", "virtual_grasp.", "virtual_grasp.realism",
                           "efficiency", "nobody.efficiency"})
    EXPECT_FALSE(question_named(name)) << name;
}

TEST(Questionnaire, ATaskFileNamesOneAndAnotherWordIsRefusedWithThoseThatThereAre) {
  const auto none = parse_task(kTask, "t.toml");
  ASSERT_TRUE(none.ok()) << none.error().message();
  EXPECT_EQ(none->questionnaire, nullptr);
  const auto asked = parse_task(kTask + "questionnaire = \"two_hands\"\n", "t.toml");
  ASSERT_TRUE(asked.ok()) << asked.error().message();
  ASSERT_NE(asked->questionnaire, nullptr);
  EXPECT_EQ(asked->questionnaire->most, 7);
  const auto wrong = parse_task(kTask + "questionnaire = \"mood\"\n", "t.toml");
  ASSERT_FALSE(wrong.ok());
  const std::string message = wrong.error().message();
  EXPECT_NE(message.find("t.toml:7: questionnaire"), std::string::npos) << message;
  EXPECT_NE(message.find("virtual_grasp"), std::string::npos) << message;
}

}  // namespace
}  // namespace isograsp::tasks::questionnaire_test
