// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pdf_writer.hpp"

#include <QBuffer>
#include <QPdfWriter>
#include <algorithm>
#include <cmath>
#include <memory>

#include <qcustomplot.h>

#include "core/files.hpp"
#include "reports/page_layout.hpp"
#include "reports/plots.hpp"
#include "reports/report_text.hpp"

namespace isograsp {

namespace {

constexpr int kResolution = 1200;  // per inch: text is laid out on this grid
constexpr double kUnit = kResolution / 72.0;
// A4 and its margins [points]
constexpr double kPageWidth = 595.0;
constexpr double kPageHeight = 842.0;
constexpr double kSide = 48.0;
constexpr double kTop = 58.0;
constexpr double kBottom = 58.0;
constexpr double kWidth = kPageWidth - 2.0 * kSide;
constexpr double kGutter = 14.0;
constexpr double kColumn = (kWidth - 2.0 * kGutter) / 3.0;
constexpr double kTrendHeight = 88.0;
constexpr double kForceHeight = 118.0;
constexpr double kPoseHeight = 180.0;
constexpr double kSectionGap = 20.0;

QString text_of(const std::string& text) {
  return QString::fromStdString(text);
}

const TextStyle kBody{8.0};
const TextStyle kStrong{8.0, true};
const TextStyle kQuiet{7.2, false, Palette::quiet()};
const TextStyle kHeading{11.5, true};

class PdfReport {
 public:
  explicit PdfReport(const ReportContent& content) : content_(content) {
    if (content_.sections.empty()) add_text(text_of(nothing_yet()), kBody, 0.0);
    add_glance();
    add_quality();
    add_sections();
  }

  void write(QIODevice& device) {
    QPdfWriter writer(&device);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle("Progress report " + text_of(content_.code));
    writer.setCreator("IsoGrasp " + text_of(content_.software_version));
    QCPPainter painter(&writer);
    const double first_top = header_height();
    const auto pages =
        break_into_pages(blocks_, kPageHeight - kBottom - first_top, kPageHeight - kBottom - kTop);
    for (std::size_t page = 0; page < pages.size(); ++page) {
      if (page > 0) writer.newPage();
      if (page == 0)
        draw_header(painter);
      else
        draw_running_head(painter);
      double y = page == 0 ? first_top : kTop;
      for (std::size_t i = pages[page].first; i < pages[page].last; ++i) {
        if (i > pages[page].first) y += blocks_[i].gap_above;
        blocks_[i].draw(painter, y);
        y += blocks_[i].height;
      }
      draw_footer(painter, page + 1, pages.size());
      draw_watermark(painter);
    }
  }

 private:
  // ---- page furniture -------------------------------------------------------------------------

  [[nodiscard]] double header_height() const { return 158.0; }

  void rule(QPainter& painter, double y, double width_pt, const QColor& color) const {
    painter.setPen(QPen(color, width_pt * kUnit));
    painter.drawLine(QPointF(kSide * kUnit, y * kUnit),
                     QPointF((kPageWidth - kSide) * kUnit, y * kUnit));
  }

  /// The source of simulated or replayed forces, at the upper right of every page.
  void draw_badge(QPainter& painter, double y) const {
    const auto word = text_of(watermark(content_));
    if (word.isEmpty()) return;
    const QFont font = report_font(7.2 * kUnit, true);
    const double width = QFontMetricsF(font).horizontalAdvance(word) / kUnit + 16.0;
    const double x = kPageWidth - kSide - width;
    painter.setPen(QPen(Palette::ink(), 0.9 * kUnit));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(x * kUnit, y * kUnit, width * kUnit, 17.0 * kUnit));
    text_.draw(painter, x, y + 4.0, width, word,
               {7.2, true, Palette::ink(), Qt::AlignHCenter, 100.0});
  }

  void draw_header(QPainter& painter) const {
    text_.draw(painter, kSide, 46.0, kWidth, "IsoGrasp \u00b7 Progress report",
               {8.5, false, Palette::quiet()});
    text_.draw(painter, kSide, 59.0, kWidth, text_of(content_.code), {24.0, true});
    draw_badge(painter, 50.0);
    const double y = 102.0;
    rule(painter, y, 0.9, Palette::ink());
    const auto facts = header_facts(content_);
    constexpr double kShares[] = {1.75, 1.25, 0.65, 0.85, 1.25};
    double total = 0.0;
    for (std::size_t i = 0; i < facts.size(); ++i) total += kShares[i];
    double x = kSide;
    for (std::size_t i = 0; i < facts.size(); ++i) {
      const double width = kWidth * kShares[i] / total;
      text_.draw(painter, x, y + 9.0, width, text_of(facts[i].label), kQuiet);
      text_.draw(painter, x, y + 20.0, width, text_of(facts[i].value), {8.8, true});
      x += width;
    }
    rule(painter, y + 40.0, 0.5, Palette::line());
  }

