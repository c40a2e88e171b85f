// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/windows/desktop.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isograsp::test {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// A hand settles for a minute of it; the rest is for a busy computer.
constexpr auto kPatience = 120s;
constexpr auto kLookAgain = 20ms;
constexpr int kAnswerTime_ms = 30'000;  ///< a window that paints a whole report answers late
constexpr int kInheritedEyes = 9;       ///< descriptor of the program

[[noreturn]] void give_up(const std::string& what) {
  std::fprintf(stderr, "the desktop of the test: %s\n", what.c_str());
  std::exit(1);
}

bool waited_until(const std::function<bool()>& done, std::chrono::seconds longest = kPatience) {
  const auto end = Clock::now() + longest;
  while (!done()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(kLookAgain);
  }
  return true;
}

/// `prepare` runs in the child before the program begins.
pid_t spawn(const std::vector<std::string>& line, const std::function<void()>& prepare = {}) {
  const pid_t child = fork();
  if (child < 0) give_up("no process can be started");
  if (child > 0) return child;
  std::vector<char*> words;
  for (const auto& word : line) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  if (prepare) prepare();
  execvp(words[0], words.data());
  _exit(127);
}

int write_to(const std::string& path) {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

std::string contents(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

void end(pid_t& process) {
  if (process < 0) return;
  kill(process, SIGTERM);
  waitpid(process, nullptr, 0);
  process = -1;
}

}  // namespace

Desktop::Desktop(int width, int height) {
  // A number of its own: servers that look for a free one at the same time take it from each other.
  static int made = 0;
  constexpr int kFirst = 1000;
  display_ = ":" + std::to_string(kFirst + getpid() * 8 % 50'000 + made++ % 8);
  const auto size = std::to_string(width) + "x" + std::to_string(height) + "x24";
  server_ = spawn({"Xvfb", display_, "-screen", "0", size, "-nolisten", "tcp", "-noreset"}, [this] {
    const int out = write_to(folder_.path("xvfb.log"));
    dup2(out, STDERR_FILENO);
  });
  const auto asked = "DISPLAY=" + display_ + " xdotool getmouselocation >/dev/null 2>&1";
  if (!waited_until([&] { return std::system(asked.c_str()) == 0; }))
    give_up("Xvfb does not start: " + contents(folder_.path("xvfb.log")));
  manager_ = spawn({"openbox", "--sm-disable"}, [this] {
    setenv("DISPLAY", display_.c_str(), 1);
    setenv("HOME", folder_.path("").c_str(), 1);
    const int out = write_to(folder_.path("openbox.log"));
    dup2(out, STDERR_FILENO);
    dup2(out, STDOUT_FILENO);
  });
}

Desktop::~Desktop() {
  if (program_ > 0) {
    kill(program_, SIGKILL);
    waitpid(program_, nullptr, 0);
  }
  if (eyes_ >= 0) ::close(eyes_);
  end(manager_);
  end(server_);
}

void Desktop::start(const std::vector<std::string>& arguments) {
  int pair[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) give_up("no socket");
  if (eyes_ >= 0) ::close(eyes_);
  eyes_ = pair[0];
  std::vector<std::string> line{ISOGRASP_EXECUTABLE};
  line.insert(line.end(), arguments.begin(), arguments.end());
  program_ = spawn(line, [&] {
    dup2(pair[1], kInheritedEyes);
    setenv("DISPLAY", display_.c_str(), 1);
    setenv("ISOGRASP_EYES", std::to_string(kInheritedEyes).c_str(), 1);
    setenv("QT_PLUGIN_PATH", ISOGRASP_EYES_FOLDER, 1);
    setenv("QT_QPA_GENERIC_PLUGINS", "isograsp_eyes", 1);
    setenv("QT_QPA_PLATFORM", "xcb", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    unsetenv("WAYLAND_DISPLAY");
    for (const char* name : {"CONFIG", "DATA", "STATE", "CACHE"})
      setenv(("XDG_" + std::string(name) + "_HOME").c_str(), folder_.path(name).c_str(), 1);
    const int out = write_to(folder_.path("program.err"));
    dup2(out, STDERR_FILENO);
  });
  ::close(pair[1]);
}

std::optional<std::string> Desktop::ask(const std::string& question) {
  const std::string sent = question + "\n";
  if (send(eyes_, sent.data(), sent.size(), MSG_NOSIGNAL) < 0) return {};
  std::string answer;
  for (;;) {
    pollfd ready{eyes_, POLLIN, 0};
    if (poll(&ready, 1, kAnswerTime_ms) <= 0) return {};
    char buffer[4096];
    const auto count = read(eyes_, buffer, sizeof buffer);
    if (count <= 0) return {};
    answer.append(buffer, static_cast<std::size_t>(count));
    if (answer.back() == '\n') break;
  }
  answer.pop_back();
  return answer;
}

std::optional<SeenWidget> Desktop::look(const std::string& question) {
  const auto answer = ask(question);
  if (!answer) return {};
  SeenWidget seen;
  std::istringstream in(*answer);
  if (!(in >> seen.x >> seen.y >> seen.width >> seen.height >> seen.visible >> seen.enabled))
    return {};
  std::getline(in >> std::ws, seen.text);
  return seen;
}

std::optional<SeenWidget> Desktop::widget(const std::string& name) {
  return look("widget " + name);
}

std::optional<SeenWidget> Desktop::item(const std::string& list, const std::string& text) {
  return look("item " + list + " " + text);
}

std::string Desktop::seen() {
  return ask("seen").value_or("");
}

std::string Desktop::how_it_stands() {
  return runs() ? seen() : "the program has ended: " + contents(folder_.path("program.err"));
}

int Desktop::points_of(const std::string& colour) {
  return std::atoi(ask("points " + colour).value_or("0").c_str());
}

bool Desktop::wait_until(const std::function<bool()>& done) {
  return waited_until(done);
}

int Desktop::windows() {
  return std::atoi(ask("windows").value_or("0").c_str());
}

void Desktop::press_at(const SeenWidget& place) {
  const auto line = "DISPLAY=" + display_ + " xdotool mousemove " +
                    std::to_string(place.x + place.width / 2) + " " +
                    std::to_string(place.y + place.height / 2) + " click 1";
  if (std::system(line.c_str()) != 0) give_up("xdotool does not work");
}

bool Desktop::click(const std::string& name) {
  std::optional<SeenWidget> last;
  const bool there = waited_until([&] {
    const auto now = widget(name);
    const bool ready = now && now->visible && now->enabled;
    // It stands still: a page that is still being laid out would be missed.
    const bool still = ready && last && last->x == now->x && last->y == now->y;
    last = now;
    return still || !runs();
  });
  if (!there || !runs()) {
    keep_picture("failed");
    ADD_FAILURE() << name << " cannot be pressed: " << how_it_stands();
    return false;
  }
  press_at(*last);
  return true;
}

bool Desktop::choose(const std::string& list, const std::string& text) {
  const auto box = widget(list);
  if (box && item(list, text) && !item(list, text)->visible && !click(list)) return false;
  const bool there = waited_until([&] {
    const auto now = item(list, text);
    return (now && now->visible && now->enabled && now->height > 0) || !runs();
  });
  if (!there || !runs()) {
    keep_picture("failed");
    ADD_FAILURE() << list << " has no " << text << ": " << how_it_stands();
    return false;
  }
  press_at(*item(list, text));
  return true;
}

bool Desktop::wait_for(const std::string& name) {
  const bool there = waited_until([&] {
    const auto now = widget(name);
    return (now && now->visible) || !runs();
  });
  if (!there || !runs()) {
    keep_picture("failed");
    ADD_FAILURE() << name << " does not appear: " << how_it_stands();
  }
  return there && runs();
}

bool Desktop::wait_for_press(const std::string& name) {
  const bool there = waited_until([&] {
    const auto now = widget(name);
    return (now && now->visible && now->enabled) || !runs();
  });
  if (!there || !runs()) {
    keep_picture("failed");
    ADD_FAILURE() << name << " stays disabled: " << how_it_stands();
  }
  return there && runs();
}

void Desktop::key(const std::string& keys) {
  if (std::system(("DISPLAY=" + display_ + " xdotool key " + keys).c_str()) != 0)
    give_up("xdotool does not work");
}

void Desktop::keep_picture(const std::string& name) {
  const char* folder = std::getenv("ISOGRASP_TEST_PICTURES");
  if (folder == nullptr) return;
  const auto line = "mkdir -p '" + std::string(folder) + "' && DISPLAY=" + display_ +
                    " import -window root '" + folder + "/" + name + ".png' 2>/dev/null";
  if (std::system(line.c_str()) != 0) std::fprintf(stderr, "no picture of %s\n", name.c_str());
}

bool Desktop::runs() {
  siginfo_t info{};
  return program_ > 0 &&
         waitid(P_PID, static_cast<id_t>(program_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == 0;
}

Ending Desktop::close() {
  constexpr auto kBetween = 2s;  // a session is written to its end in it, and nobody presses twice
  const auto end = Clock::now() + kPatience;
  while (runs() && Clock::now() < end) {
    key("alt+F4");
    (void)waited_until([this] { return !runs(); }, kBetween);
  }
  return wait_for_end(1);
}

Ending Desktop::wait_for_end(int seconds) {
  if (!waited_until([this] { return !runs(); }, std::chrono::seconds(seconds))) {
    ADD_FAILURE() << "the program does not end: " << seen();
    keep_picture("failed");
    kill(program_, SIGKILL);
  }
  int status = 0;
  waitpid(program_, &status, 0);
  program_ = -1;
  Ending ending;
  if (WIFEXITED(status)) ending.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
  ending.err = contents(folder_.path("program.err"));
  return ending;
}

}  // namespace isograsp::test
