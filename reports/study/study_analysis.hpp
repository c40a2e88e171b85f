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

namespace isograsp {

/// One condition, over the people with all values.
struct ConditionSummary {
  Computed mean = kNotComputed;
  Computed sd = kNotComputed;  ///< n - 1
  std::optional<BoxPlot> box;
};

/// The first factor at one level of the second.
struct SimpleEffect {
  std::string at;  ///< the level
  OneWayAnova anova;
  std::vector<PairedT> pairs;  ///< of the first factor's levels
};

struct GroupAnalysis {
  CompleteSubjects complete;
  std::vector<ConditionSummary> conditions;
  std::optional<OneWayAnova> one_way;
  std::optional<TwoWayAnova> two_way;
  std::vector<SimpleEffect> simple_effects;  ///< of a two-way analysis
  std::vector<PairedT> pairs;                ///< of a one-way analysis
  std::optional<Friedman> friedman;          ///< of three conditions or more
  std::vector<SignedRank> signed_ranks;
  std::optional<Reliability> reliability;
};
[[nodiscard]] GroupAnalysis analyse(const Study& study, const StudyGroupData& group);

}  // namespace isograsp