  void draw_running_head(QPainter& painter) const {
    text_.draw(painter, kSide, 34.0, kWidth, "Progress report \u00b7 " + text_of(content_.code),
               kQuiet);
    draw_badge(painter, 26.0);
  }

  void draw_footer(QPainter& painter, std::size_t page, std::size_t pages) const {
    const double y = kPageHeight - 44.0;
    rule(painter, y - 6.0, 0.5, Palette::line());
    const TextStyle small{6.4, false, Palette::quiet()};
    text_.draw(painter, kSide, y, kWidth - 80.0, text_of(footer(content_)), small);
    TextStyle number = small;
    number.align = Qt::AlignRight;
    text_.draw(painter, kPageWidth - kSide - 76.0, y, 76.0,
               QString("page %1 of %2").arg(page).arg(pages), number);
  }

  /// Across the page, faint enough to read through, impossible to crop away.
  void draw_watermark(QPainter& painter) const {
    const auto word = text_of(watermark(content_));
    if (word.isEmpty()) return;
    painter.save();
    painter.translate(kPageWidth / 2.0 * kUnit, kPageHeight / 2.0 * kUnit);
    painter.rotate(-std::atan2(kPageHeight, kPageWidth) * 180.0 / M_PI);
    const double size = word.size() > 20 ? 36.0 : 58.0;
    const QFont font = report_font(size * kUnit, true);
    constexpr int kFaint = 13;  // of 255
    painter.setPen(QColor(0, 0, 0, kFaint));
    painter.setFont(font);
    const double width = QFontMetricsF(font).horizontalAdvance(word);
    painter.drawText(QPointF(-width / 2.0, size * kUnit * 0.36), word);
    painter.restore();
  }

  // ---- content --------------------------------------------------------------------------------

  void add_text(const QString& text, const TextStyle& style, double gap_above) {
    blocks_.push_back({gap_above, text_.height(text, kWidth, style), false,
                       [this, text, style](QCPPainter& painter, double y) {
                         text_.draw(painter, kSide, y, kWidth, text, style);
                       }});
  }

  void add_heading(const QString& text, double gap_above) {
    blocks_.push_back({gap_above, 20.0, true, [this, text](QCPPainter& painter, double y) {
                         text_.draw(painter, kSide, y, kWidth, text, kHeading);
                       }});
  }

  struct Cell {
    QString text;
    TextStyle style;
  };

  void add_glance() {
    const auto rows = glance_rows(content_);
    if (rows.empty()) return;
    add_heading("At a glance", kSectionGap);
    TextStyle head = kQuiet;
    add_row({{"Task", head},
             {"Measure", head},
             {"Baseline", head},
             {"Last", head},
             {"Change", head},
             {"Verdict", head}},
            "", "", 0.7, Palette::quiet());
    for (const auto& row : rows)
      add_row({{text_of(row.task), kBody},
               {text_of(row.measure), kBody},
               {text_of(row.baseline), kBody},
               {text_of(row.last), kStrong},
               {text_of(row.change), kBody},
               {text_of(row.verdict), kBody}},
              text_of(row.hand) + " hand", text_of(row.baseline_basis), 0.5, Palette::line(),
              text_of(row.direction));
    blocks_.back().keep_with_next = true;
    add_text(text_of(verdict_note()), kQuiet, 6.0);
  }

