// SPDX-License-Identifier: GPL-3.0-or-later
// The analyses of one group of a study, as its file asks for them. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/study/study_data.hpp"
#include "statistics/anova.hpp"
#include "statistics/box_plot.hpp"
#include "statistics/rank_tests.hpp"
#include "statistics/reliability.hpp"

namespace isograsp::reports {

/// One condition, over the people with all values.
struct ConditionSummary {
  statistics::Computed mean = statistics::kNotComputed;
  statistics::Computed sd = statistics::kNotComputed;  ///< n - 1
  std::optional<statistics::BoxPlot> box;
};

/// The first factor at one level of the second.
struct SimpleEffect {
  std::string at;  ///< the level
  statistics::OneWayAnova anova;
  std::vector<statistics::PairedT> pairs;  ///< of the first factor's levels
};

struct GroupAnalysis {
  statistics::CompleteSubjects complete;
  std::vector<ConditionSummary> conditions;
  std::optional<statistics::OneWayAnova> one_way;
  std::optional<statistics::TwoWayAnova> two_way;
  std::vector<SimpleEffect> simple_effects;      ///< of a two-way analysis
  std::vector<statistics::PairedT> pairs;        ///< of a one-way analysis
  std::optional<statistics::Friedman> friedman;  ///< of three conditions or more
  std::vector<statistics::SignedRank> signed_ranks;
  std::optional<statistics::Reliability> reliability;
};
[[nodiscard]] GroupAnalysis analyse(const Study& study, const StudyGroupData& group);

}  // namespace isograsp::reports
