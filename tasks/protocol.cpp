// SPDX-License-Identifier: GPL-3.0-or-later
// Protocol files: TOML in, ProtocolSpec out.
#include "tasks/protocol.hpp"

#include "tasks/read_keys.hpp"

namespace isograsp::tasks {

namespace {

constexpr int kMostStepRepetitions = 100;

void read_tasks(TomlReader& table, ProtocolStep& step) {
  const bool several = table.has("tasks");
  if (several)
    step.tasks = table.texts("tasks");
  else
    step.tasks = {table.text("task")};
  const char* key = several ? "tasks" : "task";
  if (several && step.tasks.empty())
    table.fail(key, "is empty"_text, "name at least one task"_text);
  for (const std::string& name : step.tasks)
    if (table.has(key) && (name.empty() || name.find('/') != std::string::npos))
      table.fail(key, "'%1' is not the name of a task file"_text(name),
                 "write the file name without folder, e.g. \"grip_sine.toml\""_text);
  if (several)
    step.order = static_cast<Order>(table.choice("order", {"ordered", "interleaved", "random"}, 0));
}

void read_agreement(TomlReader& table, ProtocolStep& step) {
  if (!table.has("agree_measure")) return;
  Agreement agreement;
  agreement.measure = table.text("agree_measure");
  agreement.percent = read_within(table, "agree_percent", 0.1, 100.0, agreement.percent);
  agreement.most_repetitions =
      read_count(table, "most_repetitions", agreement.most_repetitions, kMostStepRepetitions);
  if (step.repetitions < 2)
    table.fail("repetitions", "is below 2"_text, "attempts can only agree with each other"_text);
  if (agreement.most_repetitions < step.repetitions)
    table.fail("most_repetitions", "is below repetitions"_text, "write a larger number"_text);
  step.agreement = std::move(agreement);
}

void read_bouts(TomlReader& table, ProtocolStep& step) {
  if (!table.has("work_s")) return;
  Bouts bouts;
  bouts.work_s = read_duration(table, "work_s", 0.0);
  bouts.bout_s = read_duration(table, "bout_s", bouts.work_s);
  bouts.rest_s = read_wait(table, "bout_rest_s", step.rest_s);
  if (step.agreement)
    table.fail("work_s", "stands beside agree_measure"_text, "leave out one of the two"_text);
  if (bouts.rest_s < step.rest_s)
    table.fail("bout_rest_s", "is below rest_s"_text, "write a larger number"_text);
  step.bouts = bouts;
}

void read_step_look(TomlReader& table, ProtocolStep& step) {
  if (!table.has("look")) return;
  std::vector<std::string_view> names;
  for (const LookFacts& one : all_looks()) names.push_back(one.name);
  step.look = all_looks()[table.choice("look", names)].look;
  if (!step.adaptive)
    table.fail("look", "is for training only; an assessment always looks the same"_text,
               "leave the line out, or write adaptive = true"_text);
}

ProtocolStep read_step(TomlReader& table) {
  ProtocolStep step;
  step.kind = static_cast<ProtocolStep::Kind>(
      table.choice("kind", {"instrument_zero", "task", "pause", "start_posture", "hand_entry"}));
  if (step.kind == ProtocolStep::Kind::pause) {
    step.duration_s = read_duration(table, "duration_s", 0.0);
    if (!table.has("duration_s")) table.fail("duration_s", "is missing"_text, "add it"_text);
    return step;
  }
  step.rest_s = read_wait(table, "rest_s", 0.0);
  if (step.prepares()) return step;
  read_tasks(table, step);
  step.repetitions = read_count(table, "repetitions", 1, kMostStepRepetitions);
  read_agreement(table, step);
  read_bouts(table, step);
  step.practice = table.boolean("practice", false);
  step.adaptive = table.boolean("adaptive", false);
  read_step_look(table, step);
  step.recurrence_s = read_wait(table, "recurrence_s", 0.0);
  return step;
}

}  // namespace

Result<ProtocolSpec> parse_protocol(std::string_view text, const std::string& file) {
  auto reader = TomlReader::parse(text, file, "isograsp-protocol-1");
  if (!reader) return reader.error();
  ProtocolSpec spec;
  spec.file = file;
  spec.text = std::string(text);
  spec.name = reader->text("name");
  for (TomlReader& table : reader->tables("step")) spec.steps.push_back(read_step(table));
  if (spec.steps.empty()) reader->fail("step", "is missing"_text, "add at least one [[step]]"_text);
  if (auto done = reader->finish(); !done) return done.error();
  return spec;
}

}  // namespace isograsp::tasks
