// SPDX-License-Identifier: GPL-3.0-or-later
// A clinic with a short library at a desktop of its own: how its windows are started, led into a
// session and into a trial, and what stands in its file afterwards.
#pragma once

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/gui/short_library.hpp"
#include "tests/support/command.hpp"
#include "tests/windows/desktop.hpp"

namespace isograsp::test {

class ClinicDesk : public testing::Test {
 protected:
  ClinicDesk() {
    const std::string library = make_short_library(desktop_.folder(), "3");
    // A trial that lasts as long as a test wants it to.
    static_cast<void>(desktop_.folder().write(
        "library/tasks/free_handling.toml",
        "format = \"isograsp-task-1\"\nname = \"Free handling\"\ninstruction = \"Move.\"\n"
        "version = 1\nkind = \"observe\"\nscene = \"firm_block\"\nduration_s = 600\n"));
    setenv("ISOGRASP_LIBRARY", library.c_str(), 1);
    setenv("XDG_STATE_HOME", desktop_.folder().path("STATE").c_str(), 1);
  }
  ~ClinicDesk() override {
    unsetenv("ISOGRASP_LIBRARY");
    unsetenv("XDG_STATE_HOME");
  }

  [[nodiscard]] std::string database() const { return desktop_.folder().path("clinic.db"); }
  void start() { desktop_.start({"gui", "--db", database(), "--device", "sim://healthy?seed=7"}); }
  /// One patient with one session.
  void fill() {
    const auto done = isograsp(
        "run --protocol-file " + desktop_.folder().path("library/protocols/first_session.toml") +
        " --device 'sim://healthy?seed=7' --patient P-001 --fast --db " + database());
    ASSERT_EQ(done.status, 0) << done.err;
  }
  /// From an empty clinic to the press of Connect.
  void connect() {
    start();
    ASSERT_TRUE(desktop_.click("add_patient"));
    ASSERT_TRUE(desktop_.click("hand_right"));
    ASSERT_TRUE(desktop_.click("screening_clear"));
    ASSERT_TRUE(desktop_.click("connect"));
  }
  /// … to a device that has its zero, first click to last.
  void open_session() {
    ASSERT_NO_FATAL_FAILURE(connect());
    ASSERT_TRUE(desktop_.click("zero"));
  }
  /// … to a trial of which whole seconds are in the file.
  void open_trial() {
    ASSERT_NO_FATAL_FAILURE(open_session());
    ASSERT_TRUE(desktop_.click("by_hand"));
    ASSERT_TRUE(desktop_.choose("tasks", "Free handling"));
    ASSERT_TRUE(desktop_.click("start"));
    ASSERT_TRUE(desktop_.wait_until([this] {
      return std::atoi(stored("SELECT max(second) FROM signal_blocks").c_str()) >= 2;
    })) << desktop_.seen();
  }
  /// The words that stand in a label.
  [[nodiscard]] std::string words_on(const std::string& name) {
    const auto seen = desktop_.widget(name);
    return seen ? seen->text : "";
  }
  /// Until the sentence of the therapist's window says that.
  [[nodiscard]] bool wait_for_words(const std::string& words) {
    return desktop_.wait_until([&] {
      return words_on("sentence").find(words) != std::string::npos || !desktop_.runs();
    }) && desktop_.runs();
  }
  void expect_end(const Ending& ending, int status = 0) {
    EXPECT_EQ(ending.signal, std::nullopt) << ending.err;
    EXPECT_EQ(ending.status, status) << ending.err;
  }
  void expect_clean_end() {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace(name.begin(), name.end(), '/', '_');
    desktop_.keep_picture(name);
    expect_end(desktop_.close());
  }
  /// What `sqlite3` says of a file, one line.
  [[nodiscard]] static std::string asked(const std::string& file, const std::string& query) {
    return run("sqlite3 -readonly '" + file + "' \"" + query + "\"").out;
  }
  [[nodiscard]] std::string stored(const std::string& query) const {
    return asked(database(), query);
  }
  /// Everything in the file is sound, by a program that comes afterwards.
  void expect_sound() const {
    const auto checked = isograsp("db check " + database());
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  }
  [[nodiscard]] std::vector<std::string> emergency_files() const {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(
             desktop_.folder().path("STATE/isograsp/emergency"), ignored))
      if (entry.path().extension() == ".db") files.push_back(entry.path());
    return files;
  }

  Desktop desktop_;
};

}  // namespace isograsp::test
