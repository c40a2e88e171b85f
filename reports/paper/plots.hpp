// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of a report, painted as vectors into PDF or SVG. One PlotView hides the plot library.
// Sizes are in points (1/72 inch); `unit` is the number of device pixels per point: fonts and pens
// are set in pixels, so that no device multiplies them by its resolution.
#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <memory>
#include <vector>

#include "reports/findings/report_content.hpp"
#include "reports/findings/wording.hpp"
#include "reports/paper/palette.hpp"

class QCustomPlot;
class QCPPainter;
class QCPAxisRect;

namespace isograsp::reports {

/// The typeface of reports, sized in pixels.
[[nodiscard]] QFont report_font(double pixels, bool bold);

class PlotView {
 public:
  /// @param size      [points]
  /// @param language  of the numbers at the axes and of the words
  PlotView(QSizeF size, double unit, const Language& language);
  ~PlotView();
  PlotView(PlotView&&) noexcept;

  /// A word about one kind of line or mark; stands above the plot in the order of the calls.
  enum class Mark : std::uint8_t { line, dashed, dotted, band, ring, square };
  void explain(Mark mark, const QColor& color, const Text& text);
  /// In the language of the plot.
  [[nodiscard]] QString said(const Text& text) const;
  [[nodiscard]] QString said(const Number& number) const;
  /// Paints with the top left corner at the painter's origin.
  void paint(QCPPainter& painter);
  /// Axes whose inner rectangle is `inner` [points]; several stand below each other, top first.
  QCPAxisRect& add_axes(QRectF inner);
  [[nodiscard]] QSizeF size() const noexcept { return size_; }
  [[nodiscard]] QCustomPlot& plot() noexcept { return *plot_; }
  [[nodiscard]] double px(double points) const noexcept { return points * unit_; }

 private:
  QSizeF size_;
  double unit_;
  Speaker say_;
  struct Key {
    Mark mark;
    QColor color;
    QString text;
  };
  std::vector<Key> keys_;
  double key_left_ = 34.0;  ///< where the key begins: above the axes
  double bottom_ = 0.0;     ///< of the axes added so far
  std::unique_ptr<QCustomPlot> plot_;
};

/// Values that do not differ from the baseline by more than measurement error; unit of the measure.
struct ErrorBand {
  double low = 0.0;
  double high = 0.0;
};
/// That of the baseline first. Measures that are best near zero have a second one, its mirror
/// image, unless the two meet at zero. Empty: not known.
[[nodiscard]] std::vector<ErrorBand> error_bands(const MeasureSeries& series);

/// One measure over the sessions: mean per session, single trials as dots, first day hollow; where
/// its change is judged, the band that is not larger than measurement error.
[[nodiscard]] PlotView trend_plot(const MeasureSeries& series, const TaskSection& section,
                                  const ReportContent& content, QSizeF size, double unit,
                                  const Language& language = kEnglish);

/// A trial of the section over its target: force against time, or x, y and angle against time.
/// @pre the trial holds signals
[[nodiscard]] PlotView overlay_plot(const TaskSection& section, const DrawnTrial& trial,
                                    QSizeF size, double unit, const Language& language = kEnglish);

/// True if the task is one of an arm seen by markers.
[[nodiscard]] bool is_of_arm(const TaskSection& section);
/// Distance and angle from object to reference and the turns of the links against time, or the
/// angle that the task is about. overlay_plot() draws it for such a section. @pre
/// is_of_arm(section)
[[nodiscard]] PlotView arm_plot(const TaskSection& section, const DrawnTrial& trial, QSizeF size,
                                double unit, const Language& language = kEnglish);

/// True if the task is one of both hands, each on a platform.
[[nodiscard]] bool is_of_two_hands(const TaskSection& section);
/// The force of each hand, and of both where the sum has a target, against time. Where both lift
/// an object: the height of its ends, its tilt, and how much of it each hand raises; where they
/// carry one: its place and their squeeze. overlay_plot() draws it for such a section.
/// @pre is_of_two_hands(section)
[[nodiscard]] PlotView hands_plot(const TaskSection& section, const DrawnTrial& trial, QSizeF size,
                                  double unit, const Language& language = kEnglish);
/// True if both hands moved an object together in the last session.
[[nodiscard]] bool moves_object(const TaskSection& section);
/// True if both hands lift an object in this trial, or carry one.
[[nodiscard]] bool lifts_object(const Signals& curves);
[[nodiscard]] bool carries_object(const Signals& curves);

/// Over the sessions, of the affected hand: its share of the force beside its share of what both
/// can do; its lag behind the other. @pre !content.both_hands.shared.empty()
enum class HandsCourse : std::uint8_t { share, lag };
[[nodiscard]] PlotView hands_course_plot(const ReportContent& content, HandsCourse shown,
                                         QSizeF size, double unit,
                                         const Language& language = kEnglish);

/// Fewer movements are drawn without a band.
inline constexpr int kLeastBandMovements = 3;
/// Postures whose movements in the last session make a band (kLeastBandMovements), those with most
/// of them first. Empty: another kind of task.
[[nodiscard]] std::vector<std::string> postures_with_band(const TaskSection& section);
/// How far forearm, wrist and fingers had come on their turns in the movements of the last session
/// to one posture: mean and standard deviation from where the object began to turn (Kurillo et al.,
/// isotonic part, figure of the relative rotations). @pre the posture is in postures_with_band()
[[nodiscard]] PlotView turns_plot(const TaskSection& section, const std::string& posture,
                                  QSizeF size, double unit, const Language& language = kEnglish);
/// When each link began to turn and which share of its turn it had when the forearm had 63 % of its
/// own: a dot for each movement of the last session, a line at their median; of shares the band of
/// healthy people where there are enough of them. @pre section.poses
[[nodiscard]] PlotView sharing_plot(const TaskSection& section, QSizeF size, double unit,
                                    const Language& language = kEnglish);

/// True if finger forces of the last session are there.
[[nodiscard]] bool has_fingers(const TaskSection& section);
/// Normal and tangential forces of the fingers against time, in the contact frames: to be read with
/// the way of the object below (Kurillo et al., figures 7 and 8). @pre has_fingers(section)
[[nodiscard]] PlotView fingers_plot(const TaskSection& section, QSizeF size, double unit,
                                    const Language& language = kEnglish);

/// True if the last session moved an object in the plane.
[[nodiscard]] bool has_path(const TaskSection& section);
/// The way of the object in the plane, with numbered targets. @pre has_path(section)
[[nodiscard]] PlotView path_plot(const TaskSection& section, QSizeF size, double unit,
                                 const Language& language = kEnglish);

/// One digit of all of them. `most_N`: the radius of the outer ring. Needs a QApplication.
[[nodiscard]] PlotView compass_plot(const std::vector<Compass>& compasses, Finger finger,
                                    double most_N, QSizeF size, double unit,
                                    const Language& language = kEnglish);
/// What each plot shows, in one sentence, for people who do not see it.
[[nodiscard]] Text describe_overlay(const TaskSection& section);

}  // namespace isograsp::reports
