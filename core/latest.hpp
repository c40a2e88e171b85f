// SPDX-License-Identifier: GPL-3.0-or-later
// Latest<T>: a triple buffer. One thread publishes, another reads the newest; neither ever waits.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace isograsp {

template <class T>
class Latest {
  static_assert(std::is_copy_assignable_v<T>);

 public:
  /// Writer thread only. Wait-free; copies `value`.
  void publish(const T& value) noexcept(std::is_nothrow_copy_assignable_v<T>) {
    slots_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) &
            kIndex;
  }

  /// Reader thread only. Wait-free; the reference holds until the next call.
  [[nodiscard]] const T& read() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::uint8_t kIndex = 3;
  std::array<T, 3> slots_{};
  std::uint8_t back_ = 0;                ///< the writer's
  std::uint8_t front_ = 1;               ///< the reader's
  std::atomic<std::uint8_t> middle_{2};  ///< handed over; kFresh: not yet read
};

}  // namespace isograsp
