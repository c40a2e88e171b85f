// SPDX-License-Identifier: GPL-3.0-or-later
// A desktop of its own for one program: an X server without a screen, a window manager, a mouse and
// a keyboard. The program is the executable that a clinic starts; nothing of it is linked here.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {

/// Where a widget is on the screen [pixels], and how it stands.
struct SeenWidget {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool visible = false;
  bool enabled = false;
  std::string text;
};

/// How a program ended: with a status, or by a signal.
struct Ending {
  std::optional<int> status;
  std::optional<int> signal;
  std::string err;  ///< what it said on standard error
};

/// A failure of the desktop itself ends the test program with a message.
class Desktop {
 public:
  explicit Desktop(int width = 1920, int height = 1080);
  ~Desktop();
  Desktop(const Desktop&) = delete;
  Desktop& operator=(const Desktop&) = delete;

  /// Starts the executable; its settings, state and data are in `folder()`.
  void start(const std::vector<std::string>& arguments);
  [[nodiscard]] const TemporaryFolder& folder() const noexcept { return folder_; }

  /// Nothing: there is no such widget, or the program does not answer.
  [[nodiscard]] std::optional<SeenWidget> widget(const std::string& name);
  [[nodiscard]] std::optional<SeenWidget> item(const std::string& list, const std::string& text);
  [[nodiscard]] std::string seen();
  /// How many points of the patient's window have that colour, "8E140E".
  [[nodiscard]] int points_of(const std::string& colour);
  [[nodiscard]] int windows();

  /// Each waits until it can be done, at most two minutes: false then, and the test has failed.
  bool click(const std::string& name);
  bool choose(const std::string& list, const std::string& text);  ///< an item of a list or a choice
  bool wait_for(const std::string& name);                         ///< until it is visible
  bool wait_for_press(const std::string& name);                   ///< until it could be pressed
  bool wait_until(const std::function<bool()>& done);             ///< whatever it is
  void key(const std::string& keys);                              ///< as xdotool names them
  void keep_picture(const std::string& name);                     ///< where pictures are kept

  /// Alt+F4 of the window manager, again while windows are left; then waits for the end.
  Ending close();
  /// Waits until the program has ended by itself; kills it after `seconds`.
  Ending wait_for_end(int seconds = 60);
  [[nodiscard]] bool runs();
  [[nodiscard]] pid_t process() const noexcept { return program_; }

 private:
  [[nodiscard]] std::optional<std::string> ask(const std::string& question);
  [[nodiscard]] std::optional<SeenWidget> look(const std::string& question);
  void press_at(const SeenWidget& place);
  [[nodiscard]] std::string how_it_stands();  ///< for the message of a failure

  TemporaryFolder folder_;
  pid_t server_ = -1;
  pid_t manager_ = -1;
  pid_t program_ = -1;
  int eyes_ = -1;
  std::string display_;
};

}  // namespace isograsp::test
