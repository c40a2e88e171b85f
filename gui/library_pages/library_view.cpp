// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/library_view.hpp"

#include <QHeaderView>
#include <QPainter>
#include <QPainterPath>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kPicture_px = 190;
constexpr double kFingerArrow_px = 26.0;  // of a finger

/// 1, 2 or 5 times a power of ten: at most `most` steps over `range`.
double round_step(double range, int most) {
  if (!(range > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(range / most)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range / (factor * power) <= most) return factor * power;
  return 10.0 * power;
}

QString tick_words(double value) {
  constexpr int kDigits = 4;
  return QString::number(value, 'g', kDigits);
}

/// "2:05" of minutes and seconds.
QString clock_words(double duration_s) {
  constexpr int kMinute_s = 60;
  const int seconds = static_cast<int>(std::ceil(duration_s - 1e-9));
  return QStringLiteral("%1:%2")
      .arg(seconds / kMinute_s)
      .arg(seconds % kMinute_s, 2, 10, QLatin1Char('0'));
}

void set_ink(QPainter& painter, const QColor& color, double width = 1.0,
             Qt::PenStyle style = Qt::SolidLine) {
  painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
}

}  // namespace

TargetCurve::TargetCurve(QWidget* parent) : QWidget(parent) {
  setFixedHeight(scaled(kPicture_px));
}

void TargetCurve::show_curve(const LibraryPreview::Curve& curve) {
  curve_ = curve;
  setAccessibleName(tr("%1 over time").arg(curve.axis));
  setToolTip(tr("What is asked of the patient, from begin to end; dashed: not on the screen"));
  update();
}

