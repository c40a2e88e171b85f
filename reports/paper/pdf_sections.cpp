// SPDX-License-Identifier: GPL-3.0-or-later
// The tasks of a PDF report: their measures over the sessions and the last trial.
#include <algorithm>
#include <span>
#include <utility>

#include "reports/findings/report_text.hpp"
#include "reports/paper/pdf_content.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports::pdf {

namespace {

constexpr double kGutter = 14.0;
constexpr std::size_t kColumns = 3;
constexpr double kColumn = (kWidth - 2.0 * kGutter) / 3.0;
constexpr double kTitleHeight = 32.0;
constexpr double kCaptionHeight = 20.5;  // below the title
constexpr double kTrendTop = 9.5;        // of the trend in words, below the title
constexpr double kTrendGap = 2.5;
constexpr double kTrendHeight = 88.0;
constexpr double kForceHeight = 118.0;
constexpr double kPoseHeight = 180.0;

/// Drawn over the whole width, three axes below each other.
bool has_three_axes(const TaskSection& section) {
  return moves_object(section) || (is_of_arm(section) && section.spec->kind->curve == nullptr);
}
constexpr double kFingersHeight = 170.0;
constexpr double kExtremeHeight = 100.0;
const TextStyle kTrend{6.6, false, Palette::quiet()};

double span(int columns) {
  return columns * kColumn + (columns - 1) * kGutter;
}

bool is_rest(const TaskSection& section) {
  return section.spec && section.spec->kind->rests;
}

/// Columns of the page that a section wants: a lone trend is narrow, a maximum has its curve
/// beside.
int columns_of(const TaskSection& section) {
  if (section.series.size() > 1 || has_path(section)) return 3;
  if (is_rest(section)) return 1;
  return section.last ? 2 : 3;
}

/// One task: says what stands where, from `x` and from the top of its block.
class SectionLayout {
 public:
  SectionLayout(const ReportContent& content, const TaskSection& section, double x,
                const Speaker& say)
      : content_(content), section_(section), say_(say), x_(x), columns_(columns_of(section)) {
    add_text(x_, 0.0, width(), said(Known{section_.task}), kHeading);
    add_text(x_, 15.5, width(), said(section_subtitle(section_)), kQuiet);
    height_ = kTitleHeight;
    add_trends();
    if (section_.last && !is_rest(section_) && columns_ == 3) add_last_trial();
    for (const auto& note : section_.notes)
      height_ += add_text(x_, height_, width(), said(note), kQuiet);
  }

  [[nodiscard]] double width() const { return span(columns_); }
  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] std::vector<Draw> take() { return std::move(parts_); }

 private:
  [[nodiscard]] QString said(const Text& text) const { return qt(say_(text)); }

  /// Returns the height of the text.
  double add_text(double x, double top, double width, const QString& text, const TextStyle& style) {
    parts_.push_back([=](QCPPainter& painter, double y) {
      kText.draw(painter, x, y + top, width, text, style);
    });
    return kText.height(text, width, style);
  }

  /// The plot is made when it is painted: plots of all tasks at once would take much memory.
  template <class MakePlot>
  void add_plot(double x, double top, MakePlot make) {
    parts_.push_back([x, top, make](QCPPainter& painter, double y) {
      painter.save();
      painter.translate(x * kUnit, (y + top) * kUnit);
      make().paint(painter);
      painter.restore();
    });
  }

  /// Height of the largest title of a row.
  [[nodiscard]] double title_height(std::span<const MeasureSeries> row) const {
    double height = 10.5;
    for (const auto& series : row)
      height = std::max(height, kText.height(said(series_title(series)), kColumn, kStrong));
    return height;
  }

  /// Below the titles of a row: the unit and the trend, which may take several lines.
  [[nodiscard]] double caption_height(std::span<const MeasureSeries> row) const {
    double height = kCaptionHeight;
    for (const auto& series : row)
      if (!series.trend.empty())
        height = std::max(
            height, kTrendTop + kTrendGap + kText.height(said(series.trend), kColumn, kTrend));
    return height;
  }

  void add_caption(double x, double title_height, const Text& title, const Text& below,
                   const Text& trend = {}) {
    add_text(x, height_, kColumn, said(title), kStrong);
    add_text(x, height_ + title_height, kColumn, said(below), kQuiet);
    if (!trend.empty())
      add_text(x, height_ + title_height + kTrendTop, kColumn, said(trend), kTrend);
  }

  /// Three beside each other, in as many rows as it takes.
  void add_trends() {
    const std::span all(section_.series);
    for (std::size_t first = 0; first < all.size(); first += kColumns)
      add_trend_row(all.subspan(first, std::min(kColumns, all.size() - first)));
  }

