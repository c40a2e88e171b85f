// SPDX-License-Identifier: GPL-3.0-or-later
// Protocol files: TOML in, ProtocolSpec out.
#include "core/toml_reader.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp {

namespace {

ProtocolStep read_step(TomlReader& table) {
  constexpr std::int64_t kMostRepetitions = 100;
  constexpr double kLongestRest_s = 3600.0;
  ProtocolStep step;
  step.kind = static_cast<ProtocolStep::Kind>(table.choice("kind", {"instrument_zero", "task"}));
  step.rest_s = table.number("rest_s", 0.0);
  if (step.rest_s < 0.0 || step.rest_s > kLongestRest_s)
    table.fail("rest_s", "is out of range", "write a number from 0 to 3600");
  if (step.kind == ProtocolStep::Kind::instrument_zero) return step;
  step.task = table.text("task");
  if (table.has("task") && (step.task.empty() || step.task.find('/') != std::string::npos))
    table.fail("task", "'" + step.task + "' is not the name of a task file",
               "write the file name without folder, e.g. \"grip_sine.toml\"");
  const auto repetitions = table.integer("repetitions", 1);
  if (repetitions < 1 || repetitions > kMostRepetitions)
    table.fail("repetitions", std::to_string(repetitions) + " is out of range",
               "write a whole number from 1 to 100");
  else
    step.repetitions = static_cast<int>(repetitions);
  step.practice = table.boolean("practice", false);
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
  if (spec.steps.empty()) reader->fail("step", "is missing", "add at least one [[step]]");
  if (auto done = reader->finish(); !done) return done.error();
  return spec;
}

}  // namespace isograsp
