// SPDX-License-Identifier: GPL-3.0-or-later
// How the links of an arm share the movements of a trial: their turns against the time of the
// movement, and movement by movement who began and how much each did.
#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/bands.hpp"
#include "reports/paper/plot_tools.hpp"
#include "statistics/percentile.hpp"

namespace isograsp::reports {

namespace {

constexpr std::array kAllLinks{ArmLink::forearm, ArmLink::wrist, ArmLink::fingers};
constexpr double kBandOpacity = 0.16;

std::string name_of_link(ArmLink link) {
  return std::string(kArmLinkNames[index_of(link)]);
}

/// Mean and spread of the share of its turn that a link has, where enough movements have one.
struct LinkBand {
  Values x, mean, low, high;
};
LinkBand band_of(const std::vector<BandPoint>& points, const std::string& posture, ArmLink link) {
  LinkBand band;
  for (const BandPoint& point : points) {
    if (point.posture != posture || point.channel != name_of_link(link) + "_r") continue;
    if (point.n < kLeastBandMovements || !point.sd) continue;
    band.x.push_back(point.tau);
    band.mean.push_back(point.mean);
    band.low.push_back(point.mean - *point.sd);
    band.high.push_back(point.mean + *point.sd);
  }
  return band;
}

void add_spread(QCPAxisRect& rect, const LinkBand& band, QColor color) {
  color.setAlphaF(kBandOpacity);
  QCPGraph& low = add_line(rect, band.x, band.low, QPen(Qt::NoPen));
  QCPGraph& high = add_line(rect, band.x, band.high, QPen(Qt::NoPen));
  high.setBrush(color);
  high.setChannelFillGraph(&low);
}

/// The value of one movement measure of a link in each movement that has it.
std::vector<double> values_of(const std::vector<MovementMeasure>& all, std::string_view measure,
                              ArmLink link) {
  std::vector<double> values;
  for (const MovementMeasure& one : all)
    if (one.measure.name == measure && one.measure.channel == name_of_link(link) &&
        one.measure.value)
      values.push_back(*one.measure.value);
  return values;
}

/// Rows of dots, the forearm on top.
class DotRows {
 public:
  DotRows(PlotView& view, QCPAxisRect& rect, const Text& title) : view_(view), rect_(rect) {
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (const ArmLink link : kAllLinks) ticker->addTick(height(link), view.said(link_words(link)));
    rect.axis(QCPAxis::atLeft)->setTicker(ticker);
    rect.axis(QCPAxis::atLeft)->setRange(-0.6, 2.6);
    rect.axis(QCPAxis::atBottom)->setLabel(view.said(title));
    rect.axis(QCPAxis::atBottom)->grid()->setPen(QPen(Palette::line(), view.px(0.5)));
  }

  void add_healthy(ArmLink link, const NormBand& norm) {
    if (!norm.low || !norm.high) return;
    Values x{*norm.low, *norm.high};
    QCPGraph& low = add_line(rect_, x, {height(link) - kHalf, height(link) - kHalf}, Qt::NoPen);
    QCPGraph& high = add_line(rect_, x, {height(link) + kHalf, height(link) + kHalf}, Qt::NoPen);
    high.setBrush(Palette::tolerance());
    high.setChannelFillGraph(&low);
  }

  void add(ArmLink link, const std::vector<double>& values) {
    if (values.empty()) return;
    Values x(values.begin(), values.end());
    const QColor color = link_pen(view_, link).color();
    QCPGraph& dots = add_line(rect_, x, Values(x.size(), height(link)), QPen(Qt::NoPen));
    dots.setLineStyle(QCPGraph::lsNone);
    dots.setScatterStyle(
        {QCPScatterStyle::ssCircle, QPen(color, view_.px(0.8)), Qt::white, view_.px(3.6)});
    const double middle = *statistics::median(values).value;
    add_line(rect_, {middle, middle}, {height(link) - kHalf, height(link) + kHalf},
             QPen(color, view_.px(1.6)));
    all_ += x;
  }

  void end(double at_least) {
    Values whole{0.0, at_least};
    whole += all_;
    const auto [low, high] = std::minmax_element(whole.begin(), whole.end());
    const double air = 0.04 * (*high - *low);
    rect_.axis(QCPAxis::atBottom)->setRange(*low - air, *high + air);
  }

 private:
  static constexpr double kHalf = 0.33;
  static double height(ArmLink link) { return 2.0 - static_cast<double>(index_of(link)); }

