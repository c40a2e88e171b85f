// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/import/recorded_trials.hpp"

#include <algorithm>
#include <cmath>

#include "core/csv.hpp"
#include "hand/columns.hpp"

namespace isograsp::session {

namespace {

/// {key} -> its value, where there is one.
std::string filled(std::string text, const KeyValues& values) {
  for (const auto& [key, value] : values)
    for (std::size_t at = 0; (at = text.find("{" + key + "}", at)) != std::string::npos;
         at += value.size())
      text.replace(at, key.size() + 2, value);
  return text;
}

}  // namespace

auto RecordedTrials::new_trial(const KeyValues& values, const RecordedPlace& at) const
    -> Result<Found> {
  Found found;
  found.order.appearance = found_.size();
  if (!spec_.patient_key.empty()) {
    constexpr double kMostPatients = 9999.0;
    const std::string& text = values.at(spec_.patient_key);
    double number = 0.0;
    if (!parse_number(text, number) || number != std::floor(number) || number < 1.0 ||
        number > kMostPatients)
      return refused("'%1' is not the number of a person"_text(text),
                     "number them from 1 on: names and dates are not stored"_text)
          .at(at.path, at.line, spec_.patient_key);
    found.order.patient = static_cast<int>(number);
  }
  if (!spec_.session_key.empty()) {
    const std::string& name = values.at(spec_.session_key);
    const auto known = std::find(spec_.sessions.begin(), spec_.sessions.end(), name);
    if (known == spec_.sessions.end())
      return refused("'%1' is none of the sessions"_text(name),
                     "add it to `sessions` of the recording file"_text)
          .at(at.path, at.line, spec_.session_key);
    found.order.session = static_cast<std::size_t>(known - spec_.sessions.begin());
    found.trial.session_name = name;
  }
  auto task = tasks::parse_task(filled(spec_.task, values), spec_.path + ", task");
  if (!task) return task.error();
  const std::string number = std::to_string(found.order.patient);
  found.trial.patient_code = spec_.patient_prefix + "-" + (number.size() < 2 ? "0" : "") + number;
  found.trial.session = found.order.session;
  found.trial.file = std::filesystem::path(at.path).filename();
  found.trial.task = *std::move(task);
  return found;
}

Result<RecordedTrial*> RecordedTrials::trial_of(const KeyValues& values, const RecordedPlace& at) {
  if (last_ < found_.size() && values == last_values_) return &found_[last_].trial;
  const auto known = index_.find(values);
  if (known == index_.end()) {
    auto made = new_trial(values, at);
    if (!made) return made.error();
    index_[values] = found_.size();
    found_.push_back(*std::move(made));
  }
  last_values_ = values;
  last_ = index_[values];
  return &found_[last_].trial;
}

Result<std::vector<RecordedTrial>> RecordedTrials::take() {
  std::sort(found_.begin(), found_.end(),
            [](const Found& a, const Found& b) { return a.order < b.order; });
  std::vector<RecordedTrial> trials;
  for (Found& found : found_) {
    if (found.trial.signals.rows() < 2)
      return refused("a trial has fewer than two rows"_text,
                     "complete the file, or correct the keys of the recording file"_text)
          .at(found.trial.file)
          .about(found.trial.task.name);
    trials.push_back(std::move(found.trial));
  }
  return trials;
}

}  // namespace isograsp::session
