// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped tasks and protocols.
#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tasks/protocol.hpp"

namespace isograsp {
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
TaskSpec task(const std::string& name) {
  const std::string path = kLibrary / "tasks" / name;
  const auto text = read_text(path);
  EXPECT_TRUE(text) << path;
  auto parsed = parse_task(*text, path);
  EXPECT_TRUE(parsed) << parsed.error().message();
  return std::move(*parsed);
}

TEST(Library, EveryTaskParsesAndItsSceneIsShipped) {
  ASSERT_GE(files_in("tasks").size(), 6u);
  for (const auto& path : files_in("tasks")) {
    const TaskSpec spec = task(path.filename());
    EXPECT_FALSE(spec.name.empty());
    EXPECT_FALSE(spec.instruction.empty());
    if (!spec.scene().empty()) {
      EXPECT_TRUE(fs::exists(kLibrary / "scenes" / (spec.scene() + ".toml"))) << spec.scene();
    }
  }
}

TEST(Library, EveryProtocolNamesShippedTasksAndMeasuresTheMaximumBeforeItIsNeeded) {
  ASSERT_GE(files_in("protocols").size(), 2u);
  for (const auto& path : files_in("protocols")) {
    const auto text = read_text(path);
    ASSERT_TRUE(text);
    const auto protocol = parse_protocol(*text, path);
    ASSERT_TRUE(protocol) << protocol.error().message();
    bool has_maximum = false;
    for (const auto& step : protocol->steps) {
      for (const std::string& name : step.tasks) {
        const TaskSpec spec = task(name);
        EXPECT_TRUE(has_maximum || !spec.needs_maximum()) << path;
        has_maximum = has_maximum || std::holds_alternative<MaximumSpec>(spec.kind);
      }
    }
  }
}

TEST(Library, TheMirroredTwoTargetTestIsTheMirrorImage) {
  const TaskSpec plain_spec = task("two_target.toml");
  const TaskSpec mirrored_spec = task("two_target_mirrored.toml");
  const auto& plain = std::get<PoseTargetsSpec>(plain_spec.kind);
  const auto& mirrored = std::get<PoseTargetsSpec>(mirrored_spec.kind);
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
                          "task",
                          "repetitions",
                          "practice",
                          "rest_s"})
    EXPECT_NE(all.find("\n" + std::string(key) + " = "), std::string::npos) << key;
}

}  // namespace
}  // namespace isograsp
