// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/passive_range.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>

#include "core/csv.hpp"
#include "tasks/kinds/arm/pose_following.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::session {

namespace {

constexpr const char* kTopic = "screening";
constexpr double kDegree_rad = std::numbers::pi / 180.0;
/// Angles of a posture and of the range, entered in whole degrees, are equal within this.
constexpr double kSameAngle_rad = 1e-9;
constexpr double kPercent = 100.0;
int percent_of(double part) {
  return static_cast<int>(std::lround(kPercent * part));
}

constexpr int kAngles = 3;  // of a link
std::string name_of(const LinkAngle& of) {
  return std::string(kArmLinkNames[index_of(of.link)]) + "_a" + std::to_string(of.angle);
}
std::string item_of(const LinkAngle& of, const char* end) {
  return "passive_" + name_of(of) + "_" + end + "_deg";
}

Result<std::optional<double>> angle_in(std::span<const storage::SessionAnswer> answers,
                                       const std::string& item) {
  std::optional<double> angle_rad;
  for (const storage::SessionAnswer& answer : answers) {
    if (answer.topic != kTopic || answer.item != item) continue;
    double degrees = 0.0;
    if (!parse_number(answer.value, degrees) || !(std::abs(degrees) <= 180.0))
      return refused("is no angle between -180 and 180 degrees"_text, "enter it again"_text)
          .about(item);
    angle_rad = kDegree_rad * degrees;
  }
  return angle_rad;
}

/// Of a task whose targets are postures: which ones, and how far they are gone to.
struct Targets {
  const std::string* postures = nullptr;  ///< name of their file; empty: of the own range
  const std::vector<std::string>* names = nullptr;
  double way = 1.0;
};
std::optional<Targets> targets_of(const tasks::TaskSpec& spec) {
  if (const auto* matching = spec.kind.get_if<tasks::PoseMatchingSpec>())
    return Targets{&matching->postures, &matching->sequence, matching->way};
  if (const auto* following = spec.kind.get_if<tasks::PoseFollowingSpec>())
    return Targets{&following->postures, &following->sequence, following->way};
  return std::nullopt;
}

/// An angle of a target that lies outside.
struct Beyond {
  std::string posture;
  double angle_rad = 0.0;
  double limit_rad = 0.0;
};
std::optional<Beyond> first_beyond(const Postures& at, const std::vector<std::string>& names,
                                   const std::array<RigLink, kArmLinkCount>& links,
                                   std::span<const PassiveLimit> limits) {
  for (const Posture& posture : at.postures) {
    if (std::find(names.begin(), names.end(), posture.name) == names.end()) continue;
    for (const PassiveLimit& limit : limits) {
      const std::size_t l = index_of(limit.angle.link);
      if (l >= posture.X_L.size()) continue;
      // The attitude of a link is that of the reference subject, whatever the size of this arm.
      const double angle_rad =
          link_angles(posture.X_L[l].q, links[l])[static_cast<Eigen::Index>(limit.angle.angle - 1)];
      if (angle_rad < limit.least_rad - kSameAngle_rad)
        return Beyond{posture.name, angle_rad, limit.least_rad};
      if (angle_rad > limit.most_rad + kSameAngle_rad)
        return Beyond{posture.name, angle_rad, limit.most_rad};
    }
  }
  return std::nullopt;
}

/// The largest whole per cent of the way, less than `way`, up to which all of it lies inside;
/// nothing: not even the initial posture does.
std::optional<int> percent_that_fits(const Postures& library, const Targets& targets,
                                     const std::array<RigLink, kArmLinkCount>& links,
                                     std::span<const PassiveLimit> limits) {
  std::optional<int> fits;
  for (int percent = 0; percent < kPercent * targets.way; ++percent) {
    if (first_beyond(part_of_the_way(library, percent / kPercent), *targets.names, links, limits))
      break;
    fits = percent;
  }
  return fits;
}

/// The stage that has to come before this part of the way; nothing: it may be the first.
std::optional<double> stage_before(double way) noexcept {
  const auto at =
      std::find_if(kStages.begin(), kStages.end(), [way](double stage) { return way <= stage; });
  if (at == kStages.begin() || at == kStages.end()) return std::nullopt;
  return *std::prev(at);
}

Result<void> check_stage(const tasks::TaskSpec& spec, const Targets& targets,
                         const std::map<std::string, double>& way_done) {
  const auto before = stage_before(targets.way);
  if (!before || targets.postures->empty()) return {};
  const auto done = way_done.find(*targets.postures);
  if (done != way_done.end() && done->second >= *before) return {};
  return refused("goes %1 % of the way before %2 % of it were done"_text(percent_of(targets.way),
                                                                         percent_of(*before)),
                 "do a task with way_percent = %1 first"_text(percent_of(*before)))
      .at(spec.file)
      .about("way_percent");
}

}  // namespace