  void add_row(std::vector<Cell> cells, const QString& under_task, const QString& under_baseline,
               double rule_pt, const QColor& rule_color, const QString& under_measure = "") {
    const bool two_lines = !under_task.isEmpty();
    const double height = two_lines ? 27.0 : 15.0;
    auto draw = [=, this](QCPPainter& painter, double y) {
      constexpr double kShares[] = {0.19, 0.22, 0.125, 0.105, 0.115, 0.245};
      constexpr double kSpace = 6.0;
      double x = kSide;
      const double top = y + (two_lines ? 4.0 : 1.0);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const double width = kWidth * kShares[i];
        TextStyle style = cells[i].style;
        const bool is_number = i >= 2 && i <= 4;
        if (is_number) style.align = Qt::AlignRight;
        const double inset = i == 5 ? 14.0 : 0.0;
        const double inner = width - (is_number ? 0.0 : kSpace) - inset;
        text_.draw(painter, x + inset, top, inner, cells[i].text, style);
        TextStyle under{6.8, false, Palette::quiet(), style.align};
        const QString more = i == 0   ? under_task
                             : i == 1 ? under_measure
                             : i == 2 ? under_baseline
                                      : QString();
        if (!more.isEmpty()) text_.draw(painter, x + inset, top + 10.5, inner, more, under);
        x += width;
      }
      rule(painter, y + height, rule_pt, rule_color);
    };
    blocks_.push_back({0.0, height, !two_lines, draw});
  }

  void add_quality() {
    if (content_.quality.empty()) return;
    const auto& last = content_.sessions.back();
    add_heading("Was the last measurement valid?", kSectionGap);
    constexpr double kPad = 10.0;
    constexpr double kLabel = 84.0;
    struct Line {
      QString label;
      QString text;
      bool attention;
      double height;
    };
    std::vector<Line> lines;
    double height = 2.0 * kPad - 3.0;
    const double text_width = kWidth - 2.0 * kPad - kLabel;
    const auto add = [&](const QString& label, const QString& text, bool attention) {
      const TextStyle style = attention ? kStrong : kBody;
      lines.push_back({label, text, attention, text_.height(text, text_width, style) + 3.0});
      height += lines.back().height;
    };
    add("Session",
        QString("%1, %2, %3 hand, %4")
            .arg(last.number)
            .arg(text_of(format_date(last.date)), QString::fromUtf8(name_of(last.hand).data()),
                 text_of(last.device)),
        false);
    for (const auto& line : content_.quality)
      add(text_of(line.label), text_of(line.text), line.attention);
    blocks_.push_back(
        {0.0, height, false, [=, this](QCPPainter& painter, double y) {
           painter.setPen(QPen(Palette::line(), 0.7 * kUnit));
           painter.setBrush(Qt::NoBrush);
           painter.drawRect(QRectF(kSide * kUnit, y * kUnit, kWidth * kUnit, height * kUnit));
           double line_y = y + kPad;
           for (const auto& line : lines) {
             text_.draw(painter, kSide + kPad, line_y, kLabel,
                        (line.attention ? "! " : "") + line.label,
                        line.attention ? kStrong : TextStyle{8.0, false, Palette::quiet()});
             text_.draw(painter, kSide + kPad + kLabel, line_y, text_width, line.text,
                        line.attention ? kStrong : kBody);
             line_y += line.height;
           }
         }});
  }

  void add_sections();
  void add_section_row(const std::vector<const TaskSection*>& row);
  void draw_section(QCPPainter& painter, const TaskSection& section, double x, double y,
                    int columns) const;
  [[nodiscard]] double section_height(const TaskSection& section, int columns) const;
  [[nodiscard]] bool draws_last(const TaskSection& section) const;
  void draw_plot(QCPPainter& painter, PlotView view, double x, double y) const {
    painter.save();
    painter.translate(x * kUnit, y * kUnit);
    view.paint(painter);
    painter.restore();
  }

  const ReportContent& content_;
  TextPainter text_{kUnit};
  std::vector<Block> blocks_;
};

double span(int columns) {
  return columns * kColumn + (columns - 1) * kGutter;
}

/// Columns of the page that a section wants: a lone trend is narrow, a maximum has its curve
/// beside.
int columns_of(const TaskSection& section) {
  if (section.series.size() > 1 || has_path(section)) return 3;
  if (section.spec && std::holds_alternative<RestSpec>(section.spec->kind)) return 1;
  return section.last ? 2 : 3;
}

bool PdfReport::draws_last(const TaskSection& section) const {
  return section.last && !(section.spec && std::holds_alternative<RestSpec>(section.spec->kind));
}

constexpr double kTitleHeight = 32.0;
constexpr double kCaptionHeight = 22.0;

double PdfReport::section_height(const TaskSection& section, int columns) const {
  double height = kTitleHeight;
  if (!section.series.empty()) height += kCaptionHeight + kTrendHeight;
  if (draws_last(section) && columns == 3) {
    height += section.series.empty() ? 0.0 : 6.0;
    height += 13.0;
    height += !section.last->problem.empty() ? 12.0
              : has_path(section)            ? kPoseHeight
                                             : kForceHeight;
  }
  const double width = span(columns);
  for (const auto& note : section.notes) height += text_.height(text_of(note), width, kQuiet);
  if (columns == 3 && draws_last(section))
    if (const auto results = text_of(last_trial_results(section)); !results.isEmpty())
      height += 3.0 + text_.height(results, width, kQuiet);
  return height;
}

