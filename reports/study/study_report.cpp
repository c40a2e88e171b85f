// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences and tables of a group report. A p value never stands alone, and nothing is called
// significant, better or proven.
#include "reports/study/study_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr const char* kNoValue = "\u2013";
constexpr const char* kNoBreak = "\u00a0";

std::string fixed(double value, int decimals) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value));
  std::string result = text.data();
  const bool is_zero = result.find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !is_zero ? "\u2212" : "") + result;
}

std::string p_words(double p) {
  constexpr double kLeast = 0.001;
  if (p < kLeast) return "< 0.001";
  if (p > 1.0 - kLeast && p < 1.0) return "> 0.999";
  return fixed(p, 3);
}

std::string df_words(double df) {
  return fixed(df, df == std::floor(df) ? 0 : 2);
}

std::string percent_words(double share) {
  return df_words(100.0 * share) + kNoBreak + "%";
}

const char* words_of(StudyHand hand) {
  switch (hand) {
    case StudyHand::right: return "right";
    case StudyHand::left: return "left";
    case StudyHand::affected: return "affected";
    case StudyHand::other: return "other than affected";
  }
  return "";
}

std::string sessions_words(const TrialSelection& selection) {
  if (selection.days)
    return "days " + std::to_string(selection.days->from) + " to " +
           std::to_string(selection.days->to);
  std::string text;
  for (const int session : selection.sessions)
    text += (text.empty() ? "" : ", ") + std::to_string(session);
  return text.empty() ? "all" : text;
}

/// Puts the blocks of a report together; figures that are undefined are named below their table.
class Composer {
 public:
  Composer(const Study& study, const StudyData& data, StudyReport& report)
      : study_(study), data_(data), conditions_(conditions_of(study)), report_(report) {}

  void design() {
    heading("Design", true);
    const auto words = tasks::words_for(study_.measure, common_channel());
    std::string text = words.title + unit_words() + " (" + study_.measure + ", version " +
                       std::to_string(data_.measure_version);
    if (words.better != tasks::Better::unknown)
      text += std::string(", ") + std::string(tasks::describe(words.better));
    text +=
        "). Each value of a person is the mean over the chosen sessions of the means of their "
        "trials; practice, helped and incomplete trials do not count.";
    paragraph(text);
    for (const auto& factor : study_.factors) {
      std::string levels;
      for (const auto& level : factor.levels) levels += (levels.empty() ? "" : ", ") + level.name;
      paragraph("Within subjects: " + factor.name + " (" + levels + ").");
    }
    StudyTable table{"Conditions", {"Condition", "Task", "Hand", "Sessions"}, {}, 4};
    const bool channels = std::any_of(conditions_.begin(), conditions_.end(), [](const auto& one) {
      return one.selection.channel.has_value();
    });
    if (channels) table.heads.push_back("Channel"), ++table.words;
    for (const auto& condition : conditions_) {
      table.rows.push_back({condition.name, *condition.selection.task,
                            words_of(*condition.selection.hand),
                            sessions_words(condition.selection)});
      if (channels) table.rows.back().push_back(condition.selection.channel.value_or(""));
    }
    add(std::move(table));
    if (!data_.left_out.empty()) {
      std::string all;
      for (const auto& words_left : data_.left_out) all += (all.empty() ? "" : "; ") + words_left;
      paragraph("Trials left out: " + all + ".", true);
    }
    if (!data_.renewed.empty())
      paragraph("Of all measures of these people " + data_.renewed + ".", true);
    if (data_.groups.size() > 1)
      paragraph("Each group is analysed by itself. Nothing in this report compares groups.", true);
  }

  void group(const StudyGroupData& group, const GroupAnalysis& analysis) {
    heading("Group: " + group.name, true);
    people(group, analysis);
    if (analysis.complete.values.rows() == 0) return;
    plot(analysis);
    summaries(analysis);
    if (analysis.one_way) one_way(*analysis.one_way, analysis.pairs);
    if (analysis.two_way) two_way(*analysis.two_way, analysis.simple_effects);
    ranks(analysis);
    if (analysis.reliability) agreement(*analysis.reliability);
  }

  void reading() {
    heading("How to read this", true);
    paragraph(statistics::kBoxRule, true);
    paragraph(
        "p is how often differences at least this large would be seen if the conditions did not "
        "differ. A large p does not show that they are equal, a small one not that a difference "
        "matters: read the difference and its interval. Several analyses of the same data raise "
        "the number of small p values found by chance; only comparisons within one table are "
        "corrected for their number.",
        true);
    paragraph(
        "Conditions that follow each other in time differ also by practice, fatigue and natural "
        "recovery; without a comparison group the cause of a difference stays open. Formulas and "
        "sources: docs/statistics.md.",
        true);
  }

