// SPDX-License-Identifier: GPL-3.0-or-later
// What a person is asked about a task when a trial of it is over, as numbers on a scale whose ends
// have words. A task file names one (`questionnaire`); an answer is stored with the trial
// (docs/file_formats.md). Any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::tasks {

struct Question {
  std::string_view name;  ///< "naturalness"
  Words title;            ///< of its values in tables: "Naturalness"
  Words words;            ///< as it is asked
};

struct Questionnaire {
  std::string_view name;  ///< in task files: "virtual_grasp"
  int least = 0;
  int most = 10;
  Words least_words;  ///< what the least number means
  Words most_words;
  std::span<const Question> questions;
};

[[nodiscard]] std::span<const Questionnaire> questionnaires() noexcept;
/// Null: there is none of this name.
[[nodiscard]] const Questionnaire* questionnaire_named(std::string_view name) noexcept;

/// A question by the name with which its answers are stored.
struct AskedQuestion {
  const Questionnaire* of = nullptr;
  const Question* question = nullptr;
  [[nodiscard]] std::string full_name() const;  ///< "virtual_grasp.naturalness"
};
[[nodiscard]] std::optional<AskedQuestion> question_named(std::string_view full_name) noexcept;

}  // namespace isograsp::tasks
