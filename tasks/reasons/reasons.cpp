// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reasons/reasons.hpp"

#include "tasks/reasons/stored_text.hpp"

namespace isograsp::tasks {

Text reason_words(std::string_view stored) {
  return stored_text(stored, kColumnMissing, kNotReached, kTooFewRows, kMaximumUnknown);
}

}  // namespace isograsp::tasks
