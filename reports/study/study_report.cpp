// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences and tables of a group report. A p value never stands alone, and nothing is called
// significant, better or proven.
#include "reports/study/study_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/findings/report_text.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

/// With a minus sign; never "-0.00".
Number rounded(double value, int decimals) {
  std::string digits = fixed(std::abs(value), decimals).digits;
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  return {(value < 0.0 && !is_zero ? "\u2212" : "") + digits};
}

Text p_words(double p) {
  constexpr double kLeast = 0.001;
  if (p < kLeast) return "< %1"_text(Number{"0.001"});
  if (p > 1.0 - kLeast && p < 1.0) return "> %1"_text(Number{"0.999"});
  return "%1"_text(rounded(p, 3));
}

Number degrees_of_freedom(double df) {
  return rounded(df, df == std::floor(df) ? 0 : 2);
}

Text confidence_words(double share) {
  return "%1\u00a0%"_text(degrees_of_freedom(100.0 * share));
}

Words study_hand_words(StudyHand hand) {
  switch (hand) {
    case StudyHand::right: return "right"_text;
    case StudyHand::left: return "left"_text;
    case StudyHand::affected: return "affected"_text;
    case StudyHand::both: return "both"_text;
    case StudyHand::other: break;
  }
  return "other than affected"_text;
}

Text sessions_words(const TrialSelection& selection) {
  if (selection.days) return "days %1 to %2"_text(selection.days->from, selection.days->to);
  std::string text;
  for (const int session : selection.sessions)
    text += (text.empty() ? "" : ", ") + std::to_string(session);
  return text.empty() ? Text("all"_text) : "%1"_text(text);
}

/// Puts the blocks of a report together; figures that are undefined are named below their table.
class Composer {
 public:
  Composer(const Study& study, const StudyData& data, StudyReport& report, const Language& language)
      : study_(study),
        data_(data),
        conditions_(conditions_of(study)),
        say_(language),
        report_(report) {}

  void design() {
    heading("Design"_text, true);
    const auto words = tasks::words_of(study_.measure, common_channel());
    if (!data_.design.empty()) {
      paragraph("%1 (%2)."_text(titled(), better_words(words.better)));
      for (const Text& sentence : data_.design) paragraph(sentence);
      return;
    }
    paragraph(
        "%1 (%2). Each value of a person is the mean over the chosen sessions of the means "
        "of their trials; practice, helped and incomplete trials do not count."_text(
            titled(), listed({"%1"_text(study_.measure), "version %1"_text(data_.measure_version),
                              better_words(words.better)})));
    for (const auto& factor : study_.factors) {
      std::string levels;
      for (const auto& level : factor.levels) levels += (levels.empty() ? "" : ", ") + level.name;
      paragraph("Within subjects: %1 (%2)."_text(factor.name, levels));
    }
    StudyTable table = empty_table(
        "Conditions"_text, {"Condition"_text, "Task"_text, "Hand"_text, "Sessions"_text}, 4);
    const bool channels = std::any_of(conditions_.begin(), conditions_.end(), [](const auto& one) {
      return one.selection.channel.has_value();
    });
    if (channels) table.heads.push_back(say_("Channel"_text)), ++table.words;
    for (const auto& condition : conditions_) {
      table.rows.push_back({condition.name, say_(Known{*condition.selection.task}),
                            say_(study_hand_words(*condition.selection.hand)),
                            say_(sessions_words(condition.selection))});
      if (channels)
        table.rows.back().push_back(say_(Known{condition.selection.channel.value_or("")}));
    }
    add(std::move(table));
    if (!data_.left_out.empty())
      paragraph("Trials left out: %1."_text(apart(data_.left_out)), true);
    if (!data_.renewed.empty())
      paragraph("Of all measures of these people %1."_text(data_.renewed), true);
    if (data_.groups.size() > 1)
      paragraph("Each group is analysed by itself. Nothing in this report compares groups."_text,
                true);
  }

  void group(const StudyGroupData& group, const GroupAnalysis& analysis) {
    heading("Group: %1"_text(group.name), true);
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
    heading("How to read this"_text, true);
    paragraph(statistics::kBoxRule, true);
    paragraph(
        "p is how often differences at least this large would be seen if the conditions did not "
        "differ. A large p does not show that they are equal, a small one not that a difference "
        "matters: read the difference and its interval. Several analyses of the same data raise "
        "the number of small p values found by chance; only comparisons within one table are "
        "corrected for their number."_text,
        true);
    paragraph(
        "Conditions that follow each other in time differ also by practice, fatigue and natural "
        "recovery; without a comparison group the cause of a difference stays open. Formulas and "
        "sources: docs/statistics.md."_text,
        true);
  }

