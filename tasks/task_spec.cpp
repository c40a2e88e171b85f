// SPDX-License-Identifier: GPL-3.0-or-later
// Task files: TOML in, TaskSpec out. Degrees in the file, radians inside.
#include "tasks/task_spec.hpp"

#include <cmath>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "tasks/read_keys.hpp"
#include "tasks/timeline.hpp"

namespace isograsp::tasks {

namespace {

/// Frame period of the estimate of durations: fine enough for a clock on a wall.
constexpr double kEstimatePeriod_s = 0.1;

double duration_of_segments(const KindSpec& kind, Pace::Waits waits) {
  Pace pace(kEstimatePeriod_s, 0, waits);
  const Timeline timeline{kind->segments(
      kind, [](ForceChannel) { return 1.0; }, pace)};
  return static_cast<double>(timeline.frames()) * kEstimatePeriod_s;
}

}  // namespace

std::string_view TaskSpec::apparatus() const {
  constexpr std::string_view kOfScenes = "platform";
  return kind->apparatus.empty() && !scene().empty() ? kOfScenes : kind->apparatus;
}

std::string TaskSpec::scene() const {
  return kind->scene != nullptr ? kind->scene(kind) : "";
}

Duration TaskSpec::duration() const {
  if (kind->duration != nullptr) return kind->duration(kind);
  if (kind->segments == nullptr) return {};
  return {duration_of_segments(kind, Pace::Waits::mean),
          duration_of_segments(kind, Pace::Waits::longest)};
}

const Aim* TaskSpec::aim() const {
  return kind->aim != nullptr ? kind->aim(kind) : nullptr;
}

const ForceChannel* TaskSpec::effort() const {
  return kind->effort != nullptr ? kind->effort(kind) : nullptr;
}

double TaskSpec::largest_level() const {
  return kind->largest_level != nullptr ? kind->largest_level(kind) : 0.0;
}

std::vector<ForceChannel> TaskSpec::channels_needed(Scale scale) const {
  const Aim* const shown = aim();
  if (shown == nullptr || shown->scale != scale) return {};
  if (kind->channels != nullptr) return kind->channels(kind);
  return {shown->channel};
}

std::vector<ForceChannel> TaskSpec::channels_measured(Scale scale) const {
  if (kind->measured == nullptr) return {};
  return kind->measured(kind, scale);
}

const Waveform* TaskSpec::waveform() const {
  return kind->waveform != nullptr ? kind->waveform(kind) : nullptr;
}

std::vector<TargetPlace> TaskSpec::targets() const {
  if (kind->targets == nullptr) return {};
  return kind->targets(kind);
}

std::optional<HandsLoad> TaskSpec::hands_load() const {
  if (kind->hands_load == nullptr) return std::nullopt;
  return kind->hands_load(kind);
}

std::optional<HandsCarry> TaskSpec::hands_carry() const {
  if (kind->hands_carry == nullptr) return std::nullopt;
  return kind->hands_carry(kind);
}

std::optional<PoseTolerance> TaskSpec::tolerance() const {
  if (kind->tolerance == nullptr) return std::nullopt;
  return kind->tolerance(kind);
}

std::optional<AxisCourse> TaskSpec::course(double period_s) const {
  if (kind->course == nullptr) return std::nullopt;
  return kind->course(kind, period_s);
}

int TaskSpec::repetitions() const {
  return kind->repetitions != nullptr ? kind->repetitions(kind) : 1;
}

namespace {

KindSpec read_kind(TomlReader& reader) {
  std::vector<std::string_view> names;
  for (const KindFacts* kind : all_kinds()) names.push_back(kind->name);
  return all_kinds()[reader.choice("kind", names)]->read(reader);
}

/// Whether the kind has what this look draws is asked as well.
std::optional<Look> read_look(TomlReader& reader, const TaskSpec& spec) {
  if (!reader.has("look")) return std::nullopt;
  std::vector<std::string_view> names;
  for (const LookFacts& one : all_looks()) names.push_back(one.name);
  const Look look = all_looks()[reader.choice("look", names)].look;
  if (!fits(look, spec.kind->wardrobe))
    reader.fail("look", "'%1' does not fit this kind of task"_text(name_of(look)),
                "choose another look, or leave the line out"_text);
  return look;
}

void read_training_look(TomlReader& reader, TaskSpec& spec) {
  spec.training_look = read_look(reader, spec);
  if (spec.training_look && !spec.difficulty)
    reader.fail("look", "is for training only; an assessment always looks the same"_text,
                "leave the line out, or add a [difficulty] table to make it a training task"_text);
}

void read_difficulty(TomlReader& reader, TaskSpec& spec) {
  if (!reader.has("difficulty")) return;
  constexpr double kLeastFactor = 0.05;
  constexpr double kMostFactor = 20.0;
  TomlReader table = reader.table("difficulty");
  Difficulty difficulty;
  difficulty.factor = static_cast<Difficulty::Factor>(
      table.choice("factor", {"tolerance", "distance", "frequency", "level", "affected_share"}));
  difficulty.easiest = read_within(table, "easiest", kLeastFactor, kMostFactor);
  difficulty.hardest = read_within(table, "hardest", kLeastFactor, kMostFactor);
  difficulty.start = read_within(table, "start", 0.0, 1.0, difficulty.start);
  difficulty.measure = table.text("success_measure");
  difficulty.at_least = table.number("success_at_least");
  double by = 1.0;
  if (reader.has("chosen")) {
    TomlReader chosen = reader.table("chosen");
    difficulty.chosen = read_within(chosen, "level", 0.0, 1.0);
    by = std::lerp(difficulty.easiest, difficulty.hardest, *difficulty.chosen);
    spec.look = read_look(chosen, spec).value_or(Look::plain);
  }
  const auto multiply = spec.kind->multiply;
  if (multiply == nullptr || !multiply(spec.kind, difficulty.factor, by))
    table.fail("factor", "is nothing that this kind of task has"_text,
               "choose another factor"_text);
  const Aim* aim = spec.aim();
  if (aim != nullptr && aim->scale != Scale::newton && spec.largest_level() > 1.0)
    table.fail("hardest", "asks for more than the whole force"_text, "write a smaller factor"_text);
  spec.difficulty = std::move(difficulty);
}

const Questionnaire* read_questionnaire(TomlReader& reader) {
  std::vector<std::string_view> names;
  for (const Questionnaire& one : questionnaires()) names.push_back(one.name);
  return &questionnaires()[reader.choice("questionnaire", names, 0)];
}

}  // namespace

Result<TaskSpec> at_level(const TaskSpec& spec, double level, std::optional<Look> look) {
  std::string text = spec.text + "\n[chosen]\nlevel = " + format_number(level) + "\n";
  const Look shown = look.value_or(spec.training_look.value_or(usual_look(spec.kind->wardrobe)));
  if (shown != Look::plain) text.append("look = \"").append(name_of(shown)).append("\"\n");
  return parse_task(text, spec.file);
}

Result<TaskSpec> parse_task(std::string_view text, const std::string& file) {
  auto reader = TomlReader::parse(text, file, "isograsp-task-1");
  if (!reader) return reader.error();
  TaskSpec spec;
  spec.file = file;
  spec.text = std::string(text);
  spec.name = reader->text("name");
  spec.instruction = reader->text("instruction");
  constexpr int kMostVersion = 1'000'000;
  spec.version = read_count(*reader, "version", 1, kMostVersion);
  spec.kind = read_kind(*reader);
  read_difficulty(*reader, spec);
  read_training_look(*reader, spec);
  if (reader->has("questionnaire")) spec.questionnaire = read_questionnaire(*reader);
  constexpr double kLongestTask_s = 7200.0;  // a trial is kept in memory while it is scored
  if (spec.duration().worst_s > kLongestTask_s)
    reader->fail("", "takes longer than two hours"_text,
                 "make it shorter, or repeat it less often"_text);
  if (auto done = reader->finish(); !done) return done.error();
  return spec;
}

}  // namespace isograsp::tasks
