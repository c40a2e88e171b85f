// SPDX-License-Identifier: GPL-3.0-or-later
// Starts storage_writer and reads what it says.
#pragma once

#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isograsp::storage {

class WriterProcess {
 public:
  /// `largest_file`: no file may grow beyond this many bytes (0: no limit), as on a full disk.
  /// `pause_ms`: after each second.
  explicit WriterProcess(const std::string& database, const std::string& seconds = "1000000",
                         rlim_t largest_file = 0, const std::string& trials = "1",
                         const std::string& pause_ms = "0") {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
      if (largest_file > 0) {
        std::signal(SIGXFSZ, SIG_IGN);  // the write then fails instead
        const rlimit limit{largest_file, largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
      }
      dup2(ends[1], STDOUT_FILENO);
      execl(STORAGE_WRITER, STORAGE_WRITER, database.c_str(), seconds.c_str(), trials.c_str(),
            pause_ms.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
  }
  WriterProcess(const WriterProcess&) = delete;
  WriterProcess& operator=(const WriterProcess&) = delete;
  ~WriterProcess() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    close(output_);
  }

  /// Waits until it has said `line`; false if it ended before.
  bool wait_for(const std::string& line) {
    while (said_.find(line + "\n") == std::string::npos)
      if (!read_some()) return false;
    return true;
  }
  /// kill -9 now; everything it said until then.
  std::string kill_and_read() {
    kill(process_, SIGKILL);
    return end_and_read();
  }
  /// Waits for its end; everything it said.
  std::string end_and_read() {
    while (read_some()) {
    }
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    exit_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return said_;
  }
  [[nodiscard]] int exit_status() const { return exit_status_; }

 private:
  bool read_some() {
    char buffer[4096];
    const auto count = read(output_, buffer, sizeof buffer);
    if (count > 0) said_.append(buffer, static_cast<std::size_t>(count));
    return count > 0;
  }

  pid_t process_ = -1;
  int output_ = -1;
  int exit_status_ = -1;
  std::string said_;
};

/// How many lines start with `word`.
inline int count_lines(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = text.find('\n', at);
    if (end == std::string::npos) break;
    if (text.compare(at, word.size(), word) == 0) ++count;
    at = end + 1;
  }
  return count;
}

}  // namespace isograsp::storage
