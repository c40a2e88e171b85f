// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient is asked to do, as a task file says it (docs/file_formats.md). SI units,
// radians.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "tasks/kind_spec.hpp"
#include "tasks/looks/look.hpp"
#include "tasks/questions/questionnaire.hpp"

namespace isograsp::tasks {

struct TaskSpec {
  std::string name;         ///< for people: "Grip force, sine"
  std::string instruction;  ///< plain words for the patient
  int version = 1;
  KindSpec kind;
  std::optional<Difficulty> difficulty;
  /// In which look it trains, as its file asks; nothing: the usual one of its kind.
  std::optional<Look> training_look;
  /// What the screen looks like in this trial: plain, unless it is at a level of its difficulty,
  /// which is never an assessment.
  Look look = Look::plain;
  const Questionnaire* questionnaire = nullptr;  ///< asked after each trial; null: nothing is
  std::string file;                              ///< where it was read from, for errors
  std::string text;                              ///< the file itself: stored with every trial

  // What its kind says of it (kind_facts.hpp).
  /// The scene the task needs; empty: none (a force task has no object).
  [[nodiscard]] std::string scene() const;
  /// The apparatus that it is done with: "platform"; empty: any.
  [[nodiscard]] std::string_view apparatus() const;
  [[nodiscard]] Duration duration() const;
  /// How force and target are shown and scaled; null: the task has no force target.
  [[nodiscard]] const Aim* aim() const;
  /// The force that is to be as large as possible, or as is comfortable; null: there is not one.
  [[nodiscard]] const ForceChannel* effort() const;
  /// Largest level of the task, in units of its scale.
  [[nodiscard]] double largest_level() const;
  /// The channels whose maximum, or comfortable force, must have been measured in the session.
  [[nodiscard]] std::vector<ForceChannel> channels_needed(Scale scale) const;
  [[nodiscard]] bool needs_maximum() const { return !channels_needed(Scale::of_maximum).empty(); }
  /// The channels whose maximum, or comfortable force, it measures.
  [[nodiscard]] std::vector<ForceChannel> channels_measured(Scale scale) const;
  /// The shape of the force target; null: it has none that a task file describes.
  [[nodiscard]] const Waveform* waveform() const;
  /// Where the object is to be brought, and how near is near enough.
  [[nodiscard]] std::vector<TargetPlace> targets() const;
  [[nodiscard]] std::optional<PoseTolerance> tolerance() const;
  /// How heavy the object is made for two hands; nothing: it is as the scene says.
  [[nodiscard]] std::optional<HandsLoad> hands_load() const;
  /// How two hands that are points carry its object; nothing: they do not.
  [[nodiscard]] std::optional<HandsCarry> hands_carry() const;
  /// How its target moves, seen in one degree of freedom; nothing: it does not.
  [[nodiscard]] std::optional<AxisCourse> course(double period_s) const;
  /// Efforts that a task asks for: presses, cues, holds, targets, cycles of a periodic target; 1
  /// for all that goes on without a break, 0 at rest.
  [[nodiscard]] int repetitions() const;
};

/// The task at a level of its difficulty, 0 … 1, in this look (nothing: the one it trains in);
/// level and look stand at the end of its text, so that a trial is stored with them.
/// @pre spec.difficulty
[[nodiscard]] Result<TaskSpec> at_level(const TaskSpec& spec, double level,
                                        std::optional<Look> look = {});

[[nodiscard]] Result<TaskSpec> parse_task(std::string_view text, const std::string& file);

}  // namespace isograsp::tasks