void TargetCurve::paintEvent(QPaintEvent*) {
  if (curve_.values.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Axes axes = this->axes();
  draw_axes(painter, axes);
  draw_curve(painter, axes);
}

TargetCurve::Axes TargetCurve::axes() const {
  const auto metrics = fontMetrics();
  const int left_px = scaled(40);
  double least = 0.0;
  double most = 0.0;
  for (const double value : curve_.values)
    if (!std::isnan(value)) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  if (!(most > least)) most = least + 1.0;
  most += 0.06 * (most - least);
  return {QRectF(left_px, metrics.height() + 8, width() - left_px - 10,
                 height() - 2.0 * metrics.height() - 18),
          least, most, curve_.period_s * static_cast<double>(curve_.values.size())};
}

void TargetCurve::draw_axes(QPainter& painter, const Axes& on) const {
  const auto metrics = fontMetrics();
  const QRectF& area = on.area;
  painter.setPen(look::kQuietText);
  painter.drawText(QPointF(2, metrics.ascent()), curve_.axis);
  const double step = round_step(on.most - on.least, 5);
  for (double tick = std::ceil(on.least / step) * step; tick <= on.most; tick += step) {
    set_ink(painter, look::kGrid);
    painter.drawLine(QPointF(area.left(), on.y(tick)), QPointF(area.right(), on.y(tick)));
    painter.setPen(look::kQuietText);
    painter.drawText(QRectF(0, on.y(tick) - scaled(10), area.left() - 6, scaled(20)),
                     Qt::AlignRight | Qt::AlignVCenter,
                     tick_words(std::abs(tick) < 1e-9 * step ? 0.0 : tick));
  }
  const double step_s = round_step(on.end_s, side_by_side() == QBoxLayout::LeftToRight ? 6 : 5);
  for (double tick_s = 0.0; tick_s <= on.end_s; tick_s += step_s)
    painter.drawText(
        QRectF(on.x(tick_s) - area.left(), area.bottom() + 4, 2 * area.left(), metrics.height()),
        Qt::AlignHCenter, tr("%1 s").arg(tick_words(tick_s)));
  set_ink(painter, look::kLine);
  painter.drawLine(QPointF(area.left(), on.y(0.0)), QPointF(area.right(), on.y(0.0)));
}

/// One stroke for each stretch that is seen, or not seen, without a gap.
void TargetCurve::draw_curve(QPainter& painter, const Axes& on) const {
  QPainterPath path;
  const auto stroke = [&](bool hidden) {
    set_ink(painter, hidden ? look::kQuietText : look::kAccent, 1.8,
            hidden ? Qt::DashLine : Qt::SolidLine);
    painter.drawPath(path);
    path = {};
  };
  for (std::size_t k = 0; k < curve_.values.size(); ++k) {
    const double value = curve_.values[k];
    if (std::isnan(value)) {
      if (!path.isEmpty()) stroke(curve_.hidden[k - 1]);
      continue;
    }
    const QPointF place(on.x(curve_.period_s * static_cast<double>(k)), on.y(value));
    if (path.elementCount() == 0)
      path.moveTo(place);
    else
      path.lineTo(place);
    if (k + 1 < curve_.values.size() && curve_.hidden[k] != curve_.hidden[k + 1]) {
      stroke(curve_.hidden[k]);
      path.moveTo(place);
    }
  }
  if (!path.isEmpty()) stroke(curve_.hidden.back());
}

ObjectSketch::ObjectSketch(QWidget* parent) : QWidget(parent) {
  setFixedHeight(scaled(kPicture_px));
}

void ObjectSketch::show_sketch(const LibraryPreview::Sketch& sketch) {
  sketch_ = sketch;
  setAccessibleName(tr("The object in the plane of x and y, with %n target(s)", "",
                       static_cast<int>(sketch.targets.size())));
  setToolTip(tr(
      "x to the right, y up; arrows: fingers or hands, and where they press; outlines: targets in "
      "their order, dashed: where an object appears"));
  update();
}

QPolygonF ObjectSketch::placed(const LibraryPreview::Sketch::Target& target) const {
  QTransform turn;
  turn.translate(target.place.x(), target.place.y());
  turn.rotateRadians(target.angle_rad);
  return turn.map(sketch_.outline);
}

ObjectSketch::Plane ObjectSketch::plane() const {
  QRectF all = sketch_.outline.boundingRect();
  for (const auto& target : sketch_.targets) all = all.united(placed(target).boundingRect());
  const double around_m = 0.35 * std::max(sketch_.outline.boundingRect().width(),
                                          sketch_.outline.boundingRect().height());
  all.adjust(-around_m, -around_m, around_m, around_m);
  const double foot_px = scaled(22);  // for the scale
  return {all.center(),
          {width() / 2.0, (height() - foot_px) / 2.0},
          std::min(width() / all.width(), (height() - foot_px) / all.height())};
}

void ObjectSketch::paintEvent(QPaintEvent*) {
  if (sketch_.outline.isEmpty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Plane on = plane();
  draw_targets(painter, on);
  if (sketch_.targets.empty()) {
    painter.setBrush(look::kTrack);
    set_ink(painter, look::kText, 1.4);
    painter.drawPolygon(on.shape(sketch_.outline));
    draw_arrows(painter, on);
    draw_letters(painter, on);
  }
  const double bar_m = round_step(0.35 * width() / on.px_per_m, 2);
  const QPointF begin(12, height() - 6);
  set_ink(painter, look::kQuietText, 1.5);
  painter.drawLine(begin, begin + QPointF(on.px_per_m * bar_m, 0));
  painter.drawText(begin + QPointF(0, -5), tr("%1 mm").arg(tick_words(1000.0 * bar_m)));
}

void ObjectSketch::draw_targets(QPainter& painter, const Plane& on) const {
  int number = 0;
  painter.setBrush(Qt::NoBrush);
  for (const auto& target : sketch_.targets) {
    set_ink(painter, target.start ? look::kQuietText : look::kAccent, 1.4,
            target.start ? Qt::DashLine : Qt::SolidLine);
    painter.drawPolygon(on.shape(placed(target)));
    if (!target.start)
      painter.drawText(QRectF(on.at(target.place) - QPointF(scaled(20), scaled(20)),
                              QSizeF(scaled(40), scaled(40))),
                       Qt::AlignCenter, QString::number(++number));
  }
}

/// Fingers, and where they press.
void ObjectSketch::draw_arrows(QPainter& painter, const Plane& on) const {
  for (const auto& touch : sketch_.touches) {
    const QColor color = touch.finger ? look::kFingers[index_of(*touch.finger)] : look::kText;
    const QPointF tip = on.at(touch.place);
    const QPointF along(touch.inward.x(), -touch.inward.y());
    constexpr double kHead_px = 6.0;
    const QPointF across(-along.y(), along.x());
    set_ink(painter, color, 2.4);
    painter.setBrush(color);
    painter.drawLine(tip - kFingerArrow_px * along, tip - kHead_px * along);
    painter.drawPolygon(polygon({tip, tip - 1.6 * kHead_px * along + 0.7 * kHead_px * across,
                                 tip - 1.6 * kHead_px * along - 0.7 * kHead_px * across}));
  }
}

/// Fingers at the same height share a place: their letters stand side by side.
void ObjectSketch::draw_letters(QPainter& painter, const Plane& on) const {
  std::vector<std::pair<QPointF, QString>> letters;
  for (const auto& touch : sketch_.touches) {
    const QPointF along(touch.inward.x(), -touch.inward.y());
    const QPointF place = on.at(touch.place) - (kFingerArrow_px + scaled(12)) * along;
    const QString& letter = touch.letters;
    const auto same = std::find_if(letters.begin(), letters.end(), [&](const auto& one) {
      return (one.first - place).manhattanLength() < 12.0;
    });
    if (same == letters.end())
      letters.emplace_back(place, letter);
    else
      same->second += QStringLiteral(" ") + letter;
  }
  painter.setPen(look::kText);
  for (const auto& [place, letter] : letters)
    painter.drawText(
        QRectF(place - QPointF(scaled(30), scaled(12)), QSizeF(scaled(60), scaled(24))),
        Qt::AlignCenter, letter);
}

LibraryView::LibraryView(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Preview"));
  title_->setObjectName("library_preview_title");
  title_->setWordWrap(true);
  outdated_ = new QLabel(tr("Of the last text that could be read."));
  outdated_->setProperty("role", "quiet");
  outdated_->hide();
  curve_ = new TargetCurve;
  curve_->setObjectName("library_curve");
  curve_->hide();
  sketch_ = new ObjectSketch;
  sketch_->setObjectName("library_sketch");
  sketch_->hide();
  patches_ = new PatchSketch;
  patches_->setObjectName("library_patches");
  patches_->hide();
  steps_ = new QTableWidget(0, 3);
  steps_->setObjectName("library_steps");
  steps_->setHorizontalHeaderLabels({tr("Step"), tr("Usual"), tr("At most")});
  steps_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int column = 1; column < 3; ++column)
    steps_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  for (int column = 0; column < 3; ++column)
    steps_->horizontalHeaderItem(column)->setTextAlignment(
        (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  steps_->verticalHeader()->hide();
  steps_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  steps_->setShowGrid(false);
  steps_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  steps_->setSelectionBehavior(QAbstractItemView::SelectRows);
  steps_->setTabKeyNavigation(false);
  describe(
      *steps_, tr("Steps of the protocol with their durations"),
      tr("What it consists of and how long each step takes, in minutes and seconds (Tab, arrow "
         "keys)"));
  take_rest(*steps_, 120);
  steps_->hide();
  facts_ = new QLabel;
  facts_->setObjectName("library_facts");
  facts_->setWordWrap(true);
  facts_->setTextFormat(Qt::RichText);
  facts_->setAlignment(Qt::AlignTop);
  auto* scroll = new QScrollArea;
  scroll->setWidget(facts_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setObjectName("library_facts_area");
  scroll->viewport()->setAutoFillBackground(false);
  facts_->setAutoFillBackground(false);
  describe(*scroll, tr("What it is, in words"),
           tr("Durations, what must be measured before, the plan of an object (Tab, arrow keys)"));
  column_->addWidget(outdated_);
  column_->addWidget(curve_);
  column_->addWidget(sketch_);
  column_->addWidget(patches_);
  column_->addWidget(steps_, 4);
  column_->addWidget(scroll, 1);
}

void LibraryView::show_preview(const LibraryPreview& preview) {
  title_->setText(preview.title.isEmpty() ? tr("Preview") : preview.title);
  curve_->setVisible(preview.curve.has_value());
  if (preview.curve) curve_->show_curve(*preview.curve);
  sketch_->setVisible(preview.sketch.has_value());
  if (preview.sketch) sketch_->show_sketch(*preview.sketch);
  patches_->setVisible(!preview.patches.empty());
  patches_->show_patches(preview.patches);
  steps_->setVisible(!preview.steps.empty());
  fill_steps(preview.steps);
  QString words;
  for (const auto& fact : preview.facts)
    words +=
        QStringLiteral("<p style=\"margin:0 0 7px 0\"><span style=\"color:%1\">%2</span><br>%3</p>")
            .arg(look::kQuietText.name(), fact.label.toHtmlEscaped(),
                 fact.words.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>")));
  facts_->setText(words);
}

void LibraryView::fill_steps(const std::vector<LibraryPreview::Step>& steps) {
  steps_->setRowCount(static_cast<int>(steps.size()));
  int row = 0;
  for (const auto& step : steps) {
    const std::array<QString, 3> texts{step.words, clock_words(step.duration.nominal_s),
                                       clock_words(step.duration.worst_s)};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      item->setToolTip(step.words);
      steps_->setItem(row, column, item);
    }
    ++row;
  }
}

void LibraryView::show_outdated(bool outdated) {
  outdated_->setVisible(outdated);
}

}  // namespace isograsp::gui
