// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/soundtrack.hpp"

#include <cmath>
#include <utility>

namespace isograsp::gui {

namespace {

using Sign = PatientPicture::Sign;

HeardForce heard(const PatientPicture& picture) {
  HeardForce force;
  force.heard = picture.page == PatientPicture::Page::tracking && picture.force_shown &&
                picture.line_shown && picture.sign == Sign::act;
  if (!force.heard) return force;
  const double range_N = picture.axis.most_N - picture.axis.least_N;
  force.difference = (picture.force_N - picture.target_N) / range_N;
  force.on_target = picture.on_target;
  return force;
}

}  // namespace

Sounds Soundtrack::next(const PatientPicture& picture, const Presentation& presentation) {
  Sounds sounds;
  const bool first = !std::exchange(any_, true);
  const Sign before = std::exchange(sign_, picture.sign);
  const bool urgent_before = std::exchange(urgent_, picture.urgent);
  const bool missed_before = std::exchange(missed_, picture.missed);
  const int reached_before = std::exchange(targets_reached_, picture.targets_reached);
  const bool still = picture.notice != PatientPicture::Notice::none;
  const auto words = still                    ? picture.notice_words
                     : picture.detail.empty() ? picture.headline
                                              : picture.headline + ". " + picture.detail;
  const bool new_words = std::exchange(spoken_, words) != words;
  if (presentation.voice && !first && new_words && !words.empty()) sounds.words = words;
  if (still) return sounds;
  if (presentation.sound && !first) {
    if (picture.targets_reached > reached_before)
      sounds.tone = Tone::reached;
    else if (picture.sign == Sign::good && before != Sign::good)
      sounds.tone = Tone::success;
    else if (picture.missed && !missed_before)
      sounds.tone = Tone::try_again;
    else if (picture.urgent && !urgent_before)
      sounds.tone = Tone::begin;
  }
  if (presentation.hear) sounds.force = heard(picture);
  return sounds;
}

}  // namespace isograsp::gui