  PlotView& view_;
  QCPAxisRect& rect_;
  Values all_;
};

}  // namespace

std::vector<std::string> postures_with_band(const TaskSection& section) {
  struct Counted {
    std::string name;
    int movements = 0;
  };
  std::vector<Counted> counted;
  if (!section.poses || !section.poses->unmeasured.empty()) return {};
  const MovementScores& movements = section.poses->movements;
  for (std::size_t m = 0; m < movements.targets.size(); ++m) {
    const auto& links = movements.links[m];
    if (std::none_of(links.begin(), links.end(),
                     [](const LinkMovement& link) { return !link.angle.empty(); }))
      continue;
    const std::string& name = movements.targets[m].posture;
    auto found = std::find_if(counted.begin(), counted.end(),
                              [&](const Counted& one) { return one.name == name; });
    if (found == counted.end()) found = counted.insert(counted.end(), {name, 0});
    ++found->movements;
  }
  std::erase_if(counted, [](const Counted& one) { return one.movements < kLeastBandMovements; });
  std::stable_sort(counted.begin(), counted.end(),
                   [](const Counted& a, const Counted& b) { return a.movements > b.movements; });
  std::vector<std::string> names;
  for (Counted& one : counted) names.push_back(std::move(one.name));
  return names;
}

PlotView turns_plot(const TaskSection& section, const std::string& posture, QSizeF size,
                    double unit, const Language& language) {
  PlotView view(size, unit, language);
  QCPAxisRect& rect = view.add_axes({kLeft, kAboveWithKey, size.width() - kLeft - kRight,
                                     size.height() - kAboveWithKey - kBelow});
  rect.axis(QCPAxis::atBottom)->setLabel(view.said("time, part of the movement"_text));
  rect.axis(QCPAxis::atLeft)->setLabel(view.said("part of the turn"_text));
  const tasks::PoseTrial& trial = *section.poses;
  const auto points = movement_bands(trial.rig, trial.series, trial.movements);
  if (!points) return view;
  std::array<LinkBand, kArmLinkCount> bands;
  for (const ArmLink link : kAllLinks) bands[index_of(link)] = band_of(*points, posture, link);
  Values x{0.0};
  Values y{0.0, 1.0};
  for (const LinkBand& band : bands) {
    x += band.x;
    y += band.low;
    y += band.high;
  }
  const auto [first, last] = std::minmax_element(x.begin(), x.end());
  rect.axis(QCPAxis::atBottom)->setRange(*first, *last);
  rect.axis(QCPAxis::atLeft)->setRange(range_of({&y}));
  for (const ArmLink link : kAllLinks)
    add_spread(rect, bands[index_of(link)], link_pen(view, link).color());
  for (const ArmLink link : kAllLinks) {
    const LinkBand& band = bands[index_of(link)];
    if (band.x.isEmpty()) continue;  // it hardly turns
    add_line(rect, band.x, band.mean, link_pen(view, link));
    explain_link(view, link);
  }
  return view;
}

PlotView sharing_plot(const TaskSection& section, QSizeF size, double unit,
                      const Language& language) {
  PlotView view(size, unit, language);
  const tasks::PoseTrial& trial = *section.poses;
  const auto measures = movement_measures(trial.rig, trial.movements);
  constexpr double kNames = 50.0;  // room for the names of links
  const double each = (size.height() - kAboveWithKey - 2.0 * kBelow) / 2.0;
  const auto place = [&](double top) -> QCPAxisRect& {
    return view.add_axes({kNames, top, size.width() - kNames - kRight, each});
  };
  DotRows began(view, place(kAboveWithKey), "begins to turn, after the cue [s]"_text);
  DotRows shares(view, place(kAboveWithKey + each + kBelow),
                 "share of its turn, forearm at 63 %"_text);
  bool healthy = false;
  for (const ArmLink link : kAllLinks) {
    if (const auto& norm = section.link_shares[index_of(link)]; norm && norm->low) {
      shares.add_healthy(link, *norm);
      healthy = true;
    }
    began.add(link, values_of(measures, "t10", link));
    shares.add(link, values_of(measures, "share_angle", link));
  }
  began.end(0.0);
  shares.end(1.0);
  view.explain(PlotView::Mark::ring, Palette::ink(), "a movement"_text);
  view.explain(PlotView::Mark::line, Palette::ink(), "median"_text);
  if (healthy) view.explain(PlotView::Mark::band, Palette::tolerance(), "healthy people"_text);
  return view;
}

}  // namespace isograsp::reports
