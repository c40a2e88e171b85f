// SPDX-License-Identifier: GPL-3.0-or-later
// The guest's view of the processor's state, on a computer that has more of it than the guest
// knows.
#include <array>
#include <csignal>
#include <cstring>

#include <elf.h>
#include <gtest/gtest.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// The part that every processor with XSAVE has: the legacy area and the header. Any such processor
/// has more than that, as one with tiles has more than the guest knows.
constexpr std::size_t kKnownBytes = 576;
auto* const kState = reinterpret_cast<void*>(static_cast<std::size_t>(NT_X86_XSTATE));

/// A stopped process of our own.
class Traced {
 public:
  Traced() : process_(fork()) {
    if (process_ == 0) {
      ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
      raise(SIGSTOP);
      _exit(0);
    }
    int status = 0;
    waitpid(process_, &status, 0);
  }
  ~Traced() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;
  [[nodiscard]] pid_t process() const { return process_; }

 private:
  pid_t process_;
};

TEST(WholeState, APartOfTheStateIsSetWhereTheKernelItselfTakesOnlyTheWhole) {
  const Traced traced;
  std::array<char, kKnownBytes> part{};
  iovec known{part.data(), part.size()};
  ASSERT_EQ(ptrace(PTRACE_GETREGSET, traced.process(), kState, &known), 0);
  ASSERT_EQ(known.iov_len, part.size());
  ASSERT_NE(syscall(SYS_ptrace, PTRACE_SETREGSET, traced.process(), kState, &known), 0)
      << "this kernel takes a part: the guest does not need our ptrace()";

  constexpr std::size_t kFirstXmm = 160;  // Intel SDM volume 1, table 10-2
  constexpr std::size_t kUsed = 512;      // XSTATE_BV, bit 1: the XMM registers are not initial
  part[kFirstXmm] = 42;
  part[kUsed] = static_cast<char>(part[kUsed] | 2);
  ASSERT_EQ(ptrace(PTRACE_SETREGSET, traced.process(), kState, &known), 0);
  part.fill(0);
  ASSERT_EQ(ptrace(PTRACE_GETREGSET, traced.process(), kState, &known), 0);
  EXPECT_EQ(part[kFirstXmm], 42);
}

TEST(WholeState, OtherRequestsPassAsTheyAre) {
  long word = 0x1234;  // the same address there: the process is a copy of this one
  const Traced copy;
  errno = 0;
  EXPECT_EQ(ptrace(PTRACE_PEEKDATA, copy.process(), &word, nullptr), 0x1234);
  EXPECT_EQ(errno, 0);
}

}  // namespace
