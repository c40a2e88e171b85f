// SPDX-License-Identifier: GPL-3.0-or-later
// A therapist in software: finds the widgets of the therapist's window by name and uses them.
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QListWidget>

#include "gui/library/task_groups.hpp"
#include "gui/windows.hpp"
#include "qt_test.hpp"

namespace isograsp::gui::test {

/// A strapped hand settles for that long, where a test does not ask for the minute itself.
[[nodiscard]] inline GuiConfig settling_soon(GuiConfig config) {
  config.settle_after_strapping_s = 1.0;
  return config;
}

class Operator {
 public:
  /// An act that the session refuses fails the test.
  explicit Operator(Windows& windows) : windows_(windows) {
    QObject::connect(&windows.presenter().flow(), &SessionFlow::failed, &windows.therapist(),
                     [](const QString& why) { ADD_FAILURE() << "refused: " << why.toStdString(); });
  }

  template <class Widget>
  [[nodiscard]] Widget& find(const char* name) const {
    return widget_called<Widget>(name, windows_.therapist());
  }

  /// Waits until the button can be pressed, then presses it with the mouse.
  void press(const char* name) const {
    auto& button = find<QAbstractButton>(name);
    ASSERT_TRUE(wait_until([&] { return button.isEnabled() && button.isVisible(); }))
        << name << " stays disabled: " << windows_.presenter().flow().view().sentence;
    QTest::mouseClick(&button, Qt::LeftButton);
  }

  void choose_device(const QString& uri) const {
    auto& devices = find<QListWidget>("devices");
    for (int row = 0; row < devices.count(); ++row)
      if (devices.item(row)->data(Qt::UserRole).toString() == uri)
        return devices.setCurrentRow(row);
    FAIL() << uri.toStdString() << " is not offered";
  }

  /// Opens a step of the session that is not the next one.
  void open_section(Step step) const {
    const auto number = static_cast<int>(step) + 1;
    auto& head = find<QAbstractButton>(qPrintable(QStringLiteral("section_%1").arg(number)));
    QTest::mouseClick(&head, Qt::LeftButton);
  }

  void disconnect() const {
    // Its step is open by itself until the first forces arrive.
    ASSERT_TRUE(wait_until([&] {
      return windows_.presenter().flow().view().situation != Situation::wait_for_forces;
    }));
    if (!find<QAbstractButton>("connect").isVisible()) open_section(Step::device);
    press("connect");
    ASSERT_TRUE(wait_until([&] { return !windows_.presenter().state().busy(); }));
  }

  /// The first one of this kind, or the one of this name.
  void choose_task(std::string_view kind, std::string_view name = "") const {
    auto& list = find<QListWidget>("tasks");
    for (int row = 0; row < list.count(); ++row) {
      const auto number = list.item(row)->data(Qt::UserRole);
      if (!number.isValid()) continue;  // a heading
      const auto& task = windows_.presenter().state().library.tasks[number.toUInt()];
      if (task.kind->name != kind || (!name.empty() && task.name != name)) continue;
      list.setCurrentRow(row);
      return;
    }
    FAIL() << "the library has no such task";
  }

  void add_patient() const {
    const auto before = windows_.presenter().state().choices.patient;
    windows_.therapist().show_page(TherapistWindow::Page::start);
    press("add_patient");
    ASSERT_TRUE(wait_until([&] { return windows_.presenter().state().choices.patient != before; }));
  }

  /// From an empty window to a hand that may be asked for its maximum.
  void prepare_person(const char* hand = "hand_right") const {
    add_patient();
    press(hand);
    answer_screening();
  }
  /// Nothing applies: of the hand, or of the arm.
  void answer_screening() const {
    const SessionState& state = windows_.presenter().state();
    press(state.measures_arm()    ? "arm_screening_clear"
          : state.measures_hand() ? "hand_screening_clear"
                                  : "screening_clear");
  }

  /// From an empty window to a device that has its zero; tasks are chosen one by one.
  void prepare(const QString& uri, const char* hand = "hand_right") const {
    prepare_person(hand);
    windows_.presenter().choices().choose_protocol(std::nullopt);
    if (windows_.presenter().state().choices.device_uri != uri.toStdString()) choose_device(uri);
    press("connect");
    set_zero();
  }

  void set_zero() const {
    // After the hand was in, this step is done and closed.
    if (!find<QAbstractButton>("zero").isVisible() &&
        windows_.presenter().state().snapshot().zeroed)
      open_section(Step::zero);
    press("zero");
    const auto set = [&] {
      const auto& now = windows_.presenter().state().snapshot();
      return now.zeroed && !now.restarted && windows_.presenter().flow().view().may_choose_task;
    };
    ASSERT_TRUE(wait_until(set)) << windows_.presenter().flow().view().sentence;
  }

  /// From an empty window to two platforms with their zeros; tasks are chosen one by one, or as the
  /// protocol says.
  void prepare_both(const QString& uri, bool one_by_one = true) const {
    add_patient();
    press("hand_both");
    press("left_screening_clear");
    press("right_screening_clear");
    if (one_by_one) windows_.presenter().choices().choose_protocol(std::nullopt);
    choose_platform("platforms_left", uri);
    press("connect");
    set_zero();
    press("crosstalk_skip");
  }
  void choose_platform(const char* list, const QString& uri) const {
    auto& platforms = find<QListWidget>(list);
    for (int row = 0; row < platforms.count(); ++row)
      if (platforms.item(row)->data(Qt::UserRole).toString() == uri)
        return platforms.setCurrentRow(row);
    FAIL() << uri.toStdString() << " is not offered";
  }
  /// The stop is tested, somebody stays, both hands are in.
  void put_both_in() const {
    QTest::keyClick(&windows_.therapist(), Qt::Key_F10);
    press("within_reach");
    press("strapped");
  }

  /// The hand is in and has settled: the resting force can begin.
  void strap_in() const {
    press("strapped");
    ASSERT_TRUE(wait_until([&] { return windows_.presenter().flow().view().may_begin; }))
        << windows_.presenter().flow().view().sentence;
  }

  /// Runs the chosen task to its end.
  void run_task() const {
    start_task();
    finish_task();
  }
  void start_task() const {
    press("start");
    ASSERT_TRUE(wait_until([&] {
      return windows_.presenter().state().snapshot().stage == session::Stage::trial;
    })) << windows_.presenter().flow().view().sentence
        << " / " << find<QLabel>("message").text().toStdString();
  }
  void finish_task() const {
    ASSERT_TRUE(wait_until([&] { return !windows_.presenter().flow().view().may_stop; }, 300));
    ASSERT_TRUE(wait_until([&] { return windows_.presenter().flow().view().may_choose_task; }));
  }

 private:
  Windows& windows_;
};

}  // namespace isograsp::gui::test