 private:
  void add(StudyBlock block) { report_.blocks.push_back(std::move(block)); }
  void heading(const std::string& text, bool large = false) { add(StudyHeading{text, large}); }
  void paragraph(const std::string& text, bool quiet = false) { add(StudyParagraph{text, quiet}); }

  [[nodiscard]] std::string common_channel() const { return study_.common.channel.value_or(""); }
  [[nodiscard]] std::string unit_words() const {
    const auto unit = tasks::printed_unit(data_.unit).text;
    return unit.empty() ? "" : " [" + unit + "]";
  }

  /// A cell; an undefined figure is a dash, its reason goes below the table.
  template <class Words>
  std::string cell(const statistics::Computed& figure, Words words) {
    if (figure.value) return words(*figure.value);
    reasons_.insert(figure.reason);
    return kNoValue;
  }
  std::string value(const statistics::Computed& figure) {
    return cell(figure, [this](double x) { return tasks::format_value(x, data_.unit); });
  }
  std::string change(const statistics::Computed& figure) {
    return cell(figure, [this](double x) { return tasks::format_change(x, data_.unit); });
  }
  std::string p(const statistics::Computed& figure) { return cell(figure, p_words); }
  std::string number(const statistics::Computed& figure, int decimals = 2) {
    return cell(figure, [decimals](double x) { return fixed(x, decimals); });
  }
  std::string degrees(const statistics::Computed& figure) { return cell(figure, df_words); }
  std::string interval(const statistics::Computed& low, const statistics::Computed& high) {
    if (!low.value || !high.value) return number(low);
    return change(low) + " to " + change(high);
  }
  void add_with_reasons(StudyTable table) {
    add(std::move(table));
    for (const auto& why : reasons_)
      paragraph(std::string(kNoValue) + " not defined: " + why + ".", true);
    reasons_.clear();
  }

  void people(const StudyGroupData& group, const GroupAnalysis& analysis) {
    const auto all = group.subjects.size();
    const auto kept = analysis.complete.kept.size();
    paragraph(std::to_string(kept) + " of " +
              (all == 1 ? "1 person" : std::to_string(all) + " people") +
              (kept == 1 ? " has" : " have") + " a value in every condition" +
              (kept == all ? "." : "; the others stand in no statistic (listwise deletion)."));
    if (kept == all) return;
    StudyTable table{"Left out", {"Subject", "Condition", "Why"}, {}, 3};
    for (const auto row : analysis.complete.incomplete) {
      const auto at = static_cast<std::size_t>(row);
      for (std::size_t c = 0; c < conditions_.size(); ++c)
        if (!group.cells[at][c].value)
          table.rows.push_back(
              {group.subjects[at], conditions_[c].name, group.cells[at][c].reason});
    }
    add(std::move(table));
    paragraph(
        "If values are missing because people did badly, the rest is no picture of the group.",
        true);
  }

  void plot(const GroupAnalysis& analysis) {
    StudyPlot plot;
    plot.title = tasks::words_for(study_.measure, common_channel()).title + unit_words();
    plot.description = "Box plots of the conditions; the table below holds their numbers.";
    const auto unit = tasks::printed_unit(data_.unit);
    plot.unit = unit.text;
    for (std::size_t c = 0; c < conditions_.size(); ++c) {
      plot.names.push_back(conditions_[c].name);
      auto& values = plot.values.emplace_back();
      for (const double one : analysis.complete.values.col(static_cast<Eigen::Index>(c)))
        values.push_back(unit.factor * one);
    }
    add(std::move(plot));
  }

  void summaries(const GroupAnalysis& analysis) {
    StudyTable table{
        "Values of n = " + std::to_string(analysis.complete.kept.size()) + unit_words(),
        {"Condition", "Mean", "SD", "Lower quartile", "Median", "Upper quartile"},
        {}};
    for (std::size_t c = 0; c < conditions_.size(); ++c) {
      const auto& summary = analysis.conditions[c];
      table.rows.push_back({conditions_[c].name, value(summary.mean), value(summary.sd),
                            value(summary.box->lower_quartile), value(summary.box->median),
                            value(summary.box->upper_quartile)});
    }
    add_with_reasons(std::move(table));
  }

