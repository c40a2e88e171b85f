// SPDX-License-Identifier: GPL-3.0-or-later
// A hand as it is drawn: palm, links, nails, the band of a digit that is tied. Built once for the
// size of a hand; a frame only moves its parts.
#pragma once

#include <array>
#include <optional>

#include <Inventor/SbColor.h>

#include "gui/picture/hand_picture.hpp"

class SoMaterial;
class SoSeparator;
class SoSwitch;
class SoTransform;

namespace isograsp::gui::scene_nodes {

class HandNodes {
 public:
  HandNodes();
  /// Belongs to whoever adds it to a scene.
  [[nodiscard]] SoSeparator* root() const { return root_; }
  /// Where its links are; builds them where the size of the hand is another one.
  void place(const virtual_hand::HandInSpace& hand, const session::LinkRadii& radii_m);
  /// `pale`: it stands still as it is not seen.
  void tint(const std::array<HandPicture::Tip, kDigitCount>& tips, bool pale);

 private:
  /// What has to be the same for the nodes to fit.
  struct Size {
    std::array<Vec3, 2 * kDigitCount> palm_P;
    std::array<std::array<double, virtual_hand::kLinkCount>, kDigitCount> lengths_m{};
    session::LinkRadii radii_m{};
  };
  [[nodiscard]] static Size size_of(const virtual_hand::HandInSpace& hand,
                                    const session::LinkRadii& radii_m);
  [[nodiscard]] bool fits(const Size& size) const;
  void build();
  void build_palm();
  void build_digit(std::size_t digit);

  std::optional<Size> size_;
  SoSeparator* root_;
  SoSeparator* parts_;
  SoTransform* palm_ = nullptr;
  std::array<std::array<SoTransform*, virtual_hand::kLinkCount>, kDigitCount> links_{};
  SoMaterial* skin_ = nullptr;
  std::array<SoMaterial*, kDigitCount> tips_{};
  std::array<SoSwitch*, kDigitCount> bands_{};
};

}  // namespace isograsp::gui::scene_nodes
