// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped library with shorter tasks: whole sessions in seconds.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {

/// Puts `value` behind every "KEY = " at the beginning of a line of a TOML file.
inline void put_everywhere(const std::filesystem::path& path, const std::string& key,
                           const std::string& value) {
  std::ifstream in(path);
  std::ostringstream text;
  for (std::string line; std::getline(in, line);)
    text << (line.starts_with(key + " = ") ? key + " = " + value : line) << "\n";
  in.close();
  std::ofstream(path) << text.str();
}

/// Copies scenes and tasks into `folder` and shortens rest (1.5 s) and sine (`sine_s`). "First
/// session" is a protocol of these alone, and of a maximum.
inline std::string make_short_library(const TemporaryFolder& folder, const char* sine_s = "5") {
  namespace fs = std::filesystem;
  const fs::path library = folder.path("library");
  fs::copy(fs::path(ISOGRASP_SOURCE_DIR) / "library", library, fs::copy_options::recursive);
  put_everywhere(library / "tasks" / "resting_force.toml", "duration_s", "1.5");
  put_everywhere(library / "tasks" / "grip_sine.toml", "duration_s", sine_s);
  std::ofstream(library / "protocols" / "first_session.toml")
      << "format = \"isograsp-protocol-1\"\nname = \"First session\"\n"
         "[[step]]\nkind = \"instrument_zero\"\n"
         "[[step]]\nkind = \"task\"\ntask = \"resting_force.toml\"\n"
         "[[step]]\nkind = \"task\"\ntask = \"maximum_grip.toml\"\n"
         "[[step]]\nkind = \"task\"\ntask = \"grip_sine.toml\"\n";
  return library;
}

/// The shipped library, in which the protocol of an arm takes a quarter of a minute.
inline std::string make_arm_library(const TemporaryFolder& folder) {
  const std::string library = make_short_library(folder, "3");
  const auto write = [&](const std::string& file, const std::string& text) {
    std::ofstream(library + "/" + file) << text;
  };
  write("tasks/arm_range_forearm.toml",
        "format = \"isograsp-task-1\"\nname = \"Range, forearm\"\n"
        "instruction = \"Turn palm down, then palm up. Three times.\"\nversion = 1\n"
        "kind = \"active_range\"\nlink = \"forearm\"\nangle = 3\nlead_in_s = 0.2\n"
        "duration_s = 1.5\n");
  write("tasks/arm_screw.toml",
        "format = \"isograsp-task-1\"\nname = \"Turn an object in and out\"\n"
        "instruction = \"Bring your object onto the other one. Stay there.\"\nversion = 1\n"
        "kind = \"pose_matching\"\npostures = \"screw\"\nway_percent = 50\nsequence = [\"screw\", "
        "\"initial\"]\n"
        "position_tolerance_m = 0.015\nangle_tolerance_deg = 10\nhold_s = 0.3\n"
        "display_s = 0.6\ntime_limit_s = 15\n");
  for (const char* task : {"arm_range_flexion.toml", "arm_range_deviation.toml"})
    put_everywhere(std::filesystem::path(library) / "tasks" / task, "duration_s", "1.5");
  write("protocols/arm_assessment.toml",
        "format = \"isograsp-protocol-1\"\nname = \"Arm, short\"\n"
        "[[step]]\nkind = \"start_posture\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"arm_range_forearm.toml\"\n"
        "[[step]]\nkind = \"task\"\ntask = \"arm_screw.toml\"\n");
  return library;
}

/// The shipped library, in which the protocol of a tracked hand is its entry test, and one object
/// that is placed with help, as often as `placements` says.
inline std::string make_hand_library(const TemporaryFolder& folder, int placements = 1) {
  const std::string library = make_short_library(folder, "3");
  std::ofstream task(library + "/tasks/virtual_place_first.toml");
  task << "format = \"isograsp-task-1\"\nname = \"Place one object\"\n"
          "instruction = \"Bring the object to the blue one. When it is purple, open your hand.\"\n"
          "version = 1\nkind = \"virtual_pick_place\"\nassistance = \"full\"\neases = true\n"
          "level = 1\n";
  for (int k = 0; k < placements; ++k)
    task << "[[placement]]\nobject = \"slim_cuboid\"\ntarget = 1\n";
  std::ofstream(library + "/protocols/hand_assessment.toml")
      << "format = \"isograsp-protocol-1\"\nname = \"Hand, short\"\n"
         "[[step]]\nkind = \"hand_entry\"\n"
         "[[step]]\nkind = \"task\"\ntask = \"virtual_place_first.toml\"\npractice = true\n";
  return library;
}

/// Makes two hands rest for 1.5 s, squeeze with a second between, and follow for `follow_s`; their
/// short protocol is the usual one.
inline void shorten_two_hands(const std::filesystem::path& library, const char* follow_s) {
  const auto tasks = library / "tasks";
  put_everywhere(tasks / "two_hands_rest.toml", "duration_s", "1.5");
  for (const char* key : {"lead_in_s", "rest_s"})
    put_everywhere(tasks / "two_hands_maximum.toml", key, "1");
  for (const char* task : {"two_hands_sum.toml", "two_hands_each.toml"}) {
    put_everywhere(tasks / task, "duration_s", follow_s);
    put_everywhere(tasks / task, "frequency_Hz", "1");
  }
  const auto protocols = library / "protocols";
  put_everywhere(protocols / "two_hands_short.toml", "rest_s", "1");
  std::filesystem::rename(protocols / "two_hands_short.toml",
                          protocols / "two_hands_assessment.toml");
}

/// The shipped library with them.
inline std::string make_two_hands_library(const TemporaryFolder& folder) {
  const std::string library = make_short_library(folder, "3");
  shorten_two_hands(library, "3");
  return library;
}

/// Makes every rest in a protocol of that library one second long.
inline void shorten_rests(const std::string& library, const char* protocol) {
  put_everywhere(std::filesystem::path(library) / "protocols" / protocol, "rest_s", "1");
}

/// Writes 14 s of steady pressing at 100 Hz in which the thumb is silent from 5 s to 9 s.
inline std::string write_recording_with_gap(const TemporaryFolder& folder) {
  std::ostringstream text;
  text << "t_s,thumb_fx_N,thumb_fy_N,thumb_fz_N,index_fx_N,index_fy_N,index_fz_N,"
          "middle_fx_N,middle_fy_N,middle_fz_N\n";
  for (int row = 0; row < 1400; ++row) {
    const bool silent = row >= 500 && row < 900;
    text << row / 100.0 << (silent ? ",,," : ",0,0,4") << ",0,0,2,0,0,2\n";
  }
  return folder.write("gap.csv", text.str());
}

}  // namespace isograsp::test
