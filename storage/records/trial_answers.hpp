// SPDX-License-Identifier: GPL-3.0-or-later
// Answers of a person to the questions of a task, kept as events of the trial. Any thread.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "storage/records/records.hpp"

namespace isograsp::storage {

/// EventRecord::kind of an answer.
inline constexpr const char* kAnswerEvent = "answer";

/// "virtual_grasp.naturalness 7"; without a number: the person was asked and gave none.
[[nodiscard]] std::string answer_text(const std::string& question, std::optional<int> number);

/// By question; a later answer takes the place of an earlier one. Texts that are no answer are
/// passed over.
using TrialAnswers = std::map<std::string, std::optional<int>>;
[[nodiscard]] TrialAnswers answers_of(RowId trial, std::span<const EventRecord> events);

}  // namespace isograsp::storage
