// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp score: the measures of one recorded trial.
#include "tasks/score.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "core/csv.hpp"
#include "hand/finger.hpp"
#include "session/library/library.hpp"
#include "tasks/reasons/reasons.hpp"

namespace isograsp::app {

namespace {

struct ScoreOptions {
  std::string task;
  std::string signals;
  std::optional<Hand> affected;
  std::optional<double> maximum_left_N;
  std::optional<double> maximum_right_N;
  bool json = false;
};

nlohmann::ordered_json as_json(const std::vector<Measure>& measures) {
  auto list = nlohmann::ordered_json::array();
  for (const Measure& measure : measures) {
    nlohmann::ordered_json one;
    one["name"] = measure.name;
    one["channel"] = measure.channel;
    if (measure.value)
      one["value"] = *measure.value;
    else
      one["value"] = nullptr;
    one["unit"] = measure.unit;
    one["version"] = measure.version;
    one["samples"] = measure.samples;
    one["excluded"] = measure.excluded;
    if (!measure.value) one["reason"] = measure.reason;
    list.push_back(std::move(one));
  }
  return {{"measures", std::move(list)}};
}

Lines as_table(const std::vector<Measure>& measures) {
  const auto number = [](double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::string(text);
  };
  std::vector<std::array<std::string, 6>> rows{
      {"measure", "channel", "value", "unit", "samples", "excluded"}};
  for (const Measure& measure : measures)
    rows.push_back({measure.name, printable(measure.channel),
                    measure.value ? number(*measure.value) : "-",
                    measure.value ? measure.unit : spoken(tasks::reason_words(measure.reason)),
                    std::to_string(measure.samples), std::to_string(measure.excluded)});
  std::array<std::size_t, 6> width{};
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  Lines text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(width[c] - row[c].size(), ' ');
      const bool numeric = c == 2 || c >= 4;
      line += (c == 0 ? "" : "  ") + (numeric ? blanks + row[c] : row[c] + blanks);
    }
    text.add_row(line);
  }
  return text;
}

Result<void> run_score(const ScoreOptions& options) {
  std::vector<Measure> measures;
  if (options.affected) {
    const auto signals = read_signals(options.signals);
    if (!signals) return signals.error();
    measures = tasks::score_two_hands(
        *signals, {*options.affected, {options.maximum_left_N, options.maximum_right_N}});
    if (measures.empty())
      return refused("has no columns left_force_N and right_force_N"_text,
                     "give a record of two hands, or leave out --affected"_text)
          .at(options.signals);
  } else if (options.task.empty()) {
    const auto signals = read_signals(options.signals);
    if (!signals) return signals.error();
    measures = tasks::score_pairs(*signals);
    if (measures.empty())
      return refused("has no column target_X with its actual_X"_text,
                     "name the pairs so, with units, or say which --task it was"_text)
          .at(options.signals);
  } else {
    const auto task = session::load_task(options.task);
    if (!task) return task.error();
    const auto signals = read_signals(options.signals);
    if (!signals) return signals.error();
    measures = tasks::score(*task, *signals);
  }
  if (options.json)
    print_json(as_json(measures));
  else
    print_lines(as_table(measures));
  return {};
}

}  // namespace

void add_score(CommandLine& line) {
  auto options = std::make_shared<ScoreOptions>();
  Subcommand command = line.subcommand("score", "Measures of one recorded trial");
  Option task = command.option("--task", options->task,
                               "Task file; without it every target_X is paired with its actual_X");
  command.option("--signals", options->signals, "Signals of the trial (CSV)").required();
  Option affected =
      command.option("--affected", options->affected, "Record of two hands: the affected one");
  affected.excludes(task);
  command.option("--maximum-left", options->maximum_left_N, "Maximum of the left hand [N]")
      .positive()
      .needs(affected);
  command.option("--maximum-right", options->maximum_right_N, "Maximum of the right hand [N]")
      .positive()
      .needs(affected);
  command.flag("--json", options->json, "Print one JSON document");
  command.footer(
      "Example:\n  isograsp score --task library/tasks/grip_sine.toml --signals trial.csv");
  command.runs([options] { return run_score(*options); });
}

}  // namespace isograsp::app
