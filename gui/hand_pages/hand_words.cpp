// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/hand_words.hpp"

#include <QCoreApplication>
#include <QLocale>

namespace isograsp::gui {

namespace {

struct HandTexts {
  Q_DECLARE_TR_FUNCTIONS(Hand)
};

}  // namespace

QString in_whole_mm(double length_m) {
  constexpr double kMmPerM = 1000.0;
  return QLocale().toString(static_cast<int>(kMmPerM * length_m));
}

QString digit_title(Digit digit) {
  switch (digit) {
    case Digit::thumb: return HandTexts::tr("Thumb");
    case Digit::index: return HandTexts::tr("Index finger");
    case Digit::middle: return HandTexts::tr("Middle finger");
    case Digit::ring: return HandTexts::tr("Ring finger");
    case Digit::little: return HandTexts::tr("Little finger");
  }
  return {};
}

QString state_words(virtual_hand::DigitState state) {
  switch (state) {
    case virtual_hand::DigitState::free: return HandTexts::tr("free");
    case virtual_hand::DigitState::contact: return HandTexts::tr("touches");
    case virtual_hand::DigitState::attached: return HandTexts::tr("tied");
    case virtual_hand::DigitState::blocked: return HandTexts::tr("has let go");
  }
  return {};
}

QString level_words(virtual_hand::AssistanceLevel level) {
  switch (level) {
    case virtual_hand::AssistanceLevel::full: return HandTexts::tr("full");
    case virtual_hand::AssistanceLevel::softer: return HandTexts::tr("softer");
    case virtual_hand::AssistanceLevel::off: return HandTexts::tr("none");
  }
  return {};
}

QString criterion_name(std::size_t which) {
  switch (which) {
    case 0: return HandTexts::tr("G min");
    case 1: return HandTexts::tr("H min");
    default: return HandTexts::tr("H det");
  }
}

}  // namespace isograsp::gui
