// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console.hpp"

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/language.hpp"

namespace isograsp::app {

namespace {

std::string formed(const char* format, va_list values) {
  va_list again;
  va_copy(again, values);
  const int size = std::vsnprintf(nullptr, 0, format, again);
  va_end(again);
  std::string text(size < 0 ? 0 : static_cast<std::size_t>(size), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, values);
  return text;
}

void write_out(std::FILE* to, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), to);
}

}  // namespace

void print(const char* format, ...) {
  va_list values;
  va_start(values, format);
  write_out(stdout, printable_lines(formed(format, values)));
  va_end(values);
}

void print_aside(const char* format, ...) {
  va_list values;
  va_start(values, format);
  write_out(stderr, printable_lines(formed(format, values)));
  va_end(values);
}

void Lines::add(const Text& line) {
  lines_.push_back(spoken(line));
}

std::string Lines::text() const {
  std::string all;
  for (const auto& line : lines_) all += printable(line) + "\n";
  return all;
}

void print_line(const Text& line) {
  print_lines(line);
}

void print_lines(const Lines& lines) {
  write_out(stdout, lines.text());
}

void print_json(const nlohmann::ordered_json& document) {
  using Json = nlohmann::ordered_json;
  constexpr int kIndent = 2;
  write_out(stdout, document.dump(kIndent, ' ', true, Json::error_handler_t::replace) + "\n");
}

int print_error(const Error& error) {
  print_aside("isograsp: error: %s\n", translated(error, spoken()).c_str());
  return error.code == Error::Code::failed ? 1 : 2;
}

void print_note(const Text& text) {
  print_aside("isograsp: %s\n", printable(spoken("note: %1"_text(text))).c_str());
}

ProgressBar::ProgressBar(Words title)
    : title_(spoken(title)), on_terminal_(isatty(STDERR_FILENO) != 0) {}

void ProgressBar::end() {
  if (drawn_) std::fputc('\n', stderr);
  drawn_ = false;
}

void ProgressBar::show(double fraction, const Text& detail) {
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
  std::fprintf(stderr, "\r\033[K%s [%s] %3d %% %s", printable(title_).c_str(), bar.c_str(),
               static_cast<int>(fraction * 100.0), printable(spoken(detail)).c_str());
  std::fflush(stderr);
}

}  // namespace isograsp::app
