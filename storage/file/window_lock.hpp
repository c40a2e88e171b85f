// SPDX-License-Identifier: GPL-3.0-or-later
// Which program works with a database in its windows: one at a time, so that two therapists do not
// change the same records without knowing of each other. Held by the kernel (flock): it ends with
// the program, however that ends.
#pragma once

#include <memory>
#include <string>

#include "core/result.hpp"

namespace isograsp::storage {

class RecordingLock;

class WindowLock {
 public:
  /// Takes the file for this program, if no other has it. `who`: what the others are told.
  /// Errors: failed, if it cannot be known (the folder is read-only).
  [[nodiscard]] static Result<WindowLock> take(const std::string& database, const std::string& who);
  WindowLock(WindowLock&&) noexcept;
  WindowLock& operator=(WindowLock&&) noexcept;
  ~WindowLock();

  [[nodiscard]] bool held() const noexcept { return lock_ != nullptr; }
  /// Who has it, if it is not held; empty: not known.
  [[nodiscard]] const std::string& holder() const noexcept { return holder_; }

 private:
  WindowLock() = default;
  std::unique_ptr<RecordingLock> lock_;
  std::string holder_;
};

/// "ada on station-2, process 4711, since 2026-03-05 14:02": this program.
[[nodiscard]] std::string this_program();

}  // namespace isograsp::storage
