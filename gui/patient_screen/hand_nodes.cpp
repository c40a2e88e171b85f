// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/hand_nodes.hpp"

#include <algorithm>
#include <cmath>

#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include "gui/patient_screen/hand_colours.hpp"
#include "gui/patient_screen/hand_props.hpp"
#include "gui/solids/rounded_mesh.hpp"
#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui::scene_nodes {

using virtual_hand::HandInSpace;
using virtual_hand::kLinkCount;

namespace {

constexpr std::size_t kThumb = index_of(Digit::thumb);
/// Two hands of which nothing differs by more than this [m] are drawn with the same nodes.
constexpr double kSameSize_m = 1e-5;
/// A palm is thicker than the capsules of its bones: by so much below each [m].
constexpr double kBone_m = 0.0115;
constexpr double kFlesh_m = 0.007;

SoMaterial* make_skin(const SbColor& colour) {
  SoMaterial* skin = make_material(colour);
  skin->specularColor.setValue(0.10F, 0.09F, 0.08F);
  skin->shininess.setValue(0.25F);
  return skin;
}

/// Seen from the tip of a digit: bright, flat, a little bent.
SoSeparator* make_nail(double radius_m, double length_m) {
  const auto r = static_cast<float>(radius_m);
  auto* nail = new SoSeparator;
  auto* place = new SoTransform;
  place->translation.setValue(0.0F, 0.70F * r, -static_cast<float>(length_m) - 0.12F * r);
  place->rotation.setValue(SbVec3f(1, 0, 0), -0.30F);
  place->scaleFactor.setValue(0.62F, 0.22F, 0.78F);
  auto* plate = new SoSphere;
  plate->radius.setValue(r);
  nail->addChild(make_skin(kNailColour));
  nail->addChild(place);
  nail->addChild(plate);
  return nail;
}

/// Round the last link of a digit that is tied: it is to be seen without colours, too.
SoSwitch* make_band(double radius_m, double length_m) {
  auto* shown = new SoSwitch;
  auto* band = new SoSeparator;
  auto* place = new SoTransform;
  place->translation.setValue(0.0F, 0.0F, -0.42F * static_cast<float>(length_m));
  place->rotation.setValue(SbVec3f(1, 0, 0), static_cast<float>(M_PI / 2));
  auto* ring = new SoCylinder;
  ring->radius.setValue(1.16F * static_cast<float>(radius_m));
  ring->height.setValue(0.0035F);
  band->addChild(make_material(kBandColour));
  band->addChild(place);
  band->addChild(ring);
  shown->addChild(band);
  return shown;
}

}  // namespace

HandNodes::HandNodes() : root_(new SoSeparator), parts_(new SoSeparator) {
  auto* hints = new SoShapeHints;
  hints->vertexOrdering.setValue(SoShapeHints::COUNTERCLOCKWISE);
  hints->shapeType.setValue(SoShapeHints::SOLID);
  root_->addChild(hints);
  root_->addChild(parts_);
}

HandNodes::Size HandNodes::size_of(const HandInSpace& hand, const session::LinkRadii& radii_m) {
  Size size;
  size.radii_m = radii_m;
  const Quat q_PW = hand.X_WP.q.conjugate();
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto& joints = hand.digits[d].joints;
    size.palm_P[d] = q_PW * (hand.metacarpals[d] - hand.X_WP.p);
    size.palm_P[kDigitCount + d] = q_PW * (joints[0] - hand.X_WP.p);
    for (std::size_t k = 0; k < kLinkCount; ++k)
      size.lengths_m[d][k] = (joints[k + 1] - joints[k]).norm();
  }
  return size;
}

bool HandNodes::fits(const Size& size) const {
  if (!size_ || size_->radii_m != size.radii_m) return false;
  for (std::size_t i = 0; i < size.palm_P.size(); ++i)
    if ((size.palm_P[i] - size_->palm_P[i]).norm() > kSameSize_m) return false;
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      if (std::abs(size.lengths_m[d][k] - size_->lengths_m[d][k]) > kSameSize_m) return false;
  return true;
}

void HandNodes::build() {
  parts_->removeAllChildren();
  parts_->addChild(skin_ = make_skin(kSkinColour));
  build_palm();
  for (std::size_t d = 0; d < kDigitCount; ++d) build_digit(d);
}

