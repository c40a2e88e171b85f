// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/fault_card.hpp"

#include <QHBoxLayout>
#include <QPainter>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kFaultEdge_px = 6;  // the red one at the left
// Round the card, as the style sheet says.
constexpr int kBeside_px = 16;
constexpr int kAbove_px = 8;
}  // namespace

FaultCard::FaultCard(SessionPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setObjectName("fault_card");
  const auto line = [](const char* name, const char* role) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
  };
  happened_ = line("fault_happened", "title");
  safe_ = line("fault_safe", "");
  remedy_ = line("fault_remedy", "");
  again_ = new QPushButton(tr("Try again"));
  again_->setObjectName("try_again");
  describe(*again_, tr("Try again"), tr("What has failed (F8)"));
  auto* said = new QVBoxLayout;
  said->setSpacing(2);
  for (QLabel* label : {happened_, safe_, remedy_}) said->addWidget(label);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kBeside_px + kFaultEdge_px, 8, 12, 8);
  row->setSpacing(16);
  row->addLayout(said, 1);
  row->addWidget(again_, 0, Qt::AlignVCenter);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  connect(again_, &QPushButton::clicked, &presenter_,
          [this] { presenter_.connecting().try_again(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &FaultCard::refresh);
  hide();
  refresh();
}

void FaultCard::refresh() {
  const FlowView& view = presenter_.flow().view();
  show_part(*this, view.fault.has_value());
  mark_next(*again_, view.press == NextPress::again);
  if (!view.fault) return;
  const auto say = [](QLabel& label, const std::string& words) {
    label.setText(QString::fromStdString(words));
    show_part(label, !words.empty());
  };
  say(*happened_, view.fault->happened);
  say(*safe_, view.fault->safe);
  say(*remedy_, view.fault->remedy);
  show_part(*again_, view.may_try_again);
}

/// The card as every other one, and at its left what says that it is a fault.
void FaultCard::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look::kFault);
  painter.drawRoundedRect(
      QRectF(kBeside_px + 4, kAbove_px + 8, kFaultEdge_px, height() - kAbove_px - 16),
      kFaultEdge_px / 2.0, kFaultEdge_px / 2.0);
}

}  // namespace isograsp::gui
