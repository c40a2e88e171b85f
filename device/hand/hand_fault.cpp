// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_fault.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/csv.hpp"
#include "device/emulator/fault_seconds.hpp"

namespace isograsp {

namespace {

using HandKind = EmulatedHandFault::Kind;

/// What a fault's text holds besides its name.
struct HandFaultWord {
  std::string_view name;
  HandKind kind;
  enum class Detail : std::uint8_t { none, probability, span, step } detail;
  bool needs_instant;  ///< else it has none
  std::string_view example;
};
using HandDetail = HandFaultWord::Detail;
constexpr std::array<HandFaultWord, 10> kHandFaultWords{
    {{"drop", HandKind::drop, HandDetail::probability, false, "drop=0.01"},
     {"malformed", HandKind::malformed, HandDetail::probability, false, "malformed=0.01"},
     {"silence", HandKind::silence, HandDetail::span, true, "silence=2s@5s"},
     {"freeze", HandKind::freeze, HandDetail::span, true, "freeze=2s@5s"},
     {"lose", HandKind::lose, HandDetail::span, true, "lose=100ms@5s"},
     {"flip", HandKind::flip, HandDetail::span, true, "flip=2s@5s"},
     {"nan", HandKind::nan, HandDetail::span, true, "nan=2s@5s"},
     {"clock", HandKind::clock, HandDetail::step, true, "clock=-3s@5s"},
     {"close", HandKind::close, HandDetail::none, true, "close@5s"},
     {"split", HandKind::split, HandDetail::none, false, "split"}}};

Error bad_hand_fault(std::string_view text, Text what) {
  std::string all;
  for (const auto& word : kHandFaultWords)
    all += (all.empty() ? "" : ", ") + std::string(word.example);
  return refused(std::move(what), "write it like one of: %1"_text(all))
      .about("--fault " + std::string(text));
}

}  // namespace

Result<EmulatedHandFault> EmulatedHandFault::parse(std::string_view text) {
  const auto at = text.rfind('@');
  const std::string_view before = text.substr(0, at);
  const auto equals = before.find('=');
  const std::string_view name = before.substr(0, equals);
  const auto word = std::find_if(kHandFaultWords.begin(), kHandFaultWords.end(),
                                 [&](const HandFaultWord& w) { return w.name == name; });
  if (word == kHandFaultWords.end()) return bad_hand_fault(text, "there is no such fault"_text);
  const bool has_detail = equals != std::string_view::npos;
  const std::string_view detail = has_detail ? before.substr(equals + 1) : std::string_view();
  EmulatedHandFault fault;
  fault.kind = word->kind;
  switch (word->detail) {
    case HandDetail::none:
      if (has_detail) return bad_hand_fault(text, "'%1' is too much"_text(detail));
      break;
    case HandDetail::probability:
      if (!parse_number(detail, fault.probability) || !(fault.probability >= 0.0) ||
          !(fault.probability <= 1.0))
        return bad_hand_fault(text, "'%1' is not a probability"_text(detail));
      break;
    case HandDetail::span:
      if (has_detail &&
          (!parse_fault_seconds(detail, fault.duration_s) || !(fault.duration_s > 0.0)))
        return bad_hand_fault(text, "the duration is not a time in seconds"_text);
      break;
    case HandDetail::step:
      if (!parse_fault_jump(detail, fault.step_s) || fault.step_s == 0.0)
        return bad_hand_fault(text, "the jump is not a time in seconds"_text);
      break;
  }
  const bool has_at = at != std::string_view::npos;
  if (has_at && !word->needs_instant) return bad_hand_fault(text, "the fault has no instant"_text);
  if (!has_at && word->needs_instant) return bad_hand_fault(text, "the instant is missing"_text);
  if (has_at && !parse_fault_seconds(text.substr(at + 1), fault.at_s))
    return bad_hand_fault(text, "'%1' is not a time in seconds"_text(text.substr(at + 1)));
  return fault;
}

}  // namespace isograsp
