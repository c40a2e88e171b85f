// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a study as JSON, its values as CSV. SI units, as stored.
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "reports/study/study_report.hpp"

namespace isograsp::reports {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kTooLarge = "too large for a number of the computer";

/// A number, or {"undefined": why}. JSON knows no infinity.
Json as_json(const statistics::Computed& figure) {
  if (!figure.value) return {{"undefined", english(figure.reason)}};
  if (!std::isfinite(*figure.value)) return {{"undefined", kTooLarge}};
  return *figure.value;
}

/// `number`, unless nothing was computed: then what is undefined in `because`.
Json as_json(double number, const statistics::Computed& because, bool computed) {
  return as_json(computed ? statistics::Computed(number) : because);
}

Json as_json(const statistics::WithinEffect& effect) {
  const auto& s = effect.sphericity;
  const auto sum = [&](double number) { return as_json(number, effect.f, effect.df > 0.0); };
  return {{"sum_of_squares", sum(effect.sum_of_squares)},
          {"error_sum_of_squares", sum(effect.error_sum_of_squares)},
          {"df", sum(effect.df)},
          {"error_df", sum(effect.error_df)},
          {"f", as_json(effect.f)},
          {"p", as_json(effect.p)},
          {"epsilon_greenhouse_geisser", as_json(s.epsilon)},
          {"epsilon_huynh_feldt", as_json(s.epsilon_huynh_feldt)},
          {"corrected_df", as_json(effect.corrected_df)},
          {"corrected_error_df", as_json(effect.corrected_error_df)},
          {"corrected_p", as_json(effect.corrected_p)},
          {"mauchly_w", as_json(s.mauchly_w)},
          {"mauchly_chi2", as_json(s.mauchly_chi2)},
          {"mauchly_df", as_json(s.mauchly_df)},
          {"mauchly_p", as_json(s.mauchly_p)},
          {"partial_eta2", as_json(effect.partial_eta2)},
          {"generalised_eta2", as_json(effect.generalised_eta2)}};
}

Json as_json(const std::vector<statistics::PairedT>& pairs) {
  Json all = Json::array();
  for (const auto& pair : pairs)
    all.push_back({{"first", pair.first},
                   {"second", pair.second},
                   {"mean_difference", as_json(pair.mean_difference)},
                   {"sd", as_json(pair.sd)},
                   {"low", as_json(pair.low)},
                   {"high", as_json(pair.high)},
                   {"t", as_json(pair.t)},
                   {"df", pair.df},
                   {"p", as_json(pair.p)},
                   {"p_bonferroni", as_json(pair.p_bonferroni)},
                   {"d_z", as_json(pair.d_z)}});
  return all;
}

Json as_json(const std::vector<statistics::SignedRank>& tests) {
  Json all = Json::array();
  for (const auto& test : tests)
    all.push_back({{"first", test.first},
                   {"second", test.second},
                   {"pairs", test.pairs},
                   {"zeros", test.zeros},
                   {"ties", test.ties},
                   {"exact", test.exact},
                   {"w_plus", as_json(test.w_plus)},
                   {"w_minus", as_json(test.w_minus)},
                   {"z", as_json(test.z)},
                   {"p", as_json(test.p)},
                   {"p_bonferroni", as_json(test.p_bonferroni)},
                   {"r", as_json(test.r)},
                   {"rank_biserial", as_json(test.rank_biserial)},
                   {"pseudo_median", as_json(test.pseudo_median)},
                   {"low", as_json(test.low)},
                   {"high", as_json(test.high)}});
  return all;
}

Json as_json(const ConditionSummary& summary, const std::string& name) {
  Json one{{"name", name}, {"mean", as_json(summary.mean)}, {"sd", as_json(summary.sd)}};
  if (summary.box) {
    one["lower_quartile"] = summary.box->lower_quartile;
    one["median"] = summary.box->median;
    one["upper_quartile"] = summary.box->upper_quartile;
    one["lower_whisker"] = summary.box->lower_whisker;
    one["upper_whisker"] = summary.box->upper_whisker;
    one["outside"] = summary.box->outside;
  }
  return one;
}

Json left_out(const StudyGroupData& group, const GroupAnalysis& analysis,
              const std::vector<StudyCondition>& conditions) {
  Json all = Json::array();
  for (const auto row : analysis.complete.incomplete)
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      const auto& cell = group.cells[static_cast<std::size_t>(row)][c];
      if (!cell.value)
        all.push_back({{"subject", group.subjects[static_cast<std::size_t>(row)]},
                       {"condition", conditions[c].name},
                       {"why", english(cell.reason)}});
    }
  return all;
}

