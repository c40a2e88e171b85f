// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/recorded_target.hpp"

#include <cmath>
#include <numbers>

#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/waveform.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/object_play.hpp"

namespace isograsp::tasks::recorded_target_test {
namespace {

constexpr double kRate_Hz = 100.0;

TaskSpec pose_task(const std::string& axes) {
  return parse_task(
             "format = \"isograsp-task-1\"\nname = \"follow\"\ninstruction = \"do\"\nkind = "
             "\"pose_tracking\"\nscene = \"block\"\nlead_in_s = 2\nduration_s = 20\n" +
                 axes,
             "follow.toml")
      .value();
}

/// Somebody who is on the target in every frame.
Signals on_target(const TaskSpec& spec) {
  return test::play_object(spec, [](const TaskView& view, const Pose&) {
    return test::Handled{view.object().pose_target_shown ? view.object().X_WT : Pose{}};
  });
}

/// What the axis of `spec` asks at t_s of its movement.
std::vector<double> asked(const PoseTrackingSpec& spec, std::size_t axis) {
  auto values = samples_of(spec.axes[axis].waveform, spec.duration_s, 1.0 / kRate_Hz, 0);
  for (double& value : values)
    value = std::lerp(spec.axes[axis].least, spec.axes[axis].most, value);
  return values;
}

constexpr const char* kTwoAxes =
    "[[axis]]\ndof = \"x\"\nleast_m = -0.08\nmost_m = 0.08\nfrequency_Hz = 0.1\n"
    "[[axis]]\ndof = \"rz\"\nleast_deg = -40\nmost_deg = 60\nfrequency_Hz = 0.2\n";

TEST(TargetByDoing, OfWhoFollowedATargetIsThatTarget) {
  const TaskSpec spec = pose_task(kTwoAxes);
  const auto text = target_by_doing(spec, on_target(spec), {"again"});
  ASSERT_TRUE(text.ok()) << text.error().message();
  const auto again = parse_task(*text, "again.toml");
  ASSERT_TRUE(again.ok()) << again.error().message();
  const auto& made = again->kind.as<PoseTrackingSpec>();
  const auto& given = spec.kind.as<PoseTrackingSpec>();
  EXPECT_EQ(made.scene, "block");
  ASSERT_EQ(made.axes.size(), 2u);
  EXPECT_EQ(made.axes[0].axis, 0);
  EXPECT_EQ(made.axes[1].axis, 5);
  EXPECT_WITHIN(made.duration_s, given.duration_s, 0.5) << "but for the stillness at both ends";
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto before = asked(given, axis);
    const auto after = asked(made, axis);
    const double range = given.axes[axis].most - given.axes[axis].least;
    // The movement begins slowly: what counts as still is up to 2 % of the range, 0.3 s.
    double best = 1.0;
    for (std::size_t shift = 0; shift < 60; ++shift) {
      double worst = 0.0;
      for (std::size_t k = 0; k + shift < before.size() && k < after.size(); ++k)
        worst = std::max(worst, std::abs(after[k] - before[k + shift]) / range);
      best = std::min(best, worst);
    }
    constexpr double kLinear = 0.01;  // ten points a second of 0.2 Hz: (0.1 pi 0.2)^2 / 2, and ends
    EXPECT_LT(best, kLinear) << axis;
  }
}

TEST(TargetByDoing, TwiceAsSlowLastsTwiceAsLong) {
  const TaskSpec spec = pose_task(kTwoAxes);
  const Signals signals = on_target(spec);
  const auto duration_s = [&](double slower) {
    const auto text = target_by_doing(spec, signals, {"again", false, slower});
    return parse_task(text.value(), "again").value().kind.as<PoseTrackingSpec>().duration_s;
  };
  EXPECT_WITHIN(duration_s(2.0), 2.0 * duration_s(1.0), 0.002) << "written with five digits";
}

TEST(TargetByDoing, TremorIsNoTarget) {
  const TaskSpec spec = pose_task("[[axis]]\ndof = \"y\"\nleast_m = 0\nmost_m = 0.1\n");
  const Signals still = on_target(spec);
  Signals shaken;
  for (const auto& name : still.names()) {
    std::vector<double> column(still.column(name).begin(), still.column(name).end());
    for (std::size_t k = 0; name == "actual_y_m" && k < column.size(); ++k)
      column[k] +=
          0.005 * std::sin(2.0 * std::numbers::pi * 8.0 * static_cast<double>(k) / kRate_Hz);
    shaken.add_column(name, column);
  }
  const auto made = [&](const Signals& signals) {
    const auto text = target_by_doing(spec, signals, {"again"});
    return parse_task(text.value(), "again").value().kind.as<PoseTrackingSpec>().axes[0];
  };
  EXPECT_WITHIN(made(shaken).most, made(still).most, 0.0005) << "8 Hz is damped 256 times";
}

TEST(TargetByDoing, TakesTheForceInNewtonsOfTheTasksChannel) {
  const auto spec = parse_task(
      "format = \"isograsp-task-1\"\nname = \"press\"\ninstruction = \"do\"\nkind = "
      "\"force_tracking\"\nchannel = \"index\"\nleast_fraction = 0.1\nmost_fraction = 0.3\n",
      "press.toml");
  std::vector<double> t_s;
  std::vector<double> phase;
  std::vector<double> force_N;
  for (int k = 0; k < 1000; ++k) {
    t_s.push_back(k / kRate_Hz);
    phase.push_back(1.0);
    force_N.push_back(4.0 - 2.0 * std::cos(2.0 * std::numbers::pi * 0.2 * k / kRate_Hz));
  }
  Signals signals;
  signals.add_column("t_s", t_s);
  signals.add_column("phase", phase);
  signals.add_column("actual_force_N", force_N);
  const auto text = target_by_doing(*spec, signals, {"again \"quoted\""});
  ASSERT_TRUE(text.ok()) << text.error().message();
  const auto again = parse_task(*text, "again").value();
  EXPECT_EQ(again.name, "again quoted");
  const auto& made = again.kind.as<ForceTrackingSpec>();
  EXPECT_EQ(name_of(made.aim.channel), "index");
  EXPECT_EQ(made.aim.scale, Scale::newton);
  EXPECT_WITHIN(made.least, 2.0, 0.01);
  EXPECT_WITHIN(made.most, 6.0, 0.01);
}

TEST(TargetByDoing, RefusesWhatHardlyMovedAndWhatTurnedAboutTwoAxes) {
  const TaskSpec spec = pose_task(kTwoAxes);
  const auto why = [&](const Signals& signals) {
    const auto text = target_by_doing(spec, signals, {"again"});
    return text.ok() ? std::string() : english(text.error().what);
  };
  const auto still =
      test::play_object(spec, [](const TaskView&, const Pose&) { return test::Handled{}; });
  EXPECT_NE(why(still).find("moved by less than"), std::string::npos);
  const auto turned = test::play_object(spec, [](const TaskView& view, const Pose&) {
    const double angle = 0.1 * view.task_time_s;
    const Vec3 axis = Vec3(1.0, 1.0, 0.0).normalized();
    return test::Handled{Pose{Vec3::Zero(), Quat(Eigen::AngleAxisd(angle, axis))}};
  });
  EXPECT_NE(why(turned).find("more than one axis"), std::string::npos);
  EXPECT_NE(why(Signals({"t_s"})).find("no path"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::tasks::recorded_target_test
