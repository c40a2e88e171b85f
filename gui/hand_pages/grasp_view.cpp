// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/grasp_view.hpp"

#include <QGridLayout>
#include <QLocale>
#include <algorithm>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

QString in_newtons(double force_N) {
  return QLocale().toString(force_N, 'f', 2);
}

/// Criteria go over four decades.
QString criterion_number(double value) {
  return QLocale().toString(value, 'g', 2);
}

QString criterion_title(std::size_t which) {
  switch (which) {
    case 0: return GraspView::tr("Hold, weakest direction (G min)");
    case 1: return GraspView::tr("Hand, weakest direction (H min)");
    default: return GraspView::tr("Hand, on the whole (H det)");
  }
}

}  // namespace

GraspView::GraspView(const QString& prefix, Form form, QWidget* parent)
    : QWidget(parent), form_(form) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(make_digits(prefix));
  verdict_ = new QLabel;
  verdict_->setObjectName(prefix + "grasp_verdict");
  column->addSpacing(6);
  column->addWidget(verdict_);
  column->addLayout(make_criteria(prefix));
  show_grasp(std::nullopt);
}

void GraspView::show_grasp(const std::optional<GraspLive>& grasp) {
  show_digits(grasp);
  show_criteria(grasp);
}

/// Each digit: what it does, and its pull beside the one that lets go.
QLayout* GraspView::make_digits(const QString& prefix) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(2, 1);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto title = digit_title(static_cast<Digit>(d));
    const int at = static_cast<int>(d);
    DigitRow& row = digits_[d];
    row.state = new QLabel;
    row.state->setObjectName(prefix + QStringLiteral("digit_state_%1").arg(d));
    if (form_ == Form::wide)
      row.pull = make_pull(prefix + QStringLiteral("digit_pull_%1").arg(d), title);
    row.pull_words = new QLabel;
    row.pull_words->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(new QLabel(title), at, 0);
    grid->addWidget(row.state, at, 1);
    if (row.pull != nullptr) grid->addWidget(row.pull, at, 2);
    grid->addWidget(row.pull_words, at, 3);
  }
  // Words that come and go move nothing.
  if (form_ == Form::narrow) return grid;
  constexpr int kState_px = 90;
  constexpr int kPull_px = 120;
  grid->setColumnMinimumWidth(1, scaled(kState_px));
  grid->setColumnMinimumWidth(3, scaled(kPull_px));
  return grid;
}

QProgressBar* GraspView::make_pull(const QString& name, const QString& digit) {
  auto* pull = new QProgressBar;
  pull->setObjectName(name);
  pull->setRange(0, 100);
  pull->setTextVisible(false);
  describe(
      *pull, tr("%1: pull").arg(digit),
      tr("%1: how hard it pulls away, as a share of the pull at which its tie lets go").arg(digit));
  return pull;
}

/// The best set of the digits that touch, against the limits for help.
QLayout* GraspView::make_criteria(const QString& prefix) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(0, 1);
  for (std::size_t k = 0; k < criteria_.size(); ++k) {
    CriterionRow& row = criteria_[k];
    const int at = static_cast<int>(k);
    row.value = new QLabel;
    row.value->setObjectName(prefix + QStringLiteral("criterion_%1").arg(k));
    row.limit = new QLabel;
    row.limit->setProperty("role", "quiet");
    row.verdict = new QLabel;
    auto* title = new QLabel(form_ == Form::wide ? criterion_title(k) : criterion_name(k));
    title->setToolTip(criterion_title(k));
    title->setWordWrap(true);
    grid->addWidget(title, at, 0);
    for (QLabel* number : {row.value, row.limit})
      number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(row.value, at, 1);
    grid->addWidget(row.limit, at, 2);
    grid->addWidget(row.verdict, at, 3);
  }
  if (form_ == Form::narrow) return grid;
  constexpr int kNumber_px = 70;
  constexpr int kLimit_px = 100;
  constexpr int kVerdict_px = 16;
  grid->setColumnMinimumWidth(1, scaled(kNumber_px));
  grid->setColumnMinimumWidth(2, scaled(kLimit_px));
  grid->setColumnMinimumWidth(3, scaled(kVerdict_px));
  return grid;
}

void GraspView::show_digits(const std::optional<GraspLive>& grasp) {
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    DigitRow& row = digits_[d];
    const DigitLive digit = grasp ? grasp->digits[d] : DigitLive{};
    constexpr double kPercent = 100.0;
    row.state->setText(grasp ? state_words(digit.state) : tr("–"));
    if (row.pull != nullptr)
      row.pull->setValue(static_cast<int>(kPercent * digit.share.value_or(0.0)));
    row.pull_words->setText(
        digit.share ? tr("%1 of %2 N").arg(in_newtons(digit.pull_N), in_newtons(*grasp->release_N))
                    : QString());
  }
}

void GraspView::show_criteria(const std::optional<GraspLive>& grasp) {
  const bool touches = grasp && grasp->criteria[0];
  const bool tied =
      grasp && std::any_of(grasp->digits.begin(), grasp->digits.end(), [](const DigitLive& digit) {
        return digit.state == virtual_hand::DigitState::attached;
      });
  verdict_->setText(!grasp            ? tr("Grasp: no object is there.")
                    : !touches        ? tr("Grasp: fewer than two fingers touch.")
                    : grasp->feasible ? tr("Grasp: ✓ it holds, and may be helped.")
                    : tied            ? tr("Grasp: ✗ only the help holds it.")
                                      : tr("Grasp: ✗ it does not hold yet."));
  for (std::size_t k = 0; k < criteria_.size(); ++k) {
    const auto criterion = grasp ? grasp->criteria[k] : std::nullopt;
    CriterionRow& row = criteria_[k];
    row.value->setText(criterion ? criterion_number(criterion->value) : tr("–"));
    row.limit->setText(criterion ? tr("above %1").arg(criterion_number(criterion->limit))
                                 : QString());
    row.verdict->setText(!criterion         ? QString()
                         : criterion->met() ? QStringLiteral("✓")
                                            : QStringLiteral("✗"));
  }
}

}  // namespace isograsp::gui
