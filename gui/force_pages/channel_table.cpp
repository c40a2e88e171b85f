// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/channel_table.hpp"

#include <QHeaderView>
#include <QLocale>
#include <array>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kForces = 3;
constexpr int kChannels = 6;
constexpr int kColumns = kChannels + 1;  // and friction
constexpr double kPercentOfMaximum = 100.0;
constexpr int kChannelRow_px = 26;
constexpr double kMilli = 1000.0;

}  // namespace

ChannelTable::ChannelTable(QWidget* parent)
    : QTableWidget(static_cast<int>(kFingerCount), kColumns, parent) {
  setObjectName("channels");
  describe(
      *this, tr("All channels"),
      tr("Force and moment of each finger in its contact frame: z into the support, after the "
         "zero; how much of the friction on the virtual object is used (Tab, then arrow keys)"));
  setHorizontalHeaderLabels({tr("Fx, N"), tr("Fy, N"), tr("Fz, N"), tr("Tx, mN m"), tr("Ty, mN m"),
                             tr("Tz, mN m"), tr("Friction")});
  QStringList fingers;
  for (const Finger finger : kFingers) fingers += finger_title(finger);
  setVerticalHeaderLabels(fingers);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  verticalHeader()->setDefaultSectionSize(scaled(kChannelRow_px));
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  constexpr int kHeader_px = 30;
  setFixedHeight(scaled(kHeader_px) + static_cast<int>(kFingerCount) * scaled(kChannelRow_px) + 4);
  for (int row = 0; row < rowCount(); ++row)
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, column, item);
    }
}

void ChannelTable::show_channels(const session::Snapshot& snapshot) {
  const QLocale locale;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Wrench& wrench = snapshot.forces.wrench_C[f];
    const bool missing = (snapshot.forces.flags[f] & bit(SampleFlag::missing)) != 0;
    for (int column = 0; column < kChannels; ++column) {
      const bool force = column < kForces;
      const double value = force ? wrench.force[column] : kMilli * wrench.torque[column - kForces];
      item(static_cast<int>(f), column)
          ->setText(snapshot.frames == 0 || missing ? tr("–")
                                                    : locale.toString(value, 'f', force ? 2 : 0));
    }
    const bool touches = snapshot.has_object && snapshot.grasp.contact[f];
    item(static_cast<int>(f), kChannels)
        ->setText(!touches ? tr("–")
                  : snapshot.grasp.slip[f]
                      ? tr("slips")
                      : tr("%1 %").arg(locale.toString(
                            kPercentOfMaximum * snapshot.grasp.utilisation[f], 'f', 0)));
  }
}

}  // namespace isograsp::gui
