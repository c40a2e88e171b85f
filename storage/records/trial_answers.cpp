// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/records/trial_answers.hpp"

#include <charconv>

namespace isograsp::storage {

namespace {
constexpr std::string_view kNoAnswer = "no answer";
}

std::string answer_text(const std::string& question, std::optional<int> number) {
  return question + " " + (number ? std::to_string(*number) : std::string(kNoAnswer));
}

TrialAnswers answers_of(RowId trial, std::span<const EventRecord> events) {
  TrialAnswers answers;
  for (const auto& event : events) {
    if (event.kind != kAnswerEvent || event.trial_id != trial) continue;
    const auto space = event.text.find(' ');
    if (space == std::string::npos) continue;
    const std::string_view said = std::string_view(event.text).substr(space + 1);
    std::optional<int> number;
    if (said != kNoAnswer) {
      int value = 0;
      const auto [end, error] = std::from_chars(said.data(), said.data() + said.size(), value);
      if (error != std::errc() || end != said.data() + said.size()) continue;
      number = value;
    }
    answers[event.text.substr(0, space)] = number;
  }
  return answers;
}

}  // namespace isograsp::storage