 private:
  void add(StudyBlock block) { report_.blocks.push_back(std::move(block)); }
  void heading(const Text& text, bool large = false) { add(StudyHeading{say_(text), large}); }
  void paragraph(const Text& text, bool quiet = false) { add(StudyParagraph{say_(text), quiet}); }
  [[nodiscard]] StudyTable empty_table(const Text& caption, const std::vector<Text>& heads,
                                       std::size_t words = 1) const {
    StudyTable table{say_(caption), {}, {}, words};
    for (const Text& head : heads) table.heads.push_back(say_(head));
    return table;
  }

  [[nodiscard]] std::string common_channel() const { return study_.common.channel.value_or(""); }
  /// "Mean [N]": what has the unit of the measure.
  [[nodiscard]] Text in_unit(const Text& what) const {
    const Text unit = tasks::unit_words(tasks::printed_unit(data_.unit).text);
    return unit.empty() ? what : "%1 [%2]"_text(what, unit);
  }
  [[nodiscard]] Text titled() const {
    return in_unit(measure_title(study_.measure, common_channel()));
  }

  /// A cell; an undefined figure is a dash, its reason goes below the table.
  template <class Words>
  std::string cell(const statistics::Computed& figure, Words words) {
    if (figure.value) return say_(words(*figure.value));
    reasons_.emplace(english(figure.reason), figure.reason);
    return kNoValue;
  }
  std::string value(const statistics::Computed& figure) {
    return cell(figure, [this](double x) { return value_number(x, data_.unit); });
  }
  std::string change(const statistics::Computed& figure) {
    return cell(figure, [this](double x) { return Number{tasks::format_change(x, data_.unit)}; });
  }
  std::string p(const statistics::Computed& figure) { return cell(figure, p_words); }
  std::string number(const statistics::Computed& figure, int decimals = 2) {
    return cell(figure, [decimals](double x) { return rounded(x, decimals); });
  }
  std::string degrees(const statistics::Computed& figure) {
    return cell(figure, degrees_of_freedom);
  }
  std::string interval(const statistics::Computed& low, const statistics::Computed& high) {
    if (!low.value || !high.value) return number(low);
    return say_("%1 to %2"_text(change(low), change(high)));
  }
  void add_with_reasons(StudyTable table) {
    add(std::move(table));
    for (const auto& [english, why] : reasons_)
      paragraph("%1 not defined: %2."_text(kNoValue, why), true);
    reasons_.clear();
  }

  void people(const StudyGroupData& group, const GroupAnalysis& analysis) {
    const auto all = group.subjects.size();
    const auto kept = analysis.complete.kept.size();
    const Text counted =
        all == 1    ? (kept == 1 ? "%1 of 1 person has a value in every condition"_text
                                 : "%1 of 1 person have a value in every condition"_text)(kept)
        : kept == 1 ? "1 of %1 people has a value in every condition"_text(all)
                    : "%1 of %2 people have a value in every condition"_text(kept, all);
    paragraph((kept == all
                   ? "%1."_text
                   : "%1; the others stand in no statistic (listwise deletion)."_text)(counted));
    if (kept == all) return;
    StudyTable table =
        empty_table("Left out"_text, {"Subject"_text, "Condition"_text, "Why"_text}, 3);
    for (const auto row : analysis.complete.incomplete) {
      const auto at = static_cast<std::size_t>(row);
      for (std::size_t c = 0; c < conditions_.size(); ++c)
        if (!group.cells[at][c].value)
          table.rows.push_back(
              {group.subjects[at], conditions_[c].name, say_(group.cells[at][c].reason)});
    }
    add(std::move(table));
    paragraph(
        "If values are missing because people did badly, the rest is no picture of the group."_text,
        true);
  }

  void plot(const GroupAnalysis& analysis) {
    StudyPlot plot;
    plot.title = say_(titled());
    plot.description =
        say_("Box plots of the conditions; the table below holds their numbers."_text);
    const auto unit = tasks::printed_unit(data_.unit);
    plot.unit = say_(unit.text.empty() ? "ratio"_text : tasks::unit_words(unit.text));
    plot.language = &say_.language();
    for (std::size_t c = 0; c < conditions_.size(); ++c) {
      plot.names.push_back(conditions_[c].name);
      auto& values = plot.values.emplace_back();
      for (const double one : analysis.complete.values.col(static_cast<Eigen::Index>(c)))
        values.push_back(unit.factor * one);
    }
    add(std::move(plot));
  }

