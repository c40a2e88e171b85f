// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped tasks and protocols.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "grasp_model/plan.hpp"
#include "hand/anatomical_axes.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/kinds/object/pose_tracking.hpp"
#include "tasks/measures/fitts.hpp"
#include "tasks/protocol.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::library_test {
namespace {

namespace fs = std::filesystem;
const fs::path kLibrary = fs::path(ISOGRASP_SOURCE_DIR) / "library";

std::vector<fs::path> files_in(const char* folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kLibrary / folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}
/// Of one hand; those of two have tests of their own (tests/bimanual/pressed_by_hands_test.cpp).
std::vector<fs::path> scenes_of_one_hand() {
  auto files = files_in("scenes");
  std::erase_if(files, [](const fs::path& path) {
    return read_text(path).value().find("[hands]") != std::string::npos;
  });
  return files;
}
TaskSpec task(const std::string& name) {
  const std::string path = kLibrary / "tasks" / name;
  const auto text = read_text(path);
  EXPECT_TRUE(text) << path;
  auto parsed = parse_task(*text, path);
  EXPECT_TRUE(parsed) << parsed.error().message();
  return std::move(*parsed);
}

Scene scene(const fs::path& path) {
  const auto text = read_text(path);
  EXPECT_TRUE(text) << path;
  auto parsed = parse_scene(*text, path);
  EXPECT_TRUE(parsed) << parsed.error().message();
  return std::move(*parsed);
}

/// x y z [m] and turns about the world's axes [rad].
using Place = std::array<double, 6>;
Place place(const Vec3& p, double angle_rad) {
  return {p.x(), p.y(), p.z(), 0.0, 0.0, angle_rad};
}
/// Every place to which the task may bring its object.
std::vector<Place> places(const TaskSpec& spec) {
  std::vector<Place> all;
  if (const auto* poses = spec.kind.get_if<PoseTargetsSpec>())
    for (const auto& target : poses->targets) all.push_back(place(target.p_WT, target.angle_rad));
  if (const auto* items = spec.kind.get_if<PickPlaceSpec>())
    for (const auto& item : items->items) {
      all.push_back(place(item.p_WO, 0.0));
      all.push_back(place(item.p_WT, item.angle_rad));
    }
  if (const auto* tracking = spec.kind.get_if<PoseTrackingSpec>()) {
    Place least{};
    Place most{};
    for (const auto& axis : tracking->axes) {
      least[static_cast<std::size_t>(axis.axis)] = axis.least;
      most[static_cast<std::size_t>(axis.axis)] = axis.most;
    }
    all = {least, most};
  }
  return all;
}

TEST(Library, EverySceneCompilesForBothHands) {
  ASSERT_GE(scenes_of_one_hand().size(), 9u);
  for (const auto& path : test::every(scenes_of_one_hand()))
    for (const Hand hand : {Hand::right, Hand::left}) {
      const auto plan = Plan::compile(for_hand(scene(path), hand), 0.01);
      EXPECT_TRUE(plan) << plan.error().message();
    }
}

TEST(Library, EveryTargetCanBeReachedWithTheForceOfAWeakHand) {
  constexpr double kWeak_N = 3.0;
  test::AtLeast places_seen(10);
  test::AtLeast limits_seen(10);
  constexpr double kArm_m = 0.065;  // from thumb to fingers: a couple of forces there turns
  for (const auto& path : test::every(files_in("tasks"))) {
    const TaskSpec spec = task(path.filename());
    // What both hands move is made for the weaker one.
    if (spec.scene().empty() || spec.hands_load() || spec.hands_carry()) continue;
    const Scene object = scene(kLibrary / "scenes" / (spec.scene() + ".toml"));
    for (const Place& to : places(spec)) {
      ++places_seen;
      double squares = 0.0;
      for (std::size_t dof = 0; dof < 6; ++dof) {
        const auto i = static_cast<Eigen::Index>(dof);
        EXPECT_TRUE(object.free[dof] || to[dof] == 0.0) << path << " moves what is locked";
        for (const auto& limit : object.limits) {
          if (static_cast<std::size_t>(limit.dof) != dof) continue;
          ++limits_seen;
          EXPECT_GE(to[dof], limit.least) << path;
          EXPECT_LE(to[dof], limit.most) << path;
        }
        const double rest = dof < 3 ? object.anchor_m[i] : 0.0;
        const double weight_N = dof < 3 ? object.mass_kg * object.gravity_m_s2[i] : 0.0;
        const double needed = object.stiffness[i] * (to[dof] - rest) - weight_N;
        if (!object.free[dof]) continue;
        if (dof < 3)
          squares += needed * needed;
        else
          EXPECT_LE(std::abs(needed) / kArm_m, kWeak_N) << path;
      }
      EXPECT_LE(std::sqrt(squares), kWeak_N) << path;
    }
  }
}

TEST(Library, WhereThereIsNoSpringTheObjectStaysOnlyIfRestingFingersDoNotMoveIt) {
  test::AtLeast without_spring(1);
  for (const auto& path : test::every(scenes_of_one_hand())) {
    const Scene object = scene(path);
    for (std::size_t dof = 0; dof < 6; ++dof)
      if (object.free[dof] && object.stiffness[static_cast<Eigen::Index>(dof)] == 0.0) {
        EXPECT_NE(object.grasp_rule, GraspRule::any) << path;
        EXPECT_GT(object.damping[static_cast<Eigen::Index>(dof)], 0.0) << path;
        ++without_spring;
      }
  }
}

TEST(Library, TheSeriesHasTheDifficultyThatItsCommentStates) {
  const TaskSpec spec = task("target_series.toml");
  const auto& series = spec.kind.as<PoseTargetsSpec>();
  int held = 0;
  for (std::size_t i = 1; i < series.targets.size(); ++i) {
    const double distance_m = (series.targets[i].p_WT - series.targets[i - 1].p_WT).norm();
    const auto difficulty = index_of_difficulty(distance_m, series.position_tolerance_m);
    constexpr double kStated_bit = 2.32;
    EXPECT_WITHIN(*difficulty.value, kStated_bit, 0.005);
    if (series.targets[i].hold_s > 0.0) ++held;
  }
  EXPECT_EQ(held, 12);
  EXPECT_EQ(series.targets.front().hold_s, 0.0);
}

TEST(Library, EveryTaskParsesAndItsSceneIsShipped) {
  ASSERT_GE(files_in("tasks").size(), 18u);
  for (const auto& path : test::every(files_in("tasks"))) {
    const TaskSpec spec = task(path.filename());
    EXPECT_FALSE(spec.name.empty());
    EXPECT_FALSE(spec.instruction.empty());
    if (!spec.scene().empty()) {
      EXPECT_TRUE(fs::exists(kLibrary / "scenes" / (spec.scene() + ".toml"))) << spec.scene();
      EXPECT_FALSE(fs::exists(kLibrary / "tasks" / (spec.scene() + ".toml")))
          << spec.scene() << ": a file beside the task would be taken for the scene";
    }
  }
}

TEST(Library, EveryProtocolNamesShippedTasksAndMeasuresTheMaximumBeforeItIsNeeded) {
  ASSERT_GE(files_in("protocols").size(), 2u);
  test::AtLeast tasks_named(10);
  for (const auto& path : test::every(files_in("protocols"))) {
    const auto text = read_text(path);
    ASSERT_TRUE(text);
    const auto protocol = parse_protocol(*text, path);
    ASSERT_TRUE(protocol) << protocol.error().message();
    bool has_maximum = false;
    for (const auto& step : test::every(protocol->steps)) {
      for (const std::string& name : step.tasks) {
        ++tasks_named;
        const TaskSpec spec = task(name);
        EXPECT_TRUE(has_maximum || !spec.needs_maximum()) << path;
        has_maximum = has_maximum || spec.kind.is<MaximumSpec>();
      }
    }
  }
}

TEST(Library, InEverySceneTheAxesOfTheHandAreUpAndTowardsTheScreenForBothHands) {
  for (const auto& path : test::every(scenes_of_one_hand()))
    for (const Hand hand : {Hand::right, Hand::left})
      for (const Contact& contact : test::every(for_hand(scene(path), hand).contacts)) {
        const auto of = [&](const Vec3& force_W) {
          return anatomical(contact.R_OC.transpose() * force_W, contact.finger, hand);
        };
        EXPECT_EQ(of(contact.R_OC.col(2)), Vec3(1.0, 0.0, 0.0)) << path;
        EXPECT_EQ(of(Vec3::UnitY()), Vec3(0.0, 1.0, 0.0)) << path;
        EXPECT_EQ(of(-Vec3::UnitZ()), Vec3(0.0, 0.0, 1.0)) << path;
      }
}

TEST(Library, TheMirroredTwoTargetTestIsTheMirrorImage) {
  const TaskSpec plain_spec = task("two_target.toml");
  const TaskSpec mirrored_spec = task("two_target_mirrored.toml");
  const auto& plain = plain_spec.kind.as<PoseTargetsSpec>();
  const auto& mirrored = mirrored_spec.kind.as<PoseTargetsSpec>();
  ASSERT_EQ(plain.targets.size(), mirrored.targets.size());
  for (std::size_t i = 0; i < plain.targets.size(); ++i) {
    const PoseTarget& a = plain.targets[i];
    const PoseTarget& b = mirrored.targets[i];
    EXPECT_EQ(Vec3(-a.p_WT.x(), a.p_WT.y(), a.p_WT.z()), b.p_WT);
    EXPECT_EQ(-a.angle_rad, b.angle_rad);
    EXPECT_EQ(a.hold_s, b.hold_s);
    EXPECT_EQ(a.level, b.level);
  }
}

TEST(Library, CoversEveryKeyOfTheTaskAndProtocolFormats) {
  std::string all;
  for (const char* folder : {"tasks", "protocols"})
    for (const auto& path : files_in(folder)) all += *read_text(path);
  for (const char* key : {"name",
                          "instruction",
                          "version",
                          "kind",
                          "duration_s",
                          "lead_in_s",
                          "squeeze_s",
                          "window_s",
                          "frequency_Hz",
                          "least_fraction",
                          "most_fraction",
                          "scene",
                          "position_tolerance_m",
                          "angle_tolerance_deg",
                          "time_limit_s",
                          "position_m",
                          "angle_deg",
                          "hold_s",
                          "level",
                          "preview_s",
                          "dof",
                          "least_m",
                          "most_m",
                          "least_deg",
                          "most_deg",
                          "waveform",
                          "frequencies_Hz",
                          "seed",
                          "forms",
                          "drop_distance_m",
                          "from_m",
                          "to_m",
                          "task",
                          "repetitions",
                          "practice",
                          "rest_s"})
    EXPECT_NE(all.find("\n" + std::string(key) + " = "), std::string::npos) << key;
}

}  // namespace
}  // namespace isograsp::tasks::library_test