Json as_json(const StudyGroupData& group, const GroupAnalysis& analysis,
             const std::vector<StudyCondition>& conditions) {
  Json json{{"name", group.name},
            {"listed", group.subjects.size()},
            {"n", analysis.complete.kept.size()},
            {"left_out", left_out(group, analysis, conditions)}};
  json["conditions"] = Json::array();
  for (std::size_t c = 0; c < conditions.size(); ++c)
    json["conditions"].push_back(as_json(analysis.conditions[c], conditions[c].name));
  if (analysis.one_way)
    json["anova"] = {{"effect", as_json(analysis.one_way->effect)},
                     {"pairs", as_json(analysis.pairs)}};
  if (analysis.two_way) {
    const auto& two = *analysis.two_way;
    json["anova"] = {{"first", as_json(two.a)},
                     {"second", as_json(two.b)},
                     {"interaction", as_json(two.interaction)}};
    json["anova"]["first_at_each_second"] = Json::array();
    for (const auto& one : analysis.simple_effects)
      json["anova"]["first_at_each_second"].push_back(
          {{"at", one.at}, {"effect", as_json(one.anova.effect)}, {"pairs", as_json(one.pairs)}});
  }
  if (analysis.friedman)
    json["friedman"] = {{"chi2", as_json(analysis.friedman->chi2)},
                        {"df", analysis.friedman->df},
                        {"p", as_json(analysis.friedman->p)},
                        {"kendall_w", as_json(analysis.friedman->kendall_w)},
                        {"mean_ranks", analysis.friedman->mean_ranks}};
  if (!analysis.signed_ranks.empty()) json["wilcoxon"] = as_json(analysis.signed_ranks);
  if (analysis.reliability) {
    const auto& r = *analysis.reliability;
    const auto square = [&r](double number) {
      return as_json(number, r.icc, r.icc.value.has_value());
    };
    json["reliability"] = {{"subjects_mean_square", square(r.subjects_mean_square)},
                           {"repeats_mean_square", square(r.repeats_mean_square)},
                           {"error_mean_square", square(r.error_mean_square)},
                           {"icc_2_1", as_json(r.icc)},
                           {"low", as_json(r.low)},
                           {"high", as_json(r.high)},
                           {"sem", as_json(r.sem)},
                           {"mdc95", as_json(r.mdc95)}};
  }
  return json;
}

}  // namespace

std::string study_json(const Study& study, const StudyData& data,
                       const std::vector<GroupAnalysis>& analyses) {
  const auto conditions = conditions_of(study);
  Json left_out = Json::array();
  for (const Text& words : data.left_out) left_out.push_back(english(words));
  Json json{{"format", "isograsp-study-result-1"},
            {"software_version", ISOGRASP_VERSION},
            {"title", study.title},
            {"measure", study.measure},
            {"unit", data.unit},
            {"measure_version", data.measure_version},
            {"source", name_of(study.source)},
            {"confidence", study.confidence},
            {"trials_left_out", left_out},
            {"renewed", english(data.renewed)}};
  json["groups"] = Json::array();
  for (std::size_t g = 0; g < data.groups.size(); ++g)
    json["groups"].push_back(as_json(data.groups[g], analyses[g], conditions));
  // ASCII: names may contain control characters of a terminal.
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string study_csv(const Study& study, const StudyData& data) {
  const auto conditions = conditions_of(study);
  std::string text = "group,subject,condition";
  for (const auto& factor : study.factors) text += "," + csv_field(factor.name);
  text += ",value,unit,sessions,trials,reason,source\n";
  for (const auto& group : data.groups)
    for (std::size_t s = 0; s < group.subjects.size(); ++s)
      for (std::size_t c = 0; c < conditions.size(); ++c) {
        const auto& cell = group.cells[s][c];
        text += csv_field(group.name) + "," + csv_field(group.subjects[s]) + "," +
                csv_field(conditions[c].name);
        const auto last = study.factors.back().levels.size();
        if (study.factors.size() > 1)
          text += "," + csv_field(study.factors[0].levels[c / last].name);
        text += "," + csv_field(study.factors.back().levels[c % last].name) + ",";
        if (cell.value) append_number(text, *cell.value);
        text += "," + csv_field(data.unit) + "," + std::to_string(cell.sessions) + "," +
                std::to_string(cell.trials) + "," + csv_field(english(cell.reason)) + "," +
                std::string(name_of(study.source)) + "\n";
      }
  return text;
}

}  // namespace isograsp::reports