void PdfReport::draw_section(QCPPainter& painter, const TaskSection& section, double x, double y,
                             int columns) const {
  const double width = span(columns);
  text_.draw(painter, x, y, width, text_of(section.task), kHeading);
  text_.draw(painter, x, y + 15.5, width, text_of(section_subtitle(section)), kQuiet);
  y += kTitleHeight;
  double trend_x = x;
  for (const auto& series : section.series) {
    text_.draw(painter, trend_x, y, kColumn, text_of(series_title(series)), kStrong);
    text_.draw(painter, trend_x, y + 10.5, kColumn, text_of(series_subtitle(series)), kQuiet);
    draw_plot(painter, trend_plot(series, section, content_, QSizeF(kColumn, kTrendHeight), kUnit),
              trend_x, y + kCaptionHeight);
    trend_x += kColumn + kGutter;
  }
  const bool beside = columns == 2 && draws_last(section);
  if (beside && section.last->problem.empty()) {
    text_.draw(painter, trend_x, y, kColumn, "Last trial", kStrong);
    const auto& session = content_.sessions[section.last->session];
    text_.draw(painter, trend_x, y + 10.5, kColumn,
               QString("session %1, trial %2").arg(session.number).arg(section.last->number),
               kQuiet);
    draw_plot(painter, overlay_plot(section, QSizeF(kColumn, kTrendHeight), kUnit), trend_x,
              y + kCaptionHeight);
  }
  if (!section.series.empty()) y += kCaptionHeight + kTrendHeight;
  if (draws_last(section) && columns == 3) {
    if (!section.series.empty()) y += 6.0;
    text_.draw(painter, x, y, width, text_of(last_trial_title(section, content_)), kStrong);
    y += 13.0;
    if (!section.last->problem.empty()) {
      text_.draw(painter, x, y, width, text_of(section.last->problem), kBody);
      y += 12.0;
    } else if (has_path(section)) {
      const double beside_width = span(2);
      draw_plot(painter, overlay_plot(section, QSizeF(beside_width, kPoseHeight), kUnit), x, y);
      draw_plot(painter, path_plot(section, QSizeF(kColumn, kPoseHeight), kUnit),
                x + beside_width + kGutter, y);
      y += kPoseHeight;
    } else {
      draw_plot(painter, overlay_plot(section, QSizeF(width, kForceHeight), kUnit), x, y);
      y += kForceHeight;
    }
    if (const auto results = text_of(last_trial_results(section)); !results.isEmpty())
      y += 3.0 + text_.draw(painter, x, y + 3.0, width, results, kQuiet);
  }
  for (const auto& note : section.notes)
    y += text_.draw(painter, x, y, width, text_of(note), kQuiet);
}

void PdfReport::add_section_row(const std::vector<const TaskSection*>& row) {
  double height = 0.0;
  for (const TaskSection* section : row)
    height = std::max(height, section_height(*section, columns_of(*section)));
  blocks_.push_back({kSectionGap, height, false, [this, row](QCPPainter& painter, double y) {
                       double x = kSide;
                       for (const TaskSection* section : row) {
                         const int columns = columns_of(*section);
                         draw_section(painter, *section, x, y, columns);
                         x += span(columns) + kGutter;
                       }
                     }});
}

void PdfReport::add_sections() {
  if (std::any_of(content_.sections.begin(), content_.sections.end(),
                  [](const auto& section) { return !section.series.empty(); }))
    add_text(text_of(trend_key()), kQuiet, kSectionGap);
  blocks_.back().keep_with_next = true;
  std::vector<const TaskSection*> row;
  int used = 0;
  for (const auto& section : content_.sections) {
    const int columns = columns_of(section);
    if (!row.empty() && used + columns > 3) {
      add_section_row(row);
      row.clear();
      used = 0;
    }
    row.push_back(&section);
    used += columns;
  }
  if (!row.empty()) add_section_row(row);
}

}  // namespace

Result<void> write_pdf(const ReportContent& content, const std::string& path) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  PdfReport(content).write(buffer);
  return write_text(path,
                    std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

}  // namespace isograsp