  std::vector<std::string> effect_row(const std::string& name,
                                      const statistics::WithinEffect& effect) {
    const auto pair = [](const std::string& a, const std::string& b) {
      return a == kNoValue ? a : a + ", " + b;
    };
    return {name,
            number(effect.f),
            pair(df_words(effect.df), df_words(effect.error_df)),
            p(effect.p),
            number(effect.sphericity.epsilon, 3),
            pair(degrees(effect.corrected_df), degrees(effect.corrected_error_df)),
            p(effect.corrected_p),
            number(effect.partial_eta2, 3),
            number(effect.generalised_eta2, 3)};
  }
  static StudyTable effect_table(const std::string& caption) {
    return {caption,
            {"Effect", "F", "df", "p", "GG \u03b5", "df \u00b7 \u03b5", "p corrected",
             "partial \u03b7\u00b2", "gen. \u03b7\u00b2"},
            {}};
  }

  void sphericity(
      const std::vector<std::pair<std::string, const statistics::WithinEffect*>>& effects) {
    StudyTable table{"Sphericity",
                     {"Effect", "Mauchly W", "\u03c7\u00b2", "df", "p", "GG \u03b5", "HF \u03b5"},
                     {}};
    for (const auto& [name, effect] : effects) {
      if (effect->df < 2.0) continue;
      const auto& s = effect->sphericity;
      table.rows.push_back({name, number(s.mauchly_w, 3), number(s.mauchly_chi2),
                            degrees(s.mauchly_df), p(s.mauchly_p), number(s.epsilon, 3),
                            number(s.epsilon_huynh_feldt, 3)});
    }
    if (table.rows.empty()) return;
    add_with_reasons(std::move(table));
    paragraph(
        "Where the differences between conditions are not equally variable, the plain p is too "
        "small; the corrected p (Greenhouse-Geisser) holds either way. In few people Mauchly's "
        "test seldom notices.",
        true);
  }

  void pairs_table(const std::string& caption, const std::vector<statistics::PairedT>& pairs,
                   const std::vector<std::string>& names) {
    StudyTable table{
        caption,
        {"Difference" + unit_words(), "Mean", percent_words(study_.confidence) + " interval",
         "t (df)", "p", "p Bonferroni", "d_z"},
        {}};
    for (const auto& pair : pairs)
      table.rows.push_back({names[static_cast<std::size_t>(pair.first)] + " \u2212 " +
                                names[static_cast<std::size_t>(pair.second)],
                            change(pair.mean_difference), interval(pair.low, pair.high),
                            number(pair.t) + " (" + df_words(pair.df) + ")", p(pair.p),
                            p(pair.p_bonferroni), number(pair.d_z)});
    const auto count = table.rows.size();
    add_with_reasons(std::move(table));
    if (count > 1)
      paragraph("Intervals and p Bonferroni are for the " + std::to_string(count) +
                    " comparisons of this table together.",
                true);
  }

  [[nodiscard]] std::vector<std::string> condition_names() const {
    std::vector<std::string> names;
    for (const auto& condition : conditions_) names.push_back(condition.name);
    return names;
  }
  [[nodiscard]] std::vector<std::string> level_names(std::size_t factor) const {
    std::vector<std::string> names;
    for (const auto& level : study_.factors[factor].levels) names.push_back(level.name);
    return names;
  }

  void one_way(const statistics::OneWayAnova& anova,
               const std::vector<statistics::PairedT>& pairs) {
    const auto& factor = study_.factors.front().name;
    heading("Repeated-measures analysis of variance");
    auto table = effect_table("Effect of " + factor);
    table.rows.push_back(effect_row(factor, anova.effect));
    add_with_reasons(std::move(table));
    sphericity({{factor, &anova.effect}});
    pairs_table("Pairs of conditions", pairs, condition_names());
  }

  void two_way(const statistics::TwoWayAnova& anova, const std::vector<SimpleEffect>& simple) {
    const auto& a = study_.factors[0].name;
    const auto& b = study_.factors[1].name;
    const auto both = a + " \u00d7 " + b;
    heading("Two-way repeated-measures analysis of variance");
    auto table = effect_table(both);
    table.rows = {effect_row(a, anova.a), effect_row(b, anova.b),
                  effect_row(both, anova.interaction)};
    add_with_reasons(std::move(table));
    sphericity({{a, &anova.a}, {b, &anova.b}, {both, &anova.interaction}});
    heading(a + " at each level of " + b);
    auto followed = effect_table("One-way analyses, not corrected for their number");
    for (const auto& one : simple)
      followed.rows.push_back(effect_row(a + " at " + one.at, one.anova.effect));
    add_with_reasons(std::move(followed));
    for (const auto& one : simple)
      pairs_table("Pairs of " + a + " at " + one.at, one.pairs, level_names(0));
  }

