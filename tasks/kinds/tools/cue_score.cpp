// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/tools/cue_score.hpp"

#include <cmath>

#include "tasks/measures/known_delay.hpp"

namespace isograsp::tasks {

double known_or_zero(const Record& record, const Part& part, std::string_view column) {
  const double value = known_in(record, part, column);
  return std::isnan(value) ? 0.0 : value;
}

void add_delayed_times(const std::string& name, const std::string& channel, const Record& record,
                       const Section& section, const std::vector<statistics::EventTime>& times,
                       double limit_s, MeasureList& list) {
  const auto delay_s = record.known_delay_s();
  std::vector<statistics::EventTime> corrected = times;
  for (statistics::EventTime& time : corrected)
    if (time.time_s.value) time.time_s = without_delay(time.time_s, delay_s).corrected_s;
  list.add_times(name, channel, section, times, limit_s);
  list.add(name + "_corrected", channel, "s", section,
           delay_s ? median_time(corrected, limit_s)
                   : statistics::Computed("the delay of the device is not known"_text));
}

void add_reactions(const std::string& name, const std::string& channel, const Record& record,
                   const Section& section, const std::vector<Reaction>& reactions, double limit_s,
                   MeasureList& list) {
  std::vector<statistics::EventTime> times;
  int anticipations = 0;
  for (const Reaction& reaction : reactions) {
    if (reaction.anticipated_s)
      ++anticipations;
    else
      times.push_back(reaction.time);
  }
  add_delayed_times(name, channel, record, section, times, limit_s, list);
  list.add("anticipations", channel, "", section,
           reactions.empty() ? statistics::Computed("there was no cue"_text)
                             : statistics::Computed(static_cast<double>(anticipations)));
}

}  // namespace isograsp::tasks