  void add_trend_row(std::span<const MeasureSeries> row) {
    const double above = title_height(row);
    const double top = height_ + above + caption_height(row);
    constexpr QSizeF kSize(kColumn, kTrendHeight);
    double x = x_;
    for (const auto& series : row) {
      add_caption(x, above, series_title(series), series_subtitle(series), series.trend);
      add_plot(x, top,
               [this_section = &section_, content = &content_, one = &series,
                language = &say_.language(), kSize] {
                 return trend_plot(*one, *this_section, *content, kSize, kUnit, *language);
               });
      x += kColumn + kGutter;
    }
    if (columns_ == 2 && section_.last && section_.last->problem.empty()) {
      const auto& session = content_.sessions[section_.last->session];
      add_caption(x, above, "Last trial"_text,
                  "session %1, trial %2"_text(session.number, section_.last->number));
      add_overlay(x, top, kSize);
    }
    height_ = top + kTrendHeight;
  }

  void add_overlay(double x, double top, QSizeF size) {
    add_plot(x, top, [section = &section_, size, language = &say_.language()] {
      return overlay_plot(*section, *section->last, size, kUnit, *language);
    });
  }

  void add_last_trial() {
    if (!section_.series.empty()) height_ += 6.0;
    add_text(x_, height_, width(), said(last_trial_title(section_, content_)), kStrong);
    height_ += 13.0;
    if (!section_.last->problem.empty()) {
      add_text(x_, height_, width(), said(section_.last->problem), kBody);
      height_ += 12.0;
    } else if (has_path(section_)) {
      const double beside = span(2);
      add_overlay(x_, height_, QSizeF(beside, kPoseHeight));
      add_plot(x_ + beside + kGutter, height_, [section = &section_, language = &say_.language()] {
        return path_plot(*section, QSizeF(kColumn, kPoseHeight), kUnit, *language);
      });
      height_ += kPoseHeight;
      if (has_fingers(section_)) add_fingers(beside);
    } else {
      const double height = has_three_axes(section_) ? kPoseHeight : kForceHeight;
      add_overlay(x_, height_, QSizeF(width(), height));
      height_ += height;
    }
    if (const auto results = said(last_trial_results(section_)); !results.isEmpty())
      height_ += 3.0 + add_text(x_, height_ + 3.0, width(), results, kQuiet);
    add_extremes();
  }

  /// Below the way of the object, along the same time.
  void add_fingers(double width) {
    add_plot(x_, height_, [section = &section_, width, language = &say_.language()] {
      return fingers_plot(*section, QSizeF(width, kFingersHeight), kUnit, *language);
    });
    add_text(x_ + width + kGutter, height_ + 14.0, kColumn, said(fingers_note()), kQuiet);
    height_ += kFingersHeight;
  }

  void add_extremes() {
    if (!section_.best || !section_.worst) return;
    const double half = (width() - kGutter) / 2.0;
    height_ += 8.0;
    double x = x_;
    for (const auto* trial : {&*section_.best, &*section_.worst}) {
      const bool best = trial == &*section_.best;
      add_text(x, height_, half, said(extreme_title(section_, *trial, best, content_)), kStrong);
      if (trial->problem.empty())
        add_plot(
            x, height_ + 12.0, [section = &section_, trial, half, language = &say_.language()] {
              return overlay_plot(*section, *trial, QSizeF(half, kExtremeHeight), kUnit, *language);
            });
      else
        add_text(x, height_ + 12.0, half, said(trial->problem), kBody);
      x += half + kGutter;
    }
    height_ += 12.0 + kExtremeHeight;
  }

  const ReportContent& content_;
  const TaskSection& section_;
  const Speaker& say_;
  double x_;
  int columns_;
  double height_ = 0.0;
  std::vector<Draw> parts_;
};

/// Tasks that stand side by side.
Block section_row(const ReportContent& content, const std::vector<const TaskSection*>& row,
                  const Speaker& say) {
  Block block{kSectionGap, 0.0, false, {}};
  double x = kSide;
  for (const TaskSection* section : row) {
    SectionLayout layout(content, *section, x, say);
    block.height = std::max(block.height, layout.height());
    x += layout.width() + kGutter;
    for (auto& part : layout.take()) block.parts.push_back(std::move(part));
  }
  return block;
}

}  // namespace

void add_sections(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say) {
  if (std::any_of(content.sections.begin(), content.sections.end(),
                  [](const auto& section) { return !section.series.empty(); })) {
    blocks.push_back(text_block(qt(say(trend_key(content))), kQuiet, kSectionGap));
    blocks.back().keep_with_next = true;
  }
  std::vector<const TaskSection*> row;
  int used = 0;
  const auto end_row = [&] {
    if (row.empty()) return;
    blocks.push_back(section_row(content, row, say));
    for (const TaskSection* section : row)
      if (const auto panel = postures_panel(*section, say.language())) add_panels(blocks, {*panel});
    row.clear();
    used = 0;
  };
  for (const auto& section : content.sections) {
    const int columns = columns_of(section);
    if (used + columns > 3) end_row();
    row.push_back(&section);
    used += columns;
  }
  end_row();
}

}  // namespace isograsp::reports::pdf
