// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzz targets share: laws, numbers out of the input, files in memory. A target is one
// file with LLVMFuzzerTestOneInput; libFuzzer or replay.cpp feeds it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include "core/result.hpp"

namespace isograsp::fuzz {

/// A law that does not hold is a finding, like a crash.
inline void require(bool holds, const char* law) noexcept {
  if (holds) return;
  std::fprintf(stderr, "broken law: %s\n", law);
  std::abort();
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) noexcept {
  return {reinterpret_cast<const char*>(data), size};
}

/// An error about a file helps only if it says what, what to do, and a line that exists.
inline void require_helpful(const Error& error, std::string_view text) {
  require(!error.what.empty() && !error.remedy.empty(), "an error says what and what to do");
  require(!error.line ||
              (*error.line >= 1 && *error.line <= 1 + std::count(text.begin(), text.end(), '\n')),
          "an error names a line of the file");
}

[[nodiscard]] inline bool same_bits(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Takes numbers off the input; zeros behind its end.
class Numbers {
 public:
  Numbers(const std::uint8_t* data, std::size_t size) noexcept : rest_(data, size) {}

  [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }
  std::uint8_t byte() noexcept {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  template <class T>
  T number() noexcept {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) value = value << 8 | byte();
    return static_cast<T>(value);
  }
  std::span<const std::uint8_t> bytes(std::size_t most) noexcept {
    const auto taken = rest_.first(std::min(most, rest_.size()));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

/// A file that lives in memory and has a path, for readers that open their file themselves.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
    require(descriptor_ >= 0, "there is memory for a file");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void write(std::string_view text) const {
    const auto size = static_cast<ssize_t>(text.size());
    require(ftruncate(descriptor_, size) == 0 &&
                pwrite(descriptor_, text.data(), text.size(), 0) == size,
            "a file in memory takes what is written");
  }
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace isograsp::fuzz
