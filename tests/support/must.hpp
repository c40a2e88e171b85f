// SPDX-License-Identifier: GPL-3.0-or-later
// What a test takes for granted: a result without its value ends the test with the message.
#pragma once

#include <stdexcept>
#include <utility>

#include "core/result.hpp"

namespace isograsp::test {

/// The value of a successful result; throws std::runtime_error with the message of a failed one.
template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message());
  return std::move(result).value();
}
inline void must(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message());
}

}  // namespace isograsp::test
