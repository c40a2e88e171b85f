// SPDX-License-Identifier: GPL-3.0-or-later
// The colours of reports, on paper and as a page of the web.
#pragma once

#include <QColor>

#include "hand/finger.hpp"

namespace isograsp::reports {

/// Okabe-Ito: told apart also by people who see fewer colours. Never the only sign.
struct Palette {
  static QColor ink() { return QColor(0x22, 0x26, 0x2b); }
  static QColor quiet() { return QColor(0x5f, 0x66, 0x6e); }
  static QColor line() { return QColor(0xd5, 0xd9, 0xdd); }
  static QColor band() { return QColor(0xf0, 0xf2, 0xf4); }
  static QColor tolerance() { return QColor(0xd3, 0xda, 0xe1); }
  static QColor of(std::optional<Hand> hand) {
    if (!hand) return {0x00, 0x9e, 0x73};  // both
    return hand == Hand::right ? QColor(0x00, 0x72, 0xb2) : QColor(0xd5, 0x5e, 0x00);
  }
  static QColor pale(std::optional<Hand> hand) {
    if (!hand) return {0x7f, 0xce, 0xb9};
    return hand == Hand::right ? QColor(0x56, 0xb4, 0xe9) : QColor(0xe6, 0x9f, 0x00);
  }
  static QColor target() { return QColor(0x22, 0x26, 0x2b); }
};

}  // namespace isograsp::reports