  void ranks(const GroupAnalysis& analysis) {
    if (analysis.friedman) {
      const auto& test = *analysis.friedman;
      heading("Friedman test");
      StudyTable table{"Ranks within each person, ties share theirs",
                       {"Effect", "\u03c7\u00b2", "df", "p", "Kendall's W"},
                       {}};
      table.rows.push_back({study_.factors.front().name, number(test.chi2), df_words(test.df),
                            p(test.p), number(test.kendall_w, 3)});
      add_with_reasons(std::move(table));
      StudyTable means{"Mean ranks", {"Condition", "Mean rank"}, {}};
      for (std::size_t c = 0; c < test.mean_ranks.size(); ++c)
        means.rows.push_back({conditions_[c].name, fixed(test.mean_ranks[c], 2)});
      if (!means.rows.empty()) add(std::move(means));
      paragraph("p from the \u03c7\u00b2 distribution, which is rough below some ten people.",
                true);
    }
    if (analysis.signed_ranks.empty()) return;
    heading("Wilcoxon signed rank test");
    StudyTable table{"Pairs of conditions",
                     {"Difference" + unit_words(), "Pseudo-median",
                      percent_words(study_.confidence) + " interval", "W+", "Pairs (zeros)", "p",
                      "p Bonferroni", "r", "rank-biserial"},
                     {}};
    const auto names = condition_names();
    bool exact = true;
    for (const auto& test : analysis.signed_ranks) {
      table.rows.push_back(
          {names[static_cast<std::size_t>(test.first)] + " \u2212 " +
               names[static_cast<std::size_t>(test.second)],
           change(test.pseudo_median), interval(test.low, test.high), number(test.w_plus, 1),
           std::to_string(test.pairs) + " (" + std::to_string(test.zeros) + ")", p(test.p),
           p(test.p_bonferroni), number(test.r), number(test.rank_biserial)});
      exact = exact && test.exact;
    }
    const auto count = table.rows.size();
    add_with_reasons(std::move(table));
    paragraph(std::string("Differences of zero are left out, ties share their ranks; p ") +
                  (exact ? "is exact, from all patterns of signs"
                         : "from the normal distribution above 50 pairs, else exact") +
                  ". Pseudo-median: Hodges and Lehmann, of all differences; r = z / \u221an." +
                  (count > 1 ? " Intervals and p Bonferroni are for the " + std::to_string(count) +
                                   " comparisons together."
                             : ""),
              true);
  }

  void agreement(const statistics::Reliability& r) {
    heading("Agreement of the repeats");
    StudyTable table{"Two-way random effects, single measurement, absolute agreement",
                     {"ICC(2,1)", percent_words(study_.confidence) + " interval",
                      "SEM" + unit_words(), "MDC95" + unit_words(), "People", "Repeats"},
                     {},
                     0};
    const auto bounds =
        r.low.value && r.high.value ? number(r.low, 3) + " to " + number(r.high, 3) : number(r.low);
    table.rows.push_back({number(r.icc, 3), bounds, value(r.sem), value(r.mdc95),
                          std::to_string(r.subjects), std::to_string(r.repeats)});
    add_with_reasons(std::move(table));
    paragraph(
        "The ICC depends on how much these people differ from each other. SEM and MDC95 hold for "
        "values as they are here, with the time between them that lies between these conditions; "
        "verdicts on one patient do not use them.",
        true);
  }

  const Study& study_;
  const StudyData& data_;
  const std::vector<StudyCondition> conditions_;
  StudyReport& report_;
  std::set<std::string> reasons_;  ///< of undefined figures in the current table
};

}  // namespace

StudyReport study_report(const Study& study, const StudyData& data,
                         const std::vector<GroupAnalysis>& analyses) {
  StudyReport report;
  std::size_t listed = 0;
  std::size_t kept = 0;
  for (std::size_t g = 0; g < data.groups.size(); ++g) {
    listed += data.groups[g].subjects.size();
    kept += analyses[g].complete.kept.size();
  }
  std::string factors;
  for (const auto& factor : study.factors)
    factors += (factors.empty() ? "" : " \u00d7 ") + factor.name;
  ReportContent like;  // the words of all reports
  like.software_version = ISOGRASP_VERSION;
  like.simulated = study.source == Source::simulated;
  like.recorded = study.source == Source::recorded;
  report.furniture = {
      "Group report",
      study.title,
      {{"Measure", tasks::words_for(study.measure, study.common.channel.value_or("")).title},
       {"Factors", factors},
       {"Subjects", std::to_string(kept) + " of " + std::to_string(listed)},
       {"Confidence", percent_words(study.confidence)},
       {"Forces", std::string(name_of(study.source))}},
      watermark(like),
      footer(like)};
  Composer composer(study, data, report);
  composer.design();
  for (std::size_t g = 0; g < data.groups.size(); ++g) composer.group(data.groups[g], analyses[g]);
  composer.reading();
  return report;
}

}  // namespace isograsp::reports
