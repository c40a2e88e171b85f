// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_play.hpp"

#include <limits>
#include <utility>

#include "device/hand/hand_csv.hpp"
#include "device/markers/marker_period.hpp"

namespace isograsp {

HandPlay HandPlay::of(std::vector<HandFrame> hands) {
  HandPlay play;
  play.hands = std::move(hands);
  std::vector<double> times_s;
  const double first_s = play.hands.front().t_s;
  for (std::size_t k = 0; k < play.hands.size(); ++k) {
    HandFrame& hand = play.hands[k];
    hand.t_s -= first_s;
    if (play.shots.empty() || hand.t_s != play.shots.back().t_s) {
      play.shots.push_back({hand.t_s, k, 0});
      times_s.push_back(hand.t_s);
    }
    ++play.shots.back().count;
  }
  play.period_s = period_of(times_s);
  return play;
}

Result<HandPlay> HandPlay::read(const std::string& path) {
  auto hands = read_hand_csv(path);
  if (!hands) return hands.error();
  for (std::size_t k = 1; k < hands->size(); ++k)
    if ((*hands)[k].t_s < (*hands)[k - 1].t_s)
      return refused("times of the two hands do not increase together"_text,
                     "sort the rows by time"_text)
          .at(path)
          .about("t_s");
  if (hands->empty() || hands->front().t_s == hands->back().t_s)
    return refused("holds fewer than two rows"_text, "record some seconds"_text).at(path);
  return of(*std::move(hands));
}

HandScene::HandScene(HandPlay play, std::vector<EmulatedHandFault> faults, std::uint64_t seed)
    : play_(std::move(play)), faults_(std::move(faults)), random_(seed), frozen_(faults_.size()) {}

std::optional<double> HandScene::next_s() const noexcept {
  if (shot_ == play_.shots.size()) return std::nullopt;
  return round_s_ + play_.shots[shot_].t_s;
}

HandPicture HandScene::take() {
  using Kind = EmulatedHandFault::Kind;
  const HandShot& shot = play_.shots[shot_];
  const auto shown = play_.hands_of(shot);
  HandPicture picture;
  picture.frame = static_cast<std::int64_t>(++counters_.frames);
  picture.play_s = picture.stamp_s = *next_s();
  picture.hands.assign(shown.begin(), shown.end());
  for (std::size_t k = 0; k < faults_.size(); ++k) {
    const EmulatedHandFault& fault = faults_[k];
    if (fault.kind == Kind::freeze) {
      if (!fault.acts_at(picture.play_s)) continue;
      if (!frozen_[k]) frozen_[k] = last_.empty() ? picture.hands : last_;
      picture.hands = *frozen_[k];
    } else if (fault.kind == Kind::drop) {
      if (random_.uniform() < fault.probability && std::exchange(picture.sent, false))
        ++counters_.dropped;
    } else if (fault.kind == Kind::malformed) {
      picture.cut = picture.cut || random_.uniform() < fault.probability;
    } else if (fault.acts_at(picture.play_s)) {
      apply(fault, picture);
    }
  }
  if (picture.cut && picture.sent) ++counters_.malformed;
  for (HandFrame& hand : picture.hands) hand.t_s = picture.stamp_s;
  last_ = picture.hands;
  if (++shot_ == play_.shots.size() && play_.repeat) {
    shot_ = 0;
    round_s_ = picture.play_s + play_.period_s;
  }
  return picture;
}

void HandScene::apply(const EmulatedHandFault& fault, HandPicture& picture) {
  using Kind = EmulatedHandFault::Kind;
  switch (fault.kind) {
    case Kind::silence:
      if (std::exchange(picture.sent, false)) ++counters_.silent;
      break;
    case Kind::lose:
      for (HandFrame& hand : picture.hands) {
        hand.tracked = false;
        hand.confidence = 0.0;
      }
      break;
    case Kind::flip:
      for (HandFrame& hand : picture.hands)
        hand.side = hand.side == Hand::right ? Hand::left : Hand::right;
      break;
    case Kind::nan:
      for (HandFrame& hand : picture.hands)
        hand.joints[joint_of(Digit::index, 3)].fill(std::numeric_limits<double>::quiet_NaN());
      break;
    case Kind::clock: picture.stamp_s += fault.step_s; break;
    default: break;
  }
}

}  // namespace isograsp
