// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/study/study_plot.hpp"

#include <QBuffer>
#include <QImage>
#include <algorithm>

#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plotting.hpp"
#include "reports/study/study_writer.hpp"
#include "statistics/box_plot.hpp"

namespace isograsp::reports {

namespace {

constexpr double kBoxWidth = 0.56;   // of the distance between two boxes
constexpr double kDotsWidth = 0.34;  // over which the dots of a box are spread
constexpr double kTickLine = 8.0;    // height of a line of tick labels [points]

/// Broken at blanks into lines of so many characters, as far as words allow.
QString broken(const std::string& name, int characters) {
  QString text;
  int used = 0;
  for (const QString& word : QString::fromStdString(name).split(' ')) {
    if (used > 0 && used + 1 + word.size() > characters) {
      text += '\n';
      used = 0;
    }
    if (used > 0) text += ' ';
    text += word;
    used += 1 + static_cast<int>(word.size());
  }
  return text;
}

/// Where a subject's dot stands beside the middle of the box.
double place_of(int subject, int subjects) {
  return subjects < 2 ? 0.0 : kDotsWidth * (static_cast<double>(subject) / (subjects - 1) - 0.5);
}

}  // namespace

PlotView study_plot(const StudyPlot& plot, QSizeF size, double unit) {
  PlotView view(size, unit, *plot.language);
  const int count = static_cast<int>(plot.names.size());
  constexpr double kCharacter = 3.9;  // width of a tick label's letter [points]
  const double room = (size.width() - kLeft - kRight) / count;
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  int lines = 1;
  for (int c = 0; c < count; ++c) {
    const auto label =
        broken(plot.names[static_cast<std::size_t>(c)], static_cast<int>(room / kCharacter));
    lines = std::max(lines, static_cast<int>(label.count('\n')) + 1);
    ticker->addTick(c, label);
  }
  const double below = 6.0 + lines * kTickLine;
  QCPAxisRect& rect =
      view.add_axes({kLeft, 6.0, size.width() - kLeft - kRight, size.height() - 6.0 - below});
  QCPAxis* across = rect.axis(QCPAxis::atBottom);
  QCPAxis* up = rect.axis(QCPAxis::atLeft);
  across->setRange(-0.5, count - 0.5);
  across->setTicker(ticker);
  Values all;
  for (const auto& values : plot.values)
    for (const double value : values) all.push_back(value);
  up->setRange(range_of({&all}));
  up->setLabel(QString::fromStdString(plot.unit));

  const int subjects = plot.values.empty() ? 0 : static_cast<int>(plot.values.front().size());
  for (int s = 0; s < subjects; ++s) {
    Values x;
    Values y;
    for (int c = 0; c < count; ++c) {
      x.push_back(c + place_of(s, subjects));
      y.push_back(plot.values[static_cast<std::size_t>(c)][static_cast<std::size_t>(s)]);
    }
    add_line(rect, x, y, QPen(Palette::line(), view.px(0.5)));
    QCPGraph& dots = add_line(rect, x, y, QPen(Qt::NoPen));
    dots.setLineStyle(QCPGraph::lsNone);
    dots.setScatterStyle({QCPScatterStyle::ssDisc, QPen(Palette::of(Hand::right), view.px(0.4)),
                          Palette::of(Hand::right), view.px(3.0)});
  }
  for (int c = 0; c < count; ++c) {
    const auto box = statistics::box_plot(plot.values[static_cast<std::size_t>(c)]);
    if (!box) continue;
    auto* item = new QCPStatisticalBox(across, up);  // the plot owns it
    item->setWidth(kBoxWidth);
    item->setWhiskerWidth(kBoxWidth / 2.0);
    item->setPen(QPen(Palette::ink(), view.px(0.8)));
    item->setMedianPen(QPen(Palette::ink(), view.px(1.8), Qt::SolidLine, Qt::FlatCap));
    item->setWhiskerPen(QPen(Palette::ink(), view.px(0.8)));
    item->setWhiskerBarPen(QPen(Palette::ink(), view.px(0.8)));
    item->setBrush(Qt::NoBrush);
    item->addData(c, box->lower_whisker, box->lower_quartile, box->median, box->upper_quartile,
                  box->upper_whisker);
  }
  return view;
}

std::string study_png(const StudyPlot& plot) {
  constexpr double kWide_pt = 425.0;  // 150 mm
  constexpr double kHigh_pt = 200.0;
  constexpr double kDots = 300.0 / 72.0;
  QImage image(QSize(static_cast<int>(kWide_pt * kDots), static_cast<int>(kHigh_pt * kDots)),
               QImage::Format_RGB32);
  image.fill(Qt::white);
  QCPPainter painter(&image);
  PlotView view = study_plot(plot, {kWide_pt, kHigh_pt}, kDots);
  view.paint(painter);
  painter.end();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

}  // namespace isograsp::reports
