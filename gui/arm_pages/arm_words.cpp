// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/arm_words.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <numbers>

namespace isograsp::gui {

namespace {

struct ArmTexts {
  Q_DECLARE_TR_FUNCTIONS(Arm)
};

}  // namespace

QString segment_title(ArmSegment segment) {
  switch (segment) {
    case ArmSegment::brace: return ArmTexts::tr("Brace");
    case ArmSegment::trunk: return ArmTexts::tr("Trunk");
    case ArmSegment::elbow: return ArmTexts::tr("Elbow");
    case ArmSegment::forearm: return ArmTexts::tr("Forearm");
    case ArmSegment::dorsum: return ArmTexts::tr("Back of the hand");
    case ArmSegment::object: return ArmTexts::tr("Object");
  }
  return {};
}

QString link_title(ArmLink link) {
  switch (link) {
    case ArmLink::forearm: return ArmTexts::tr("Forearm", "a link that turns");
    case ArmLink::wrist: return ArmTexts::tr("Wrist");
    case ArmLink::fingers: return ArmTexts::tr("Fingers");
  }
  return {};
}

QString sight_words(FrameState state) {
  switch (state) {
    case FrameState::ok: return ArmTexts::tr("seen");
    case FrameState::rejected: return ArmTexts::tr("seen, one marker astray");
    case FrameState::few: return ArmTexts::tr("too few markers");
    case FrameState::collinear: return ArmTexts::tr("markers on a line");
    case FrameState::residual: return ArmTexts::tr("markers do not fit");
    case FrameState::missing: return ArmTexts::tr("not seen");
  }
  return {};
}

QString in_degrees(double angle_rad) {
  constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;
  return QLocale().toString(kDegreesPerRad * angle_rad, 'f', 0);
}

}  // namespace isograsp::gui
