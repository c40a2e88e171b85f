// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the guest kernel (LD_PRELOAD). Linux 6.1 for user mode knows 2,696 bytes of
// extended processor state. A computer with more (AMX tiles: 11,008 bytes) refuses to set a part of
// it (EFAULT from xstateregs_set in arch/x86/kernel/fpu/regset.c), and the guest ends before its
// first process. This ptrace() reads and sets the whole state and gives the guest the part it
// knows; the rest is zero, which is the initial state of what a program has not used.
#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstring>

#include <dlfcn.h>
#include <elf.h>
#include <sys/ptrace.h>
#include <sys/types.h>
#include <sys/uio.h>

namespace {

/// More than any processor has; the host's kernel takes as much of it as its own state is long.
/// Static, for the guest's stacks are small: the guest has one processor and asks once at a time.
alignas(64) std::array<char, 65536> whole;

using Ptrace = long (*)(int, pid_t, void*, void*);

Ptrace next_ptrace() {
  static const auto next = reinterpret_cast<Ptrace>(dlsym(RTLD_NEXT, "ptrace"));
  return next;
}

long transfer(int request, pid_t process, void* kind, iovec& known) {
  const std::size_t known_bytes = std::min(known.iov_len, whole.size());
  whole.fill(0);
  iovec all{whole.data(), whole.size()};
  if (request == PTRACE_SETREGSET) std::memcpy(whole.data(), known.iov_base, known_bytes);
  const long result = next_ptrace()(request, process, kind, &all);
  if (result != 0) return result;
  known.iov_len = std::min(known_bytes, all.iov_len);
  if (request == PTRACE_GETREGSET) std::memcpy(known.iov_base, whole.data(), known.iov_len);
  return 0;
}

}  // namespace

extern "C" long ptrace(enum __ptrace_request request, ...) noexcept {
  va_list words;
  va_start(words, request);
  const auto process = va_arg(words, pid_t);
  auto* const address = va_arg(words, void*);
  auto* const data = va_arg(words, void*);
  va_end(words);
  const bool state = request == PTRACE_GETREGSET || request == PTRACE_SETREGSET;
  if (state && reinterpret_cast<std::size_t>(address) == NT_X86_XSTATE)
    return transfer(request, process, address, *static_cast<iovec*>(data));
  return next_ptrace()(request, process, address, data);
}
