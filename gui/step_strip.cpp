// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/step_strip.hpp"

#include <QHBoxLayout>
#include <QStyle>
#include <QVariant>

namespace isograsp {

namespace {
QString title(std::size_t step) {
  switch (static_cast<Step>(step)) {
    case Step::patient: return StepStrip::tr("Patient");
    case Step::hand: return StepStrip::tr("Hand");
    case Step::device: return StepStrip::tr("Connect");
    case Step::zero: return StepStrip::tr("Zero, empty");
    case Step::rest: return StepStrip::tr("Resting force");
    case Step::maximum: return StepStrip::tr("Maximum");
    case Step::task: return StepStrip::tr("Task");
  }
  return {};
}
}  // namespace

StepStrip::StepStrip(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (std::size_t i = 0; i < kStepCount; ++i) {
    if (i > 0) {
      auto* arrow = new QLabel(QStringLiteral("›"));
      arrow->setProperty("role", "quiet");
      row->addWidget(arrow);
    }
    labels_[i] = new QLabel;
    row->addWidget(labels_[i]);
  }
  row->addStretch(1);
  shown_.fill(StepState::done);
  show_steps({});
}

void StepStrip::show_steps(const std::array<StepState, kStepCount>& steps) {
  for (std::size_t i = 0; i < kStepCount; ++i) {
    if (steps[i] == shown_[i]) continue;
    shown_[i] = steps[i];
    QLabel& label = *labels_[i];
    const bool done = steps[i] == StepState::done;
    const bool next = steps[i] == StepState::next;
    label.setText(done ? tr("✓ %1").arg(title(i)) : tr("%1  %2").arg(i + 1).arg(title(i)));
    label.setProperty("step", done ? "done" : next ? "next" : "open");
    label.setAccessibleName(tr("Step %1 of %2, %3: %4")
                                .arg(i + 1)
                                .arg(kStepCount)
                                .arg(title(i), done   ? tr("done")
                                               : next ? tr("next")
                                                      : tr("to come")));
    label.setToolTip(label.accessibleName());
    label.style()->unpolish(&label);
    label.style()->polish(&label);
  }
}

}  // namespace isograsp
