// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/study_analysis.hpp"

#include <algorithm>
#include <cmath>

#include "core/mean.hpp"

namespace isograsp::reports {

namespace {

using Eigen::Index;

/// In units of the largest value, whose square is a number whatever its size. @pre two values
statistics::Computed sd_about(double mean, const Eigen::VectorXd& values) {
  const double unit = values.cwiseAbs().maxCoeff();
  if (unit == 0.0) return 0.0;
  const Eigen::ArrayXd about = values.array() / unit - mean / unit;
  const double sd = unit * std::sqrt(about.square().sum() / static_cast<double>(values.size() - 1));
  if (!std::isfinite(sd))
    return "the standard deviation is too large for a number of the computer"_text;
  return sd;
}

ConditionSummary summary_of(const Eigen::VectorXd& values) {
  ConditionSummary summary;
  summary.box = statistics::box_plot({values.data(), static_cast<std::size_t>(values.size())});
  if (values.size() == 0) {
    summary.mean = summary.sd = "nobody has all values"_text;
    return summary;
  }
  const double mean = arithmetic_mean({values.data(), static_cast<std::size_t>(values.size())});
  summary.mean = mean;
  summary.sd = "one subject only"_text;
  if (values.size() > 1) summary.sd = sd_about(mean, values);
  return summary;
}

void add_anova(const Study& study, GroupAnalysis& result) {
  const statistics::SubjectTable& values = result.complete.values;
  if (study.factors.size() == 1) {
    result.one_way = statistics::one_way_anova(values);
    result.pairs = statistics::bonferroni_pairs(values, study.confidence);
    return;
  }
  const auto levels_a = static_cast<Index>(study.factors[0].levels.size());
  const auto levels_b = static_cast<Index>(study.factors[1].levels.size());
  result.two_way = statistics::two_way_anova(values, levels_a, levels_b);
  for (Index b = 0; b < levels_b; ++b) {
    statistics::SubjectTable at(values.rows(), levels_a);
    for (Index a = 0; a < levels_a; ++a) at.col(a) = values.col(a * levels_b + b);
    result.simple_effects.push_back({study.factors[1].levels[static_cast<std::size_t>(b)].name,
                                     statistics::one_way_anova(at),
                                     statistics::bonferroni_pairs(at, study.confidence)});
  }
}

}  // namespace

GroupAnalysis analyse(const Study& study, const StudyGroupData& group) {
  GroupAnalysis result;
  result.complete = statistics::complete_subjects(group.table());
  const statistics::SubjectTable& values = result.complete.values;
  for (Index column = 0; column < values.cols(); ++column)
    result.conditions.push_back(summary_of(values.col(column)));
  for (const auto analysis : study.analyses) switch (analysis) {
      case StudyAnalysis::anova: add_anova(study, result); break;
      case StudyAnalysis::ranks:
        if (values.cols() > 2) result.friedman = statistics::friedman(values);
        result.signed_ranks = statistics::signed_rank_pairs(values, study.confidence);
        break;
      case StudyAnalysis::reliability:
        result.reliability = statistics::reliability(values, study.confidence);
        break;
    }
  return result;
}

}  // namespace isograsp::reports
