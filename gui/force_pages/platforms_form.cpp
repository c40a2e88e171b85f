// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/platforms_form.hpp"

#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/device_pages/device_list.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kPlatformRow_px = 26;
constexpr int kMostPlatformRows = 4;
}  // namespace

PlatformsForm::PlatformsForm(SessionPresenter& presenter, const SettingsFile& settings,
                             QWidget* parent)
    : QWidget(parent), presenter_(presenter), settings_(settings) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  for (const Hand hand : kBothHands) {
    auto* list = lists_[hand] = new QListWidget;
    list->setObjectName(hand == Hand::left ? "platforms_left" : "platforms_right");
    list->setTextElideMode(Qt::ElideMiddle);
    const auto name =
        hand == Hand::left ? tr("Platform of the left hand") : tr("Platform of the right hand");
    describe(*list, name, tr("What is present now, and a simulated person (Tab, then arrow keys)"));
    auto* title = new QLabel(hand == Hand::left ? tr("Left platform") : tr("Right platform"));
    title->setBuddy(list);
    column->addWidget(title);
    column->addWidget(list);
    connect(list, &QListWidget::currentRowChanged, this, [this, list, hand](int at) {
      if (at < 0) return;
      presenter_.choices().choose_platform(
          hand, list->item(at)->data(Qt::UserRole).toString().toStdString());
    });
  }
  fill();
  connect(&settings_, &SettingsFile::changed, this, &PlatformsForm::fill);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &PlatformsForm::refresh);
  refresh();
}

void PlatformsForm::fill() {
  const auto& library = presenter_.state().config.library;
  for (const Hand hand : kBothHands) {
    QListWidget& list = *lists_[hand];
    const QSignalBlocker quiet(&list);
    filled_[hand] = presenter_.state().choices.platforms[hand];
    list.clear();
    for (const DeviceChoice& choice :
         list_platforms(filled_[hand], settings_.now().devices, library)) {
      auto* item = new QListWidgetItem(QString::fromStdString(choice.words), &list);
      item->setData(Qt::UserRole, QString::fromStdString(choice.uri));
      item->setToolTip(QString::fromStdString(choice.words));
      item->setSizeHint({0, scaled(kPlatformRow_px)});
    }
    list.setCurrentRow(-1);
    list.setFixedHeight(scaled(kPlatformRow_px) * std::clamp(list.count(), 2, kMostPlatformRows) +
                        6);
  }
}

void PlatformsForm::refresh() {
  const SessionState& state = presenter_.state();
  const auto& view = presenter_.flow().view();
  show_part(*this, measures_both(state) && !state.session_open());
  for (const Hand hand : kBothHands) {
    QListWidget& list = *lists_[hand];
    const auto chosen = QString::fromStdString(state.choices.platforms[hand]);
    const QSignalBlocker quiet(&list);
    int row = -1;
    for (int k = 0; k < list.count(); ++k)
      if (!chosen.isEmpty() && list.item(k)->data(Qt::UserRole).toString() == chosen) row = k;
    if (list.currentRow() != row) list.setCurrentRow(row);
    list.setEnabled(view.may_change_device);
    mark_choice(list, view.press == NextPress::device && chosen.isEmpty());
  }
}

}  // namespace isograsp::gui