void HandNodes::build_palm() {
  const auto metacarpal = [this](Digit digit) { return size_->palm_P[index_of(digit)]; };
  const auto knuckle = [this](Digit digit) { return size_->palm_P[kDigitCount + index_of(digit)]; };
  const Vec3 flesh(0.0, -kFlesh_m, 0.0);
  std::vector<Ball> palm;
  for (const Digit digit : {Digit::index, Digit::middle, Digit::ring, Digit::little}) {
    const double radius_m = size_->radii_m[index_of(digit)][0];
    palm.push_back({metacarpal(digit), kBone_m});
    palm.push_back({knuckle(digit), radius_m + 0.001});
    palm.push_back({knuckle(digit) + Vec3(0.0, -0.003, 0.010), radius_m + 0.001});
  }
  // The ball of the little finger; that of the thumb moves with it. A back is a little round.
  palm.push_back({metacarpal(Digit::little) + flesh + Vec3(0.0, 0.0, -0.018), kBone_m});
  palm.push_back({metacarpal(Digit::thumb) + Vec3(0.0, 0.004, 0.0), kBone_m});
  palm.push_back(
      {0.5 * (metacarpal(Digit::middle) + knuckle(Digit::middle)) + Vec3(0.0, 0.0015, 0.0),
       kBone_m});
  // It narrows to the wrist, and a sleeve ends there: a hand does not float.
  const auto pair = [](double x, double z, double radius_m) {
    constexpr double kMiddle_m = -0.004;
    return std::array{Ball{Vec3(-x, kMiddle_m, z), radius_m},
                      Ball{Vec3(x, kMiddle_m, z), radius_m}};
  };
  const auto all = [](const std::array<Ball, 2>& first, const std::array<Ball, 2>& second) {
    return std::vector<Ball>{first[0], first[1], second[0], second[1]};
  };
  constexpr int kFine = 36;
  const auto wrist = pair(0.012, 0.014, 0.0135);
  palm.insert(palm.end(), wrist.begin(), wrist.end());
  auto* group = new SoSeparator;
  group->addChild(palm_ = new SoTransform);
  group->addChild(make_rounded(palm, kFine));
  group->addChild(make_rounded(all(wrist, pair(0.012, 0.060, 0.0165)), kFine / 2));
  group->addChild(make_skin(kSleeveColour));
  group->addChild(make_rounded(all(pair(0.011, 0.054, 0.0225), pair(0.013, 0.125, 0.0265)), kFine));
  parts_->addChild(group);
}

void HandNodes::build_digit(std::size_t digit) {
  const auto& radii_m = size_->radii_m[digit];
  const auto& lengths_m = size_->lengths_m[digit];
  // At each joint as thick as the links on both its sides; a thumb begins with its ball.
  constexpr double kBallOfThumb = 1.30;
  const std::array<double, kLinkCount + 1> at_joint{
      digit == kThumb ? kBallOfThumb * radii_m[0] : radii_m[0], 0.5 * (radii_m[0] + radii_m[1]),
      0.5 * (radii_m[1] + radii_m[2]), 0.94 * radii_m[2]};
  for (std::size_t k = 0; k < kLinkCount; ++k) {
    const bool last = k + 1 == kLinkCount;
    auto* link = new SoSeparator;
    link->addChild(links_[digit][k] = new SoTransform);
    if (last) link->addChild(tips_[digit] = make_skin(kSkinColour));
    const Vec3 end(0.0, 0.0, -lengths_m[k]);
    std::vector<Ball> balls{{Vec3::Zero(), at_joint[k]}, {end, at_joint[k + 1]}};
    // Pads and the flesh of the ball of the thumb, on the side of the palm.
    if (last) balls.push_back({0.6 * end + Vec3(0.0, -0.0012, 0.0), 0.98 * radii_m[k]});
    if (digit == kThumb && k == 0)
      balls.push_back({0.45 * end + Vec3(0.0, -0.004, 0.0), 1.15 * radii_m[0]});
    link->addChild(make_rounded(balls));
    if (last) {
      link->addChild(bands_[digit] = make_band(radii_m[k], lengths_m[k]));
      link->addChild(make_nail(radii_m[k], lengths_m[k]));
    }
    parts_->addChild(link);
  }
}

void HandNodes::place(const HandInSpace& hand, const session::LinkRadii& radii_m) {
  if (const Size size = size_of(hand, radii_m); !fits(size)) {
    size_ = size;
    build();
  }
  const auto stand = [](SoTransform* part, const Vec3& p_W, const Quat& q_W) {
    part->translation.setValue(to_sb(p_W));
    part->rotation.setValue(to_sb(q_W));
  };
  stand(palm_, hand.X_WP.p, hand.X_WP.q);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      stand(links_[d][k], hand.digits[d].joints[k], hand.digits[d].links[k]);
}

void HandNodes::tint(const std::array<HandPicture::Tip, kDigitCount>& tips, bool pale) {
  if (!size_) return;
  const SbColor& skin = pale ? kUnseenColour : kSkinColour;
  set_colour(skin_, skin);
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const bool tied = tips[d] == HandPicture::Tip::tied;
    set_colour(tips_[d], tied                                   ? kTiedColour
                         : tips[d] == HandPicture::Tip::touches ? kTouchesColour
                                                                : skin);
    show_if(bands_[d], tied);
  }
}

}  // namespace isograsp::gui::scene_nodes