std::vector<storage::SessionAnswer> stored(std::span<const PassiveLimit> limits) {
  const auto degrees = [](double angle_rad) {
    constexpr double kPerDegree = 1e6;  // whole degrees come back as they were entered
    return format_number(std::round(kPerDegree * angle_rad / kDegree_rad) / kPerDegree);
  };
  std::vector<storage::SessionAnswer> answers;
  for (const PassiveLimit& limit : limits) {
    answers.push_back({kTopic, item_of(limit.angle, "least"), degrees(limit.least_rad)});
    answers.push_back({kTopic, item_of(limit.angle, "most"), degrees(limit.most_rad)});
  }
  return answers;
}

Result<std::vector<PassiveLimit>> passive_limits_in(
    std::span<const storage::SessionAnswer> answers) {
  std::vector<PassiveLimit> limits;
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (int angle = 1; angle <= kAngles; ++angle) {
      const LinkAngle of{static_cast<ArmLink>(link), angle};
      const auto least = angle_in(answers, item_of(of, "least"));
      if (!least) return least.error();
      const auto most = angle_in(answers, item_of(of, "most"));
      if (!most) return most.error();
      if (!*least && !*most) continue;
      if (!*least || !*most || !(**least < **most))
        return refused("a passive range needs two angles, the first below the second"_text,
                       "enter both"_text)
            .about(item_of(of, "least"));
      limits.push_back({of, **least, **most});
    }
  return limits;
}

Result<PassiveLimit> passive_limit_from(std::string_view text) {
  const auto wrong = [&text] {
    return refused("'%1' is no passive range"_text(std::string(text)),
                   "write LINK_aANGLE=LEAST:MOST in degrees, e.g. forearm_a3=-40:60"_text);
  };
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.find(':');
  if (equals == std::string_view::npos || colon == std::string_view::npos || colon < equals)
    return wrong();
  for (std::size_t link = 0; link < kArmLinkCount; ++link)
    for (int angle = 1; angle <= kAngles; ++angle) {
      const LinkAngle of{static_cast<ArmLink>(link), angle};
      if (text.substr(0, equals) != name_of(of)) continue;
      const auto limits = passive_limits_in(std::array{
          storage::SessionAnswer{kTopic, item_of(of, "least"),
                                 std::string(text.substr(equals + 1, colon - equals - 1))},
          storage::SessionAnswer{kTopic, item_of(of, "most"),
                                 std::string(text.substr(colon + 1))}});
      if (!limits) return limits.error();
      return limits->front();
    }
  return wrong();
}

std::optional<WayTo> way_of(const tasks::TaskSpec& spec) {
  const auto targets = targets_of(spec);
  if (!targets || targets->postures->empty()) return std::nullopt;
  return WayTo{*targets->postures, targets->way};
}

Result<void> check_screening(const tasks::TaskSpec& spec, const Postures* library,
                             const std::array<RigLink, kArmLinkCount>& links, tasks::Effort allowed,
                             const tasks::ArmScreening& screening) {
  const std::span<const PassiveLimit> limits = screening.passive;
  if (allowed == tasks::Effort::none)
    return refused("the screening allows this arm no movement"_text,
                   "leave the task out, or repeat the screening"_text)
        .at(spec.file)
        .about("kind");
  const auto targets = targets_of(spec);
  if (!targets) return {};
  if (allowed == tasks::Effort::comfortable && targets->way > kSmallWay)
    return refused("the screening allows this arm a small range only"_text,
                   "choose a task with way_percent = 50 or less"_text)
        .at(spec.file)
        .about("way_percent");
  if (screening.way_done)
    if (auto staged = check_stage(spec, *targets, *screening.way_done); !staged) return staged;
  if (library == nullptr || limits.empty()) return {};
  const auto beyond =
      first_beyond(part_of_the_way(*library, targets->way), *targets->names, links, limits);
  if (!beyond) return {};
  const auto whole_degrees = [](double angle_rad) {
    return static_cast<int>(std::lround(angle_rad / kDegree_rad));
  };
  const Text what = "'%1' turns a joint to %2 degrees, its passive range ends at %3"_text(
      beyond->posture, whole_degrees(beyond->angle_rad), whole_degrees(beyond->limit_rad));
  const auto percent = percent_that_fits(*library, *targets, links, limits);
  const Text remedy =
      percent && *percent > 0
          ? Text("%1 % of the way fit: choose a task with that way_percent"_text(*percent))
          : Text("not even its start fits: choose another task"_text);
  return refused(what, remedy).at(spec.file).about("way_percent");
}

}  // namespace isograsp::session
