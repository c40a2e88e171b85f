// SPDX-License-Identifier: GPL-3.0-or-later
// What the acquisition thread may ask of Linux so that other programs do not delay it: the
// scheduling class SCHED_FIFO, memory that is never paged out, and a stack whose pages exist
// already.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp::session {

enum class Realtime : std::uint8_t {
  off,     ///< asks for nothing
  prefer,  ///< takes what is allowed and says what that was
  require  ///< all of it, or an error
};
[[nodiscard]] std::string_view name_of(Realtime wish) noexcept;
[[nodiscard]] std::optional<Realtime> realtime_from_name(std::string_view name) noexcept;

/// What a thread was given.
struct RealtimeGrant {
  bool asked = false;
  int fifo_priority = 0;       ///< 0: ordinary scheduling
  Text fifo_refusal;           ///< why
  bool memory_locked = false;  ///< of the whole process
  Text memory_refusal;
};
/// "SCHED_FIFO 40, memory locked"; "ordinary scheduling (not permitted), memory not locked (…)".
/// Empty if nothing was asked for.
[[nodiscard]] Text words_of(const RealtimeGrant& grant);

/// The calling thread asks for itself and touches the stack that it may come to use. An error only
/// where real time is required and refused; it names the limits to raise.
[[nodiscard]] Result<RealtimeGrant> enter_realtime(Realtime wish);

}  // namespace isograsp::session
