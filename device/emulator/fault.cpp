// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/fault.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/csv.hpp"
#include "device/emulator/fault_seconds.hpp"

namespace isograsp {

namespace {

using Kind = Fault::Kind;

/// What a fault's text holds besides its name.
enum class Form : std::uint8_t {
  chance,         // =FINGER:P
  chance_delay,   // =FINGER:P:20ms
  span,           // =FINGER:2s@10s
  optional_span,  // =FINGER[:2s]@5s
  instant,        // =FINGER@5s
  count,          // =FINGER:300@5s
  slope,          // =FINGER:0.1[@0s]
  finger,         // =FINGER
  bus_instant,    // @5s
  bus_span        // :2s@5s
};
struct Word {
  std::string_view name;
  Kind kind;
  Form form;
  std::string_view example;
};
constexpr std::array<Word, 24> kWords{
    {{"lose=FINGER:tx1", Kind::lose_first, Form::chance, "lose=index:tx1:0.01"},
     {"lose=FINGER:tx2", Kind::lose_second, Form::chance, "lose=index:tx2:0.01"},
     {"lose=FINGER:across", Kind::lose_across, Form::chance, "lose=index:across:0.01"},
     {"lose=FINGER:all", Kind::lose_sample, Form::chance, "lose=index:all:0.01"},
     {"swap", Kind::swap, Form::chance, "swap=index:0.01"},
     {"duplicate", Kind::duplicate, Form::chance, "duplicate=index:0.01"},
     {"delay", Kind::delay, Form::chance_delay, "delay=index:0.01:20ms"},
     {"foreign", Kind::foreign, Form::chance, "foreign=index:0.01"},
     {"length", Kind::length, Form::chance, "length=index:0.01"},
     {"answer", Kind::answer, Form::chance, "answer=index:0.01"},
     {"silence", Kind::silence, Form::optional_span, "silence=index:2s@5s"},
     {"dip", Kind::restart, Form::instant, "dip=index@5s"},
     {"reboot", Kind::restart, Form::instant, "reboot=index@5s"},
     {"freeze", Kind::freeze, Form::span, "freeze=thumb:2s@10s"},
     {"burst", Kind::burst, Form::count, "burst=thumb:300@5s"},
     {"drift", Kind::drift, Form::slope, "drift=thumb:0.1"},
     {"saturate", Kind::saturate, Form::span, "saturate=thumb:2s@10s"},
     {"wrongserial", Kind::wrong_serial, Form::finger, "wrongserial=thumb"},
     {"warning", Kind::warning, Form::bus_instant, "warning@5s"},
     {"passive", Kind::passive, Form::bus_instant, "passive@5s"},
     {"busoff", Kind::bus_off, Form::bus_instant, "busoff@5s"},
     {"overflow", Kind::overflow, Form::bus_instant, "overflow@5s"},
     {"stall", Kind::stall, Form::bus_span, "stall:2s@5s"},
     {"unplug", Kind::unplug, Form::bus_span, "unplug:1s@5s"}}};

/// Cuts the text before `separator` off; the whole text if there is none.
std::string_view take_until(std::string_view& text, char separator) {
  const auto end = text.find(separator);
  const auto part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}

bool parse_fingers(std::string_view name, std::array<bool, kFingerCount>& fingers) {
  if (name == "all") {
    fingers.fill(true);
    return true;
  }
  const auto finger = finger_from_name(name);
  if (finger) fingers[index_of(*finger)] = true;
  return finger.has_value();
}

Error bad_fault(std::string_view text, Text what) {
  std::string all;
  for (const auto& word : kWords) all += (all.empty() ? "" : ", ") + std::string(word.example);
  return refused(std::move(what), "write it like one of: %1"_text(all))
      .about("--fault " + std::string(text));
}

}  // namespace

Result<Fault> Fault::parse(std::string_view text) {
  Fault fault;
  std::string_view rest = text;
  std::string_view before_at = take_until(rest, '@');
  const std::string_view at = rest;
  const bool has_at = text.find('@') != std::string_view::npos;
  const bool has_finger = before_at.find('=') != std::string_view::npos;
  std::string name(take_until(before_at, has_finger ? '=' : ':'));
  if (has_finger && !parse_fingers(take_until(before_at, ':'), fault.fingers))
    return bad_fault(text, "there is no such finger"_text);
  if (name == "lose") name += "=FINGER:" + std::string(take_until(before_at, ':'));
  const auto word =
      std::find_if(kWords.begin(), kWords.end(), [&](const Word& w) { return w.name == name; });
  if (word == kWords.end()) return bad_fault(text, "there is no such fault"_text);
  fault.kind = word->kind;
  if (has_finger == fault.of_bus())
    return bad_fault(
        text, has_finger ? "the fault is one of the bus"_text : "the finger is missing"_text);

  const Form form = word->form;
  const bool chance = form == Form::chance || form == Form::chance_delay;
  const bool needs_at = !chance && form != Form::slope && form != Form::finger;
  if (chance) {
    const auto number = take_until(before_at, ':');
    if (!parse_number(number, fault.probability) || !(fault.probability >= 0) ||
        !(fault.probability <= 1))
      return bad_fault(text, "'%1' is not a probability"_text(number));
  }
  if (form == Form::chance_delay && !parse_fault_seconds(take_until(before_at, ':'), fault.amount))
    return bad_fault(text, "the delay is not a time"_text);
  constexpr double kMostFrames = 10'000.0;
  constexpr double kSteepest_N_s = 1000.0;
  if (form == Form::count && (!parse_number(take_until(before_at, ':'), fault.amount) ||
                              !(fault.amount >= 1.0 && fault.amount <= kMostFrames)))
    return bad_fault(text, "the number of frames is not within 1 … 10000"_text);
  if (form == Form::slope && (!parse_number(take_until(before_at, ':'), fault.amount) ||
                              !(std::abs(fault.amount) <= kSteepest_N_s)))
    return bad_fault(text, "the slope is not a number of newtons per second"_text);
  const bool span = form == Form::span || form == Form::bus_span ||
                    (form == Form::optional_span && !before_at.empty());
  if (span && !parse_fault_seconds(take_until(before_at, ':'), fault.duration_s))
    return bad_fault(text, "the duration is not a time in seconds"_text);
  if (!before_at.empty()) return bad_fault(text, "'%1' is too much"_text(before_at));
  if (has_at && (chance || form == Form::finger))
    return bad_fault(text, "the fault has no instant"_text);
  if (needs_at != has_at && form != Form::slope)
    return bad_fault(text, "the instant is missing"_text);
  if (has_at && !parse_fault_seconds(at, fault.at_s))
    return bad_fault(text, "'%1' is not a time in seconds"_text(at));
  return fault;
}

}  // namespace isograsp
