// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_all.hpp"

#include <atomic>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <vector>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/console.hpp"
#include "app/language.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/paper/qt_application.hpp"
#include "reports/paper/report_writer.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::app {

namespace {

namespace fs = std::filesystem;

/// What the processes share: who comes next, how many are done, the first error.
struct Shared {
  std::atomic<std::size_t> next{0};
  std::atomic<int> done{0};
  std::atomic<int> failed{0};
  std::atomic<bool> told{false};
  char error[1024] = {};  ///< written once, by the process that set `told`
};
static_assert(std::atomic<std::size_t>::is_always_lock_free);

/// Memory that stays common after fork().
class SharedMemory {
 public:
  SharedMemory()
      : memory_(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS,
                     -1, 0)),
        shared_(memory_ == MAP_FAILED ? nullptr : new (memory_) Shared) {}
  ~SharedMemory() {
    if (shared_ != nullptr) munmap(memory_, sizeof(Shared));
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  [[nodiscard]] Shared* get() const noexcept { return shared_; }

 private:
  void* memory_;
  Shared* shared_;
};

void tell_error(Shared& shared, const Error& error) {
  ++shared.failed;
  if (!shared.told.exchange(true))
    std::strncpy(shared.error, translated(error, spoken()).c_str(), sizeof shared.error - 1);
}

Result<void> write_one(storage::SessionStore& store, const std::string& code,
                       const ReportAllOptions& options) {
  auto content = reports::gather_progress(store, code);
  if (!content) return content.error();
  const std::string path = fs::path(options.folder) / (code + "." + options.format);
  const auto writer = reports::make_report_writer(*std::move(content), path, spoken());
  return reports::write_all(*writer, path);
}

/// The work of one process.
void work(const std::vector<std::string>& codes, const ReportAllOptions& options, Shared& shared) {
  const auto store = storage::open_store_to_read(options.database);
  if (!store) return tell_error(shared, store.error());
  reports::ensure_qt_application();
  for (std::size_t i = shared.next++; i < codes.size(); i = shared.next++) {
    if (const auto written = write_one(**store, codes[i], options); !written)
      tell_error(shared, written.error());
    ++shared.done;
  }
}

Result<std::vector<std::string>> codes_of(const std::string& database) {
  // Closed before the processes part: a connection must not be used by two.
  const auto store = storage::open_store_to_read(database);
  if (!store) return store.error();
  const auto patients = (*store)->patients();
  if (!patients) return patients.error();
  std::vector<std::string> codes;
  for (const auto& patient : *patients) codes.push_back(patient.code);
  return codes;
}

/// True while `child` runs; a child that crashed counts as an error.
bool is_running(pid_t& child, Shared& shared) {
  if (child == 0) return false;
  int status = 0;
  if (waitpid(child, &status, WNOHANG) == 0) return true;
  child = 0;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    tell_error(shared, failed("a process that writes reports ended unexpectedly"_text,
                              "write them again, with --threads 1"_text));
  return false;
}

}  // namespace

Result<void> write_all_reports(const ReportAllOptions& options) {
  const auto codes = codes_of(options.database);
  if (!codes) return codes.error();
  std::error_code failure;
  fs::create_directories(options.folder, failure);
  if (failure)
    return failed("cannot be made: %1"_text(Known{failure.message()}), "choose another folder"_text)
        .at(options.folder);
  const SharedMemory memory;
  if (memory.get() == nullptr)
    return failed("no memory for the processes"_text, "close other programs"_text);
  Shared& shared = *memory.get();
  std::vector<pid_t> children;
  const pid_t parent = getpid();
  for (int i = 0; i < options.threads; ++i) {
    const pid_t child = fork();
    if (child < 0) break;
    if (child == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // no process goes on if the command is killed
      if (getppid() != parent) _exit(1);
      work(*codes, options, shared);
      _exit(0);  // the parent's exit handlers do not run here
    }
    children.push_back(child);
  }
  if (children.empty())
    return failed("no process could be started"_text, "close other programs"_text);
  ProgressBar bar("Reports"_text);
  const auto count = static_cast<int>(codes->size());
  for (bool running = true; running;) {
    running = false;
    for (auto& child : children) running = is_running(child, shared) || running;
    bar.show(static_cast<double>(shared.done) / std::max(1, count),
             "%1 of %2"_text(shared.done.load(), count));
    constexpr useconds_t kLook_us = 20000;
    if (running) usleep(kLook_us);
  }
  bar.end();
  if (shared.failed == 0 && shared.done == count) return {};
  return failed("%1 of %2 reports are missing; first: %3"_text(
                    std::max<int>(shared.failed, count - shared.done), count, shared.error),
                "mend the cause and write the reports again"_text)
      .at(options.folder);
}

}  // namespace isograsp::app
