// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen suits one person: which half they see, how much may move, whether it
// sounds and speaks; and what an angle is on it. Pure.
#pragma once

#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "gui/picture/target_preview.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::gui {

struct Presentation {
  /// Where everything stands, for somebody who does not see or mind the other side.
  enum class Half : std::uint8_t { whole, left, right };
  Half half = Half::whole;
  bool calm = false;   ///< nothing scrolls, nothing approaches
  bool sound = false;  ///< tones for begin, success and failure
  bool hear = false;   ///< the force is heard against its target
  bool voice = false;  ///< instructions are spoken

  friend bool operator==(const Presentation&, const Presentation&) = default;
};

[[nodiscard]] const char* name_of(Presentation::Half half) noexcept;
/// As stored with the session.
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const Presentation& presentation);
/// From a session's answers; what is not among them is as usual.
[[nodiscard]] Presentation presentation_in(const std::vector<storage::SessionAnswer>& answers);
/// "left half, calm, sounds"; empty: as usual.
[[nodiscard]] QString summary(const Presentation& presentation);

/// The part of the screen that holds everything. Half a screen is no wider than 4:3, so that the
/// pages keep their proportions.
[[nodiscard]] QRectF content_area(const QRectF& screen, Presentation::Half half);

/// The patient's picture as the patient sees it.
struct Viewing {
  double picture_height_m = 0.0;  ///< of the content area; 0: not known
  double distance_m = 0.0;        ///< from the eyes; 0: not known

  [[nodiscard]] bool known() const noexcept { return picture_height_m > 0.0 && distance_m > 0.0; }
  /// Visual angle of a length near the middle of the screen [deg]. @pre known()
  [[nodiscard]] double angle_deg(double length_m) const noexcept;
};

/// Height of the field in which a force follows its target, of the content area.
inline constexpr double kFieldShare = 0.60;

/// Degrees of visual angle per newton that `axis` has on that screen. @pre viewing.known()
[[nodiscard]] double gain_of(const ForceAxis& axis, const Viewing& viewing) noexcept;
/// The axis with this gain; where the targets would leave the screen with it, as it is: the gain
/// that a picture really had is what is stored. @pre viewing.known(), gain_deg_per_N > 0
[[nodiscard]] ForceAxis with_gain(const ForceAxis& axis, double gain_deg_per_N,
                                  const Viewing& viewing) noexcept;

}  // namespace isograsp::gui
