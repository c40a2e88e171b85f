// SPDX-License-Identifier: GPL-3.0-or-later
// What a study compares, declared in a file (`isograsp-study-1`, docs/file_formats.md): groups of
// patients, one or two factors within them, a measure, and the analyses chosen beforehand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reports/findings/report_content.hpp"

namespace isograsp::reports {

enum class StudyHand : std::uint8_t { right, left, affected, other, both };

/// Which trials of a person; what is absent does not select.
struct TrialSelection {
  std::optional<std::string> task;     ///< its name
  std::optional<std::string> channel;  ///< of the measure
  std::optional<StudyHand> hand;
  std::vector<int> sessions;  ///< numbers of the person's sessions, from 1
  struct Days {
    int from = 0;  ///< since the person's first session [d]
    int to = 0;    ///< inclusive
  };
  std::optional<Days> days;
};

struct StudyLevel {
  std::string name;
  TrialSelection selection;
};
struct StudyFactor {
  std::string name;
  std::vector<StudyLevel> levels;
};
struct StudyGroup {
  std::string name;
  std::vector<std::string> patients;  ///< codes
};
enum class StudyAnalysis : std::uint8_t { anova, ranks, reliability };

struct Study {
  std::string title;
  std::string measure;
  Source source = Source::device;
  double confidence = 0.95;
  /// Trials of practice count, too: those of tasks that help are nothing else.
  bool practice = false;
  TrialSelection common;
  std::vector<StudyGroup> groups;
  std::vector<StudyFactor> factors;  ///< one or two; each level of one selects by the same keys
  std::vector<StudyAnalysis> analyses;
};

/// Reads the text of a study file; `file` stands in errors. A key may be given at one place only,
/// so a condition is what the file, a level of the first and a level of the second factor say
/// together; task and hand must be given.
[[nodiscard]] Result<Study> parse_study(std::string_view text, const std::string& file);

/// The conditions, in the order of the columns of all tables: the last factor changes first.
struct StudyCondition {
  std::string name;  ///< "week 1", "week 1, left"
  TrialSelection selection;
};
[[nodiscard]] std::vector<StudyCondition> conditions_of(const Study& study);

}  // namespace isograsp::reports
