// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/work_progress.hpp"

#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kSteps = 1000;
}

WorkProgress::WorkProgress(const QString& name, const QString& title, QWidget* parent)
    : QWidget(parent) {
  setObjectName(name + QStringLiteral("_writing"));
  doing_ = new QLabel;
  doing_->setObjectName(name + QStringLiteral("_doing"));
  doing_->setWordWrap(true);
  progress_ = new QProgressBar;
  progress_->setObjectName(name + QStringLiteral("_progress"));
  progress_->setRange(0, kSteps);
  describe(*progress_, title, tr("How much of it is written"));
  cancel_ = new QPushButton;
  cancel_->setObjectName(name + QStringLiteral("_cancel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(doing_);
  column->addWidget(progress_);
  column->addWidget(cancel_);
  hide();
}

void WorkProgress::show_fraction(double fraction) {
  progress_->setValue(static_cast<int>(kSteps * fraction));
}

}  // namespace isograsp::gui
