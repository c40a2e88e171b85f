// SPDX-License-Identifier: GPL-3.0-or-later
// Waiting for a descriptor with Boost.Asio without allocating: WaitOver is the handler of
// async_wait(), and the one operation that is pending lives in WaitMemory.
//
//   if (!pending_) {
//     pending_ = true;
//     socket_.async_wait(Socket::wait_read, WaitOver{&pending_, &memory_});
//   }
//   io_.run_one_until(...);
//
// One flag and one memory for each descriptor; both must outlive the io_context's last run.
#pragma once

#include <cstddef>
#include <new>

namespace isograsp {

/// Memory for one pending wait: the handler's associated allocator, so that Asio never calls
/// operator new on the real-time path.
class WaitMemory {
 public:
  void* take(std::size_t size) {
    if (used_ || size > sizeof bytes_) throw std::bad_alloc();
    used_ = true;
    return bytes_;
  }
  void give_back() noexcept { used_ = false; }

 private:
  alignas(std::max_align_t) std::byte bytes_[512];
  bool used_ = false;
};

template <class T>
struct WaitAllocator {
  using value_type = T;
  WaitMemory* memory;

  explicit WaitAllocator(WaitMemory* m) noexcept : memory(m) {}
  template <class U>
  WaitAllocator(const WaitAllocator<U>& other) noexcept : memory(other.memory) {}  // NOLINT
  T* allocate(std::size_t n) { return static_cast<T*>(memory->take(n * sizeof(T))); }
  void deallocate(T*, std::size_t) noexcept { memory->give_back(); }
  template <class U>
  bool operator==(const WaitAllocator<U>& other) const noexcept {
    return memory == other.memory;
  }
};

/// Clears a flag when the wait is over, for whatever reason: what happened is found out by reading
/// the descriptor.
struct WaitOver {
  using allocator_type = WaitAllocator<std::byte>;
  bool* pending;
  WaitMemory* memory;
  [[nodiscard]] allocator_type get_allocator() const noexcept { return allocator_type(memory); }
  template <class ErrorCode>
  void operator()(const ErrorCode&) const noexcept {
    *pending = false;
  }
};

}  // namespace isograsp
