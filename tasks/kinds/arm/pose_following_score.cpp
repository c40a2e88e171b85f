// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of following a moving reference, over the counted rows of phase 1 that have object and
// reference:
//   rmse  of the distance of their origins, and of the angle between their attitudes
//   lag   by cross-correlation (tasks/measures/delay.hpp) of one number each, along the reference's
//         furthest way from its first pose 0:
//           position  n . (p - p_R0)                n = p_Rk - p_R0
//           attitude  n . log(q_R0^-1 q)            n = log(q_R0^-1 q_Rk)
//         k the first row in which it is as far from there as anywhere
#include <algorithm>
#include <numbers>

#include "statistics/samples.hpp"
#include "tasks/kinds/arm/pose_following.hpp"
#include "tasks/kinds/arm/segment_poses.hpp"
#include "tasks/measures/delay.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

constexpr double kLeastSeen_percent = 50.0;
constexpr double kLeastWay_m = 0.010;  // as of a movement
constexpr double kLeastTurn_rad = 5.0 * std::numbers::pi / 180.0;
/// Ways that are equal but for rounding: the first of them counts.
constexpr double kAsFar = 1.0 - 1e-6;

class FollowingScore {
 public:
  explicit FollowingScore(const Record& record)
      : record_(record),
        section_(record.select({Phase::active}, columns_of_object_and_reference())) {
    if (!section_.reason.empty() || section_.rows.empty()) return;
    const statistics::Computed seen = seen_percent(record);
    if (!seen.value || *seen.value < kLeastSeen_percent)
      too_little_ = "the object was seen for less than half of the time"_text;
    const SegmentPoses object = object_poses(record.signals());
    const SegmentPoses reference = reference_poses(record.signals());
    for (const std::size_t row : section_.rows) {
      X_WO_.push_back(object.at(row));
      X_WR_.push_back(reference.at(row));
    }
  }

  [[nodiscard]] std::vector<Measure> measures() const {
    std::vector<double> distance_m, angle_rad;
    std::vector<Vec3> moved_R, moved_O, turned_R, turned_O;
    for (std::size_t k = 0; k < X_WR_.size(); ++k) {
      const Pose& first = X_WR_.front();
      distance_m.push_back((X_WO_[k].p - X_WR_[k].p).norm());
      angle_rad.push_back(angle_between(X_WR_[k].q, X_WO_[k].q));
      moved_R.push_back(X_WR_[k].p - first.p);
      moved_O.push_back(X_WO_[k].p - first.p);
      turned_R.push_back(rotation_vector(first.q.conjugate() * X_WR_[k].q));
      turned_O.push_back(rotation_vector(first.q.conjugate() * X_WO_[k].q));
    }
    const auto measure = [this](const char* name, const char* channel, const char* unit,
                                const statistics::Computed& computed) {
      return make_measure(name, channel, unit, section_,
                          too_little_.empty() ? computed : statistics::Computed(too_little_));
    };
    return {measure("rmse", "position", "m", rms(distance_m)),
            measure("rmse", "attitude", "rad", rms(angle_rad)),
            measure("lag", "position", "s",
                    lag_of(moved_R, moved_O, kLeastWay_m, "too short a way"_text)),
            measure("lag", "attitude", "s",
                    lag_of(turned_R, turned_O, kLeastTurn_rad, "too little rotation"_text)),
            seen(record_, section_)};
  }

 private:
  [[nodiscard]] statistics::Computed rms(const std::vector<double>& error) const {
    return rmse(std::vector<double>(error.size(), 0.0), error, section_.weight_s);
  }

  [[nodiscard]] statistics::Computed lag_of(const std::vector<Vec3>& reference,
                                            const std::vector<Vec3>& object, double least,
                                            Words too_little) const {
    if (reference.size() < 2) return "fewer than two samples"_text;
    double furthest = 0.0;
    for (const Vec3& way : reference) furthest = std::max(furthest, way.norm());
    if (!(furthest >= least)) return too_little;
    const Vec3 way = *std::find_if(reference.begin(), reference.end(), [&](const Vec3& one) {
      return one.norm() >= kAsFar * furthest;
    });
    std::vector<double> target, actual;
    for (const Vec3& one : reference) target.push_back(way.dot(one));
    for (const Vec3& one : object) actual.push_back(way.dot(one));
    return lag(statistics::on_uniform_grid(section_.t_s, target),
               statistics::on_uniform_grid(section_.t_s, actual));
  }

  const Record& record_;
  Section section_;
  Text too_little_;  ///< was seen; empty: enough
  std::vector<Pose> X_WO_;
  std::vector<Pose> X_WR_;
};

}  // namespace

std::vector<Measure> score_pose_following(const PoseFollowingSpec&, const Record& record) {
  return FollowingScore(record).measures();
}

}  // namespace isograsp::tasks
