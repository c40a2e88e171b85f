// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <unistd.h>

namespace isograsp {

int print_error(const Error& error) {
  std::fprintf(stderr, "isograsp: error: %s\n", error.message().c_str());
  return error.code == Error::Code::failed ? 1 : 2;
}

void print_note(const std::string& text) {
  std::fprintf(stderr, "isograsp: note: %s\n", text.c_str());
}

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)), on_terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressBar::end() {
  if (drawn_) std::fputc('\n', stderr);
  drawn_ = false;
}

void ProgressBar::show(double fraction, std::string_view detail) {
  if (!on_terminal_) return;
  const auto now_ms = std::chrono::duration_cast<std::chrono::milliseconds>(
                          std::chrono::steady_clock::now().time_since_epoch())
                          .count();
  constexpr long long kRedraw_ms = 100;
  if (drawn_ && fraction < 1.0 && now_ms - last_drawn_ms_ < kRedraw_ms) return;
  last_drawn_ms_ = now_ms;
  drawn_ = true;
  constexpr int kWidth = 30;
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  std::string bar(static_cast<std::size_t>(filled), '#');
  bar.resize(kWidth, '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %3d %% %.*s", title_.c_str(), bar.c_str(),
               static_cast<int>(fraction * 100.0), static_cast<int>(detail.size()), detail.data());
  std::fflush(stderr);
}

}  // namespace isograsp
