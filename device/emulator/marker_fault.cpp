// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/marker_fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/csv.hpp"
#include "device/emulator/fault_seconds.hpp"

namespace isograsp {

namespace {

using MarkerKind = EmulatedMarkerFault::Kind;

/// What a fault's text holds besides its name.
struct MarkerFaultWord {
  std::string_view name;
  MarkerKind kind;
  int names;           ///< of markers
  bool needs_instant;  ///< else it has none
  enum class Span : std::uint8_t { none, may, must } span;
  std::string_view example;
};
constexpr std::array<MarkerFaultWord, 11> kMarkerFaultWords{
    {{"drop", MarkerKind::drop, 0, false, MarkerFaultWord::Span::none, "drop=0.01"},
     {"swap", MarkerKind::swap, 2, true, MarkerFaultWord::Span::may, "swap=F1:F2@5s"},
     {"freeze", MarkerKind::freeze, 1, true, MarkerFaultWord::Span::must, "freeze=F1:2s@5s"},
     {"phantom", MarkerKind::phantom, 1, true, MarkerFaultWord::Span::must, "phantom=F1:2s@5s"},
     {"hide", MarkerKind::hide, 1, true, MarkerFaultWord::Span::must, "hide=F1:2s@5s"},
     {"rename", MarkerKind::rename, 2, true, MarkerFaultWord::Span::none, "rename=F1:F9@5s"},
     {"silence", MarkerKind::silence, 0, true, MarkerFaultWord::Span::may, "silence=2s@5s"},
     {"restart", MarkerKind::restart, 0, true, MarkerFaultWord::Span::none, "restart@5s"},
     {"close", MarkerKind::close, 0, true, MarkerFaultWord::Span::none, "close@5s"},
     {"split", MarkerKind::split, 0, false, MarkerFaultWord::Span::none, "split"},
     {"merge", MarkerKind::merge, 0, false, MarkerFaultWord::Span::none, "merge=4"}}};

std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const auto colon = text.find(':');
    parts.emplace_back(text.substr(0, colon));
    if (colon == std::string_view::npos) return parts;
    text.remove_prefix(colon + 1);
  }
}

Error bad_marker_fault(std::string_view text, Text what) {
  std::string all;
  for (const auto& word : kMarkerFaultWords)
    all += (all.empty() ? "" : ", ") + std::string(word.example);
  return refused(std::move(what), "write it like one of: %1"_text(all))
      .about("--fault " + std::string(text));
}

}  // namespace

Result<EmulatedMarkerFault> EmulatedMarkerFault::parse(std::string_view text) {
  const auto at = text.rfind('@');
  const std::string_view before = text.substr(0, at);
  const auto equals = before.find('=');
  const std::string_view name = before.substr(0, equals);
  const auto word = std::find_if(kMarkerFaultWords.begin(), kMarkerFaultWords.end(),
                                 [&](const MarkerFaultWord& w) { return w.name == name; });
  if (word == kMarkerFaultWords.end()) return bad_marker_fault(text, "there is no such fault"_text);
  std::vector<std::string> parts;
  if (equals != std::string_view::npos) parts = parts_of(before.substr(equals + 1));

  EmulatedMarkerFault fault;
  fault.kind = word->kind;
  std::size_t next = 0;
  const auto take = [&]() -> std::string {
    return next < parts.size() ? parts[next++] : std::string();
  };
  if (word->names > 0) fault.marker = take();
  if (word->names > 1) fault.other = take();
  if ((word->names > 0 && fault.marker.empty()) || (word->names > 1 && fault.other.empty()))
    return bad_marker_fault(text, "the name of a marker is missing"_text);
  if (fault.kind == MarkerKind::drop) {
    const std::string number = take();
    if (!parse_number(number, fault.probability) || !(fault.probability >= 0.0) ||
        !(fault.probability <= 1.0))
      return bad_marker_fault(text, "'%1' is not a probability"_text(number));
  }
  if (fault.kind == MarkerKind::merge) {
    constexpr double kMost = 100.0;
    double count = 0.0;
    if (!parse_number(take(), count) || !(count >= 2.0 && count <= kMost) ||
        count != std::floor(count))
      return bad_marker_fault(text, "the number of pictures is not within 2 … 100"_text);
    fault.count = static_cast<int>(count);
  }
  if (word->span != MarkerFaultWord::Span::none && next < parts.size()) {
    if (!parse_fault_seconds(take(), fault.duration_s) || !(fault.duration_s > 0.0))
      return bad_marker_fault(text, "the duration is not a time in seconds"_text);
  } else if (word->span == MarkerFaultWord::Span::must) {
    return bad_marker_fault(text, "the duration is not a time in seconds"_text);
  }
  if (next < parts.size()) return bad_marker_fault(text, "'%1' is too much"_text(parts[next]));
  const bool has_at = at != std::string_view::npos;
  if (has_at && !word->needs_instant)
    return bad_marker_fault(text, "the fault has no instant"_text);
  if (!has_at && word->needs_instant) return bad_marker_fault(text, "the instant is missing"_text);
  if (has_at && !parse_fault_seconds(text.substr(at + 1), fault.at_s))
    return bad_marker_fault(text, "'%1' is not a time in seconds"_text(text.substr(at + 1)));
  return fault;
}

}  // namespace isograsp