  void summaries(const GroupAnalysis& analysis) {
    StudyTable table = empty_table(in_unit("Values of n = %1"_text(analysis.complete.kept.size())),
                                   {"Condition"_text, "Mean"_text, "SD"_text, "Lower quartile"_text,
                                    "Median"_text, "Upper quartile"_text});
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
    const auto pair = [this](const std::string& a, const std::string& b) {
      return a == kNoValue ? a : say_("%1, %2"_text(a, b));
    };
    return {name,
            number(effect.f),
            pair(say_(degrees_of_freedom(effect.df)), say_(degrees_of_freedom(effect.error_df))),
            p(effect.p),
            number(effect.sphericity.epsilon, 3),
            pair(degrees(effect.corrected_df), degrees(effect.corrected_error_df)),
            p(effect.corrected_p),
            number(effect.partial_eta2, 3),
            number(effect.generalised_eta2, 3)};
  }
  [[nodiscard]] StudyTable effect_table(const Text& caption) const {
    return empty_table(caption, {"Effect"_text, "F"_text, "df"_text, "p"_text, "GG \u03b5"_text,
                                 "df \u00b7 \u03b5"_text, "p corrected"_text,
                                 "partial \u03b7\u00b2"_text, "gen. \u03b7\u00b2"_text});
  }

