// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/marker_table.hpp"

#include <QHeaderView>
#include <QLocale>
#include <cmath>

#include "gui/arm_pages/arm_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kMarkerRow_px = 22;
constexpr int kMarkerColumns = 4;
/// Seen less often than this, a marker is worth a look [%].
constexpr double kSeldom_percent = 90.0;

}  // namespace

MarkerTable::MarkerTable(QWidget* parent) : QTableWidget(0, kMarkerColumns, parent) {
  setObjectName("markers");
  setHorizontalHeaderLabels({tr("Marker"), tr("Seen"), tr("Residual"), tr("State")});
  describe(*this, tr("Segments and markers"),
           tr("How much of the last 10 seconds each was seen, by how much its markers miss it, and "
              "what the newest picture shows (Tab, then arrow keys)"));
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kMarkerColumns - 1, QHeaderView::Stretch);
  horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (const int column : {0, kMarkerColumns - 1})
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(scaled(kMarkerRow_px));
  setShowGrid(false);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setTabKeyNavigation(false);
  take_rest(*this, 4 * kMarkerRow_px);
}

void MarkerTable::show_setup(const session::ArmSetup& setup) {
  segments_.clear();
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    if (setup.has_segment[s]) segments_.push_back(static_cast<ArmSegment>(s));
  markers_ = setup.markers;
  setRowCount(static_cast<int>(segments_.size() + markers_.size()));
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < kMarkerColumns; ++column) {
      const bool words = column == 0 || column == kMarkerColumns - 1;
      auto* one = new QTableWidgetItem;
      one->setTextAlignment((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      setItem(row, column, one);
    }
  int row = 0;
  QFont bold = font();
  bold.setBold(true);
  for (const ArmSegment segment : segments_) {
    item(row, 0)->setFont(bold);
    put(row++, 0, segment_title(segment));
  }
  for (const std::string& marker : markers_)
    put(row++, 0, QStringLiteral("   ") + QString::fromStdString(marker));
}

void MarkerTable::put(int row, int column, const QString& text, bool problem) {
  auto& one = *item(row, column);
  if (one.text() != text) one.setText(text);
  one.setForeground(problem ? look::kFault : look::kText);
}

void MarkerTable::show_arm(const session::ArmSnapshot& now, const MarkerHistory& history) {
  const QLocale locale;
  const auto percent = [&](std::optional<double> seen) {
    return seen ? tr("%1 %").arg(locale.toString(*seen, 'f', 0)) : tr("–");
  };
  const auto seldom = [](std::optional<double> seen) { return seen && *seen < kSeldom_percent; };
  constexpr double kMilli_m = 1000.0;
  int row = 0;
  for (const ArmSegment segment : segments_) {
    const FramePose& pose = now.segment(segment);
    const auto seen = history.segment_percent(segment);
    put(row, 1, percent(seen), seldom(seen));
    // A frame built from points goes through them: there is nothing that it could miss.
    const bool fitted = std::isfinite(pose.residual_m) && pose.residual_m > 0.0;
    put(row, 2,
        fitted ? tr("%1 mm").arg(locale.toString(kMilli_m * pose.residual_m, 'f', 1)) : tr("–"));
    put(row, 3, sight_words(pose.state), !has_pose(pose.state));
    ++row;
  }
  for (std::size_t m = 0; m < markers_.size(); ++m) {
    const bool there = now.markers_W[m].allFinite();
    const auto seen = history.marker_percent(m);
    put(row, 1, percent(seen), seldom(seen));
    put(row, 3, sight_words(there ? FrameState::ok : FrameState::missing), !there);
    ++row;
  }
}

void MarkerTable::show_nothing() {
  setRowCount(0);
  segments_.clear();
  markers_.clear();
}

}  // namespace isograsp::gui
