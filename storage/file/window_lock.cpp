// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/window_lock.hpp"

#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

#include "storage/file/database.hpp"

namespace isograsp::storage {

namespace {

constexpr std::size_t kLongestHolder = 300;  // bytes

void write_holder(const std::string& side_file, const std::string& who) {
  const int descriptor =
      ::open(side_file.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return;  // unknown who has it
  (void)!::write(descriptor, who.data(), who.size());
  ::close(descriptor);
}

/// One line of plain letters, whatever stands in the file.
std::string read_holder(const std::string& side_file) {
  const int descriptor = ::open(side_file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return "";
  std::array<char, kLongestHolder> text{};
  const auto length = ::read(descriptor, text.data(), text.size());
  ::close(descriptor);
  std::string line;
  for (ssize_t i = 0; i < length; ++i) {
    const char letter = text[static_cast<std::size_t>(i)];
    if (letter == '\n') break;
    if (static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f') line += letter;
  }
  return line;
}

}  // namespace

WindowLock::WindowLock(WindowLock&&) noexcept = default;
WindowLock& WindowLock::operator=(WindowLock&&) noexcept = default;
WindowLock::~WindowLock() = default;

Result<WindowLock> WindowLock::take(const std::string& database, const std::string& who) {
  std::error_code failure;
  const auto real_path =
      std::filesystem::weakly_canonical(std::filesystem::absolute(database), failure);
  const std::string name = (failure ? database : real_path.string()) + "-window";
  auto lock = RecordingLock::exclusive_if_free(name);
  if (!lock) return lock.error();
  const std::string side_file = name + "-lock";
  WindowLock use;
  if (lock->held()) {
    use.lock_ = std::make_unique<RecordingLock>(*std::move(lock));
    write_holder(side_file, who);
  } else {
    use.holder_ = read_holder(side_file);
  }
  return use;
}

std::string this_program() {
  std::array<char, 256> host{};
  (void)gethostname(host.data(), host.size() - 1);
  const char* user = std::getenv("USER");
  std::array<char, 32> now{};
  const std::time_t time = std::time(nullptr);
  std::tm local{};
  if (localtime_r(&time, &local) != nullptr)
    (void)std::strftime(now.data(), now.size(), "%Y-%m-%d %H:%M", &local);
  return std::string(user == nullptr || *user == '\0' ? "somebody" : user) + " on " + host.data() +
         ", process " + std::to_string(getpid()) + ", since " + now.data();
}

}  // namespace isograsp::storage