  void sphericity(
      const std::vector<std::pair<std::string, const statistics::WithinEffect*>>& effects) {
    StudyTable table =
        empty_table("Sphericity"_text, {"Effect"_text, "Mauchly W"_text, "\u03c7\u00b2"_text,
                                        "df"_text, "p"_text, "GG \u03b5"_text, "HF \u03b5"_text});
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
        "test seldom notices."_text,
        true);
  }

  void pairs_table(const Text& caption, const std::vector<statistics::PairedT>& pairs,
                   const std::vector<std::string>& names) {
    StudyTable table =
        empty_table(caption, {in_unit("Difference"_text), "Mean"_text, interval_head(),
                              "t (df)"_text, "p"_text, "p Bonferroni"_text, "d_z"_text});
    for (const auto& pair : pairs)
      table.rows.push_back({names[static_cast<std::size_t>(pair.first)] + " \u2212 " +
                                names[static_cast<std::size_t>(pair.second)],
                            change(pair.mean_difference), interval(pair.low, pair.high),
                            number(pair.t) + " (" + say_(degrees_of_freedom(pair.df)) + ")",
                            p(pair.p), p(pair.p_bonferroni), number(pair.d_z)});
    const auto count = table.rows.size();
    add_with_reasons(std::move(table));
    if (count > 1)
      paragraph(
          "Intervals and p Bonferroni are for the %1 comparisons of this table together."_text(
              count),
          true);
  }

  [[nodiscard]] Text interval_head() const {
    return "%1 interval"_text(confidence_words(study_.confidence));
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
    heading("Repeated-measures analysis of variance"_text);
    auto table = effect_table("Effect of %1"_text(factor));
    table.rows.push_back(effect_row(factor, anova.effect));
    add_with_reasons(std::move(table));
    sphericity({{factor, &anova.effect}});
    pairs_table("Pairs of conditions"_text, pairs, condition_names());
  }

  void two_way(const statistics::TwoWayAnova& anova, const std::vector<SimpleEffect>& simple) {
    const auto& a = study_.factors[0].name;
    const auto& b = study_.factors[1].name;
    const auto both = a + " \u00d7 " + b;
    heading("Two-way repeated-measures analysis of variance"_text);
    auto table = effect_table("%1"_text(both));
    table.rows = {effect_row(a, anova.a), effect_row(b, anova.b),
                  effect_row(both, anova.interaction)};
    add_with_reasons(std::move(table));
    sphericity({{a, &anova.a}, {b, &anova.b}, {both, &anova.interaction}});
    heading("%1 at each level of %2"_text(a, b));
    auto followed = effect_table("One-way analyses, not corrected for their number"_text);
    for (const auto& one : simple)
      followed.rows.push_back(effect_row(say_("%1 at %2"_text(a, one.at)), one.anova.effect));
    add_with_reasons(std::move(followed));
    for (const auto& one : simple)
      pairs_table("Pairs of %1 at %2"_text(a, one.at), one.pairs, level_names(0));
  }

  void ranks(const GroupAnalysis& analysis) {
    if (analysis.friedman) {
      const auto& test = *analysis.friedman;
      heading("Friedman test"_text);
      StudyTable table = empty_table(
          "Ranks within each person, ties share theirs"_text,
          {"Effect"_text, "\u03c7\u00b2"_text, "df"_text, "p"_text, "Kendall's W"_text});
      table.rows.push_back({study_.factors.front().name, number(test.chi2),
                            say_(degrees_of_freedom(test.df)), p(test.p),
                            number(test.kendall_w, 3)});
      add_with_reasons(std::move(table));
      StudyTable means = empty_table("Mean ranks"_text, {"Condition"_text, "Mean rank"_text});
      for (std::size_t c = 0; c < test.mean_ranks.size(); ++c)
        means.rows.push_back({conditions_[c].name, say_(rounded(test.mean_ranks[c], 2))});
      if (!means.rows.empty()) add(std::move(means));
      paragraph("p from the \u03c7\u00b2 distribution, which is rough below some ten people."_text,
                true);
    }
    if (analysis.signed_ranks.empty()) return;
    heading("Wilcoxon signed rank test"_text);
    StudyTable table = empty_table(
        "Pairs of conditions"_text,
        {in_unit("Difference"_text), "Pseudo-median"_text, interval_head(), "W+"_text,
         "Pairs (zeros)"_text, "p"_text, "p Bonferroni"_text, "r"_text, "rank-biserial"_text});
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
    paragraph(
        joined({exact ? "Differences of zero are left out, ties share their ranks; p is exact, "
                        "from all patterns of signs. Pseudo-median: Hodges and Lehmann, of all "
                        "differences; r = z / \u221an."_text
                      : "Differences of zero are left out, ties share their ranks; p from the "
                        "normal distribution above 50 pairs, else exact. Pseudo-median: Hodges "
                        "and Lehmann, of all differences; r = z / \u221an."_text,
                count > 1
                    ? "Intervals and p Bonferroni are for the %1 comparisons together."_text(count)
                    : Text()}),
        true);
  }

  void agreement(const statistics::Reliability& r) {
    heading("Agreement of the repeats"_text);
    StudyTable table =
        empty_table("Two-way random effects, single measurement, absolute agreement"_text,
                    {"ICC(2,1)"_text, interval_head(), in_unit("SEM"_text), in_unit("MDC95"_text),
                     "People"_text, "Repeats"_text},
                    0);
    const auto bounds = r.low.value && r.high.value
                            ? say_("%1 to %2"_text(number(r.low, 3), number(r.high, 3)))
                            : number(r.low);
    table.rows.push_back({number(r.icc, 3), bounds, value(r.sem), value(r.mdc95),
                          std::to_string(r.subjects), std::to_string(r.repeats)});
    add_with_reasons(std::move(table));
    paragraph(
        "The ICC depends on how much these people differ from each other. SEM and MDC95 hold for "
        "values as they are here, with the time between them that lies between these conditions; "
        "verdicts on one patient do not use them."_text,
        true);
  }

  const Study& study_;
  const StudyData& data_;
  const std::vector<StudyCondition> conditions_;
  const Speaker say_;
  StudyReport& report_;
  std::map<std::string, Text> reasons_;  ///< by their English; of the current table
};

}  // namespace

StudyReport study_report(const Study& study, const StudyData& data,
                         const std::vector<GroupAnalysis>& analyses, const Language& language) {
  const Speaker say(language);
  StudyReport report;
  std::size_t people = 0;
  std::size_t kept = 0;
  for (std::size_t g = 0; g < data.groups.size(); ++g) {
    people += data.groups[g].subjects.size();
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
      say("Group report"_text),
      study.title,
      {{say("Measure"_text), say(measure_title(study.measure, study.common.channel.value_or("")))},
       {say("Factors"_text), factors},
       {say("Subjects"_text), say("%1 of %2"_text(kept, people))},
       {say("Confidence"_text), say(confidence_words(study.confidence))},
       {say("Forces"_text), say(words_of(study.source))}},
      say(watermark(like)),
      say(footer(like)),
      &language};
  Composer composer(study, data, report, language);
  composer.design();
  for (std::size_t g = 0; g < data.groups.size(); ++g) composer.group(data.groups[g], analyses[g]);
  composer.reading();
  return report;
}

}  // namespace isograsp::reports
