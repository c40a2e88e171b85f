// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/marker_play.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "device/markers/marker_period.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

using MarkerKind = EmulatedMarkerFault::Kind;

Result<MarkerPlay> MarkerPlay::read(const std::string& path) {
  auto reader = open_markers(path);
  if (!reader) return reader.error();
  MarkerPlay play;
  play.labels = (*reader)->markers();
  std::vector<Vec3> row(play.labels.size());
  double t_s = 0.0, first_s = 0.0;
  for (;;) {
    const auto more = (*reader)->next(t_s, row);
    if (!more) return more.error();
    if (!*more) break;
    if (play.t_s.empty()) first_s = t_s;
    play.t_s.push_back(t_s - first_s);
    play.p_W.insert(play.p_W.end(), row.begin(), row.end());
  }
  if (play.t_s.size() < 2)
    return refused("holds fewer than two rows"_text, "record some seconds"_text).at(path);
  play.period_s = period_of(play.t_s);
  return play;
}

Result<MarkerScene> MarkerScene::make(MarkerPlay play, std::vector<EmulatedMarkerFault> faults,
                                      std::uint64_t seed) {
  for (const EmulatedMarkerFault& fault : faults)
    for (const std::string& name :
         {fault.marker, fault.kind == MarkerKind::swap ? fault.other : std::string()})
      if (!name.empty() &&
          std::find(play.labels.begin(), play.labels.end(), name) == play.labels.end())
        return refused("the recording has no marker '%1'"_text(name), "name one that it has"_text)
            .about("--fault");
  return MarkerScene(std::move(play), std::move(faults), seed);
}

MarkerScene::MarkerScene(MarkerPlay play, std::vector<EmulatedMarkerFault> faults,
                         std::uint64_t seed)
    : play_(std::move(play)),
      faults_(std::move(faults)),
      random_(seed),
      shown_(play_.labels.size()),
      frozen_(faults_.size(), unseen_marker()),
      struck_(faults_.size(), false) {}

std::optional<double> MarkerScene::next_s() const noexcept {
  if (row_ == play_.t_s.size()) return std::nullopt;
  return round_s_ + play_.t_s[row_];
}

MarkerPicture MarkerScene::take() {
  const std::size_t markers = play_.labels.size();
  MarkerPicture picture;
  picture.play_s = *next_s();
  std::copy_n(play_.p_W.begin() + static_cast<std::ptrdiff_t>(row_ * markers), markers,
              shown_.begin());
  for (std::size_t i = 0; i < faults_.size(); ++i) {
    const EmulatedMarkerFault& fault = faults_[i];
    if (fault.kind == MarkerKind::freeze) {
      Vec3& place = shown_[place_of(fault.marker)];
      if (fault.acts_at(picture.play_s))
        place = frozen_[i];
      else
        frozen_[i] = place;
    } else if (fault.kind == MarkerKind::drop) {
      if (random_.uniform() < fault.probability && std::exchange(picture.sent, false))
        ++counters_.dropped;
    } else if (fault.kind == MarkerKind::restart) {
      if (picture.play_s >= fault.at_s && !struck_[i]) {
        struck_[i] = true;
        count_from_s_ = picture.play_s;
        last_frame_ = 0;
        ++counters_.restarts;
      }
    } else if (fault.acts_at(picture.play_s)) {
      if (fault.kind == MarkerKind::silence && std::exchange(picture.sent, false))
        ++counters_.silent;
      apply(fault);
    }
  }
  picture.stamp_s = picture.play_s - count_from_s_;
  const auto place = std::llround(picture.stamp_s / play_.period_s);
  picture.frame = std::max(1 + static_cast<std::uint32_t>(place), last_frame_ + 1);
  last_frame_ = picture.frame;
  picture.p_W = shown_;
  ++counters_.pictures;
  if (++row_ == play_.t_s.size() && play_.repeat) {
    row_ = 0;
    round_s_ = picture.play_s + play_.period_s;
  }
  return picture;
}

void MarkerScene::apply(const EmulatedMarkerFault& fault) {
  constexpr double kReflection_m = 0.1;  // beside the marker
  switch (fault.kind) {
    case MarkerKind::swap:
      std::swap(shown_[place_of(fault.marker)], shown_[place_of(fault.other)]);
      break;
    case MarkerKind::phantom: shown_[place_of(fault.marker)].x() += kReflection_m; break;
    case MarkerKind::hide: shown_[place_of(fault.marker)] = unseen_marker(); break;
    default: break;
  }
}

std::vector<std::string> MarkerScene::labels(double play_s) const {
  std::vector<std::string> labels = play_.labels;
  for (const EmulatedMarkerFault& fault : faults_)
    if (fault.kind == MarkerKind::rename && fault.acts_at(play_s))
      labels[place_of(fault.marker)] = fault.other;
  return labels;
}

std::size_t MarkerScene::place_of(const std::string& label) const noexcept {
  return static_cast<std::size_t>(std::find(play_.labels.begin(), play_.labels.end(), label) -
                                  play_.labels.begin());
}

}  // namespace isograsp
