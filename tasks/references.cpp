// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/references.hpp"

#include "core/csv.hpp"

namespace isograsp::tasks {

namespace {

constexpr std::array<std::string_view, 3> kEfforts{"none", "comfortable", "maximum"};

Result<double> measured(const std::map<ForceChannel, double>& values, ForceChannel channel,
                        Words what, Words remedy) {
  const auto found = values.find(channel);
  if (found != values.end() && found->second > 0.0) return found->second;
  return refused(
             "the target is a share of the %1 of '%2', and no trial of this session measured one"_text(
                 what, name_of(channel)),
             remedy)
      .about("scale");
}

}  // namespace

std::string_view name_of(Effort effort) noexcept {
  return kEfforts[static_cast<std::size_t>(effort)];
}

std::optional<Effort> effort_from_name(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kEfforts.size(); ++i)
    if (kEfforts[i] == name) return static_cast<Effort>(i);
  return std::nullopt;
}

std::optional<double> ForceReferences::resting(ForceChannel channel) const noexcept {
  if (!resting_C) return std::nullopt;
  return force_of(*resting_C, channel);
}

std::optional<double> ForceReferences::noise(ForceChannel channel) const noexcept {
  if (!noise_sd_N) return std::nullopt;
  const double sd_N = noise_of(*noise_sd_N, channel);
  return sd_N > 0.0 ? std::optional(sd_N) : std::nullopt;  // a device without any tells nothing
}

std::optional<double> ForceReferences::maximum(ForceChannel channel) const noexcept {
  const auto found = maximum_N.find(channel);
  if (found == maximum_N.end()) return std::nullopt;
  return found->second;
}

Result<double> ForceReferences::unit_N(Scale scale, ForceChannel channel, double largest) const {
  switch (scale) {
    case Scale::newton: return 1.0;
    case Scale::of_maximum:
      return measured(maximum_N, channel, "maximum force"_text,
                      "run the resting-force task and a maximum task of it first"_text);
    case Scale::of_comfortable:
      return measured(comfortable_N, channel, "comfortable force"_text,
                      "run the comfortable-force task of it first"_text);
    case Scale::of_baseline: break;
  }
  const auto load = measured(baseline_N, channel, "baseline maximum"_text,
                             "the fixed load begins with the second assessment"_text);
  if (!load) return load;
  constexpr double kMostOfToday = 0.5;
  const auto today_N = maximum(channel);
  if (!today_N || !(largest * *load <= kMostOfToday * *today_N))
    return refused(
               "the fixed load of %1 N is above half of today's maximum, or that was not measured"_text(
                   shortest(largest * *load)),
               "measure today's maximum, or use the task relative to it"_text)
        .about("scale");
  return load;
}

}  // namespace isograsp::tasks
