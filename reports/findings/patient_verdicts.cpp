// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/patient_verdicts.hpp"

#include <algorithm>

#include "reports/findings/patient_records.hpp"
#include "reports/findings/task_section.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

Result<std::vector<PatientVerdict>> gather_verdicts(storage::SessionStore& store,
                                                    const std::string& code) {
  auto records = read_patient(store, code);
  if (!records) return records.error();
  const auto tasks = sort_by_task(*records);
  Renewal renewal(store);
  const VerdictContext context{store, records->primaries, records->profile, renewal};
  std::vector<PatientVerdict> all;
  for (const auto& primary : context.primaries) {
    PatientVerdict one{primary, "", Source::device, 1, {}, {}};
    if (const auto task = tasks.find({primary.hand, primary.task_name}); task != tasks.end()) {
      auto section = make_section(context, task->second, records->shown);
      if (!section) return section.error();
      one.source = section->source;
      one.task_version = section->version;
      for (auto& series : section->series)
        if (series.name == primary.measure && series.channel == primary.channel) {
          one.unit = series.unit;
          for (const auto& value : series.values)
            if (value.mean) one.values.push_back(*value.mean);
          one.verdict = std::move(series.verdict);
        }
    }
    all.push_back(std::move(one));
  }
  return all;
}

Result<std::vector<storage::PrimaryMeasure>> primary_choices(storage::SessionStore& store,
                                                             const std::string& code) {
  const auto records = read_patient(store, code);
  if (!records) return records.error();
  struct Choice {
    tasks::Place place;
    std::size_t kind;  ///< in the order of an assessment
    storage::PrimaryMeasure measure;
  };
  std::vector<Choice> choices;
  for (const auto& [task, trials] : sort_by_task(*records)) {
    const storage::TrialRecord& newest = trials.back()->trial;
    std::optional<tasks::TaskSpec> spec;
    if (auto parsed = tasks::parse_task(newest.task_text, newest.task_name))
      spec = *std::move(parsed);
    if (spec && spec->difficulty) continue;  // its level follows success
    for (const auto& measure : trials.back()->measures) {
      const auto place = tasks::place_of(spec, measure.name, measure.channel);
      if (place.prominence == tasks::Prominence::none ||
          tasks::words_of(measure.name, measure.channel).better == tasks::Better::unknown)
        continue;
      choices.push_back({place,
                         spec ? tasks::order_of(*spec->kind) : tasks::all_kinds().size(),
                         {0, task.second, task.first, measure.name, measure.channel, "", ""}});
    }
  }
  std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
    if (a.place.prominence != b.place.prominence) return a.place.prominence > b.place.prominence;
    return a.kind < b.kind;
  });
  std::vector<storage::PrimaryMeasure> measures;
  for (auto& choice : choices) measures.push_back(std::move(choice.measure));
  return measures;
}

}  // namespace isograsp::reports
