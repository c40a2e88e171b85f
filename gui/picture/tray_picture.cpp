// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/tray_picture.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

namespace {

using Sign = PatientPicture::Sign;

struct TrayTexts {
  Q_DECLARE_TR_FUNCTIONS(PatientScreen)
};

void say_of_tray(PatientPicture& picture, Sign sign, const QString& headline,
                 const QString& detail) {
  picture.sign = sign;
  picture.headline = headline.toStdString();
  picture.detail = detail.toStdString();
}

void say_lift(const ShownTray& tray, const TrayPicture& seen, PatientPicture& picture) {
  if (picture.hold_fraction > 0.0)
    return say_of_tray(picture, Sign::act, TrayTexts::tr("Hold it still"),
                       TrayTexts::tr("Until the ring is full"));
  if (tray.slips.left || tray.slips.right)
    return say_of_tray(picture, Sign::act, TrayTexts::tr("Press the ends together"),
                       TrayTexts::tr("It slides: press more firmly"));
  if (!tray.touches.left || !tray.touches.right)
    return say_of_tray(picture, Sign::act, TrayTexts::tr("Press the ends together"),
                       TrayTexts::tr("Then lift it with both hands"));
  if (!seen.level)
    return say_of_tray(picture, Sign::act, TrayTexts::tr("Lift it with both hands"),
                       seen.angle_rad > 0.0 ? TrayTexts::tr("The left end is too low")
                                            : TrayTexts::tr("The right end is too low"));
  say_of_tray(picture, Sign::act, TrayTexts::tr("Lift it with both hands"),
              TrayTexts::tr("Level, into the band"));
}

}  // namespace

void add_tray(const PatientFacts& facts, PatientPicture& picture) {
  const ShownTray& tray = *facts.stimulus.hands->tray;
  TrayPicture& seen = picture.two_hands->tray.emplace();
  seen.size_m = tray.size_m;
  seen.p_W = tray.X_WO.p + facts.ahead_s * tray.v_WO_W;
  const double angle_rad = 2.0 * std::atan2(tray.X_WO.q.z(), tray.X_WO.q.w());
  seen.angle_rad = angle_rad + facts.ahead_s * tray.w_WO_W.z();
  const Quat q(Eigen::AngleAxisd(seen.angle_rad, Vec3::UnitZ()));
  for (const Hand hand : kBothHands)
    seen.of[hand] = {seen.p_W + q * tray.end_O[hand], tray.touches[hand], tray.slips[hand]};
  seen.rest_y_m = tray.X_WR.p.y();
  seen.target_shown = tray.target_shown;
  seen.target_y_m = tray.X_WT.p.y();
  seen.band_m = tray.band_m;
  seen.level = std::abs(seen.angle_rad) <= tray.band_rad;
  seen.on_target =
      tray.target_shown && seen.level && std::abs(seen.p_W.y() - seen.target_y_m) <= tray.band_m;
  seen.fetched = tray.fetched;
  const ShownProgress& progress = facts.stimulus.progress;
  picture.targets_reached = progress.targets_reached;
  picture.target_count = progress.target_count;
  if (progress.holding && seen.on_target) picture.hold_fraction = progress.hold_fraction;
  if (tray.fetched)
    return say_of_tray(picture, Sign::rest, TrayTexts::tr("It slipped: let both hands rest"),
                       TrayTexts::tr("You may lift it again in a moment"));
  if (tray.target_shown) say_lift(tray, seen, picture);
}

}  // namespace isograsp::gui
