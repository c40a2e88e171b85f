// SPDX-License-Identifier: GPL-3.0-or-later
// Answers are events of a trial: what was said last counts, and what is no answer is passed over.
#include "storage/records/trial_answers.hpp"

#include <gtest/gtest.h>

namespace isograsp::storage::trial_answers_test {
namespace {

EventRecord said(RowId trial, const std::string& question, std::optional<int> number) {
  return {trial, 1.0, kAnswerEvent, answer_text(question, number)};
}

TEST(TrialAnswers, TheLastAnswerOfTheTrialCounts) {
  const std::vector<EventRecord> events{said(1, "a.b", 3), said(2, "a.b", 9), said(1, "a.c", 0),
                                        said(1, "a.b", 5), said(1, "a.c", std::nullopt)};
  const TrialAnswers answers = answers_of(1, events);
  EXPECT_EQ(answers, (TrialAnswers{{"a.b", 5}, {"a.c", std::nullopt}}));
}

TEST(TrialAnswers, WhatIsNoAnswerIsPassedOver) {
  const std::vector<EventRecord> events{
      {1, 1.0, "note", "a.b 3"},      {std::nullopt, 1.0, kAnswerEvent, "a.b 3"},
      {1, 1.0, kAnswerEvent, "a.b"},  {1, 1.0, kAnswerEvent, "a.b 3x"},
      {1, 1.0, kAnswerEvent, "a.b "}, {1, 1.0, kAnswerEvent, "a.b 99999999999999999999"}};
  EXPECT_TRUE(answers_of(1, events).empty());
}

}  // namespace
}  // namespace isograsp::storage::trial_answers_test
