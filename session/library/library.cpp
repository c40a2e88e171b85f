// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/library/library.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "core/csv.hpp"
#include "session/library/arm_rules.hpp"
#include "session/library/hand_rules.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::session {

namespace {

namespace fs = std::filesystem;

/// The table that carries the points of a CSV target inside the task's text.
Result<std::string> csv_table(const std::string& path) {
  const auto signals = read_signals(path);
  if (!signals) return signals.error();
  std::string text = "\n[csv_data]\n";
  for (const char* column : {"t_s", "target"}) {
    if (!signals->has(column))
      return refused("is missing"_text, "name the columns t_s and target"_text).at(path, 1, column);
    text += std::string(column) + " = [";
    const char* separator = "";
    for (const double value : signals->column(column)) {
      text += separator + format_number(value);
      separator = ", ";
    }
    text += "]\n";
  }
  return text;
}

class ProtocolReader {
 public:
  ProtocolReader(ReadyProtocol& ready, const std::string& library)
      : ready_(ready), library_(library) {}

  Result<void> read() {
    for (std::size_t i = 0; i < ready_.spec.steps.size(); ++i) {
      ready_.tasks.emplace_back();
      const tasks::ProtocolStep& step = ready_.spec.steps[i];
      if (step.kind != tasks::ProtocolStep::Kind::task) continue;
      for (const std::string& name : step.tasks) {
        auto task = find_and_load(name);
        if (!task) return task.error();
        if (auto good = check(*task, step); !good) return good;
        ready_.tasks.back().push_back(*std::move(task));
      }
    }
    return {};
  }

 private:
  Result<tasks::TaskSpec> find_and_load(const std::string& name) const {
    const auto path = find_in_library(library_, "tasks", name, ready_.spec.file);
    if (!path) return path.error();
    auto spec = load_task(*path);
    if (!spec || spec->scene().empty()) return spec;
    if (const auto scene = find_in_library(library_, "scenes", spec->scene(), *path); !scene)
      return scene.error();
    return spec;
  }

  [[nodiscard]] std::string task_key() const {
    return "step[" + std::to_string(ready_.tasks.size()) + "].task";
  }

  /// What a task needs must have been measured by an earlier step.
  Result<void> check(const tasks::TaskSpec& task, const tasks::ProtocolStep& step) {
    if (step.adaptive && !task.difficulty)
      return refused("'%1' has no difficulty to adapt"_text(task.name),
                     "add a [difficulty] table to the task, or leave out adaptive"_text)
          .at(ready_.spec.file)
          .about(task_key());
    if (step.look && !tasks::fits(*step.look, task.kind->wardrobe))
      return refused("the look '%1' does not fit '%2'"_text(name_of(*step.look), task.name),
                     "choose another look, or leave the line out"_text)
          .at(ready_.spec.file)
          .about("step[" + std::to_string(ready_.tasks.size()) + "].look");
    if (task.kind->measured != nullptr && !rested_)
      return refused(
                 "a maximum is measured above the resting force, which no earlier step measures"_text,
                 "put a resting-force task before it"_text)
          .at(ready_.spec.file)
          .about(task_key());
    for (const auto& [scale, measured, what] :
         {std::tuple{tasks::Scale::of_maximum, &maxima_, "maximum"_text},
          std::tuple{tasks::Scale::of_comfortable, &comfortable_, "comfortable force"_text}})
      for (const ForceChannel channel : task.channels_needed(scale))
        if (std::find(measured->begin(), measured->end(), channel) == measured->end())
          return refused(
                     "the target is a share of the %1 of '%2' that no earlier step measures"_text(
                         what, name_of(channel)),
                     "put a task that measures it before"_text)
              .at(ready_.spec.file)
              .about(task_key());
    rested_ = rested_ || task.kind->rests;
    for (const ForceChannel channel : task.channels_measured(tasks::Scale::of_maximum))
      maxima_.push_back(channel);
    for (const ForceChannel channel : task.channels_measured(tasks::Scale::of_comfortable))
      comfortable_.push_back(channel);
    return {};
  }

  ReadyProtocol& ready_;
  const std::string& library_;
  bool rested_ = false;
  std::vector<ForceChannel> maxima_;
  std::vector<ForceChannel> comfortable_;
};

}  // namespace

std::string own_library_folder(const std::string& database) {
  return fs::path(database).replace_extension(".library").string();
}

Result<std::string> find_in_library(const std::string& library, const std::string& folder,
                                    const std::string& name, const std::string& beside) {
  const std::string file = name.ends_with(".toml") ? name : name + ".toml";
  std::error_code ignored;
  std::vector<fs::path> places;
  if (!beside.empty()) {
    const fs::path around = fs::path(beside).parent_path();
    places.push_back(around / file);
    places.push_back(around / ".." / folder / file);
  }
  places.push_back(fs::path(library) / folder / file);
  for (const auto& path : places)
    if (fs::is_regular_file(path, ignored)) return path.lexically_normal().string();
  return refused("there is no file of this name"_text,
                 "put it into %1"_text((fs::path(library) / folder).string()))
      .at(file);
}

Result<tasks::TaskSpec> load_task(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return read_task(*text, path);
}

Result<tasks::TaskSpec> read_task(std::string_view text, const std::string& path) {
  auto spec = tasks::parse_task(text, path);
  if (!spec) return spec;
  const tasks::Waveform* wave = spec->waveform();
  if (wave == nullptr || wave->csv.empty() || !wave->t_s.empty()) return spec;
  const auto table = csv_table((fs::path(path).parent_path() / wave->csv).string());
  if (!table) return table.error();
  return tasks::parse_task(std::string(text) + *table, path);
}

Result<ReadyProtocol> read_protocol(const std::string& path, const std::string& library) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return read_protocol(*text, path, library);
}

Result<ReadyProtocol> read_protocol(std::string_view text, const std::string& path,
                                    const std::string& library) {
  auto spec = tasks::parse_protocol(text, path);
  if (!spec) return spec.error();
  ReadyProtocol ready{std::move(*spec), {}};
  if (auto read = ProtocolReader(ready, library).read(); !read) return read.error();
  if (auto good = check_arm_rules(ready.spec, ready.tasks); !good) return good.error();
  if (auto good = check_hand_rules(ready.spec, ready.tasks); !good) return good.error();
  return ready;
}

std::string_view ReadyProtocol::apparatus() const {
  for (const auto& of_step : tasks)
    for (const auto& task : of_step)
      if (const auto needed = task.apparatus(); !needed.empty()) return needed;
  return "";
}

}  // namespace isograsp::session
