// SPDX-License-Identifier: GPL-3.0-or-later
// A program that protects a database is ended at any statement: the file is as it was, or protected
// with a recovery key that somebody holds or can get.
#include <csignal>
#include <cstdlib>
#include <fstream>

#include <sqlite3.h>
#include <sys/wait.h>

#include "storage/access/protection.hpp"
#include "tests/storage/protected_clinic.hpp"

namespace isograsp::storage::protect_kill_test {
namespace {

namespace fs = std::filesystem;

// Of the child process, which has one thread.
int statements_begun = 0;
int statements_allowed = 0;

int count_statement(unsigned, void*, void*, void*) {
  if (++statements_begun > statements_allowed) std::raise(SIGKILL);
  return 0;
}

int watch(sqlite3* connection, char**, const sqlite3_api_routines*) {
  return sqlite3_trace_v2(connection, SQLITE_TRACE_STMT, count_statement, nullptr);
}

Secret passphrase() {
  return secret("the clinic's passphrase");
}

/// Protects `path`, with the recovery key on `paper` before it opens anything. Status of the
/// process; `statements`: after so many it is ended.
int protect_in_child(const std::string& path, const std::string& paper, int statements) {
  const pid_t child = fork();
  if (child == 0) {
    statements_begun = 0;
    statements_allowed = statements;
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(watch));
    auto done = protect_database(path, passphrase(), &kCheapKeyCost);
    if (!done) _exit(1);
    std::ofstream(paper) << done->recovery_key.text();
    if (!accept_recovery_key(*done->access, done->recovery_key)) _exit(2);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

std::string opens_with(const std::string& path, const Secret& key) {
  return refusal(must(Access::open(path))->log_in_with_recovery_key(key));
}

/// What is wrong with the file that is left; empty: nothing.
std::string wrong_with(const std::string& path, const std::string& paper, bool& was_protected) {
  was_protected = is_protected_database(path);
  std::unique_ptr<Access> access;
  if (was_protected) {
    access = must(Access::open(path));
    must(access->log_in_with_passphrase(passphrase()));
  }
  {
    const auto store = opened(path, OpenMode::existing);
    if (!must(store->check()).empty()) return "the file is not sound";
    if (must(store->profile(1)).notes != "SECRETNOTE") return "its text is another";
  }
  if (!was_protected) return "";
  const bool told = !access->notices().empty();
  access.reset();
  std::ifstream in(paper);
  const std::string shown{std::istreambuf_iterator<char>(in), {}};
  if (!told) {
    if (shown.empty()) return "nobody has seen the recovery key, and nothing says so";
    return opens_with(path, Secret{std::string_view(shown)});
  }
  // The login said that there is none: protecting it again makes one, and finishes the work.
  auto again = must(protect_database(path, passphrase(), &kCheapKeyCost));
  if (again.recovery_key.empty()) return "no recovery key is made";
  must(accept_recovery_key(*again.access, again.recovery_key));
  again.access.reset();
  if (bytes_of(path).find("SECRETNOTE") != std::string::npos) return "plain text is left";
  return opens_with(path, again.recovery_key);
}

TEST(ProtectKilled, AtAnyStatementLeadsToTheFileOfBeforeOrToARecoveryKey) {
  const TemporaryFolder folder;
  const std::string plain = folder.file("plain.db");
  {
    const auto store = opened(plain);
    const RowId patient = must(store->add_patient("P-1")).id;
    must(store->set_profile(patient, {Side::left, {}, "", "SECRETNOTE", ""}));
    must(store->end_session(must(store->begin_session(example_session(patient)))));
  }
  // scripts/test --long sets it: every statement, else one in kStep.
  constexpr int kStep = 13;
  const int step = std::getenv("ISOGRASP_LONG") != nullptr ? 1 : kStep;
  int killed = 0;
  int left_protected = 0;
  int status = 1;
  for (int statements = 0; status != 0; statements += step) {
    const TemporaryFolder place;
    const std::string path = place.file("clinic.db");
    fs::copy_file(plain, path);
    status = protect_in_child(path, place.file("paper"), statements);
    ASSERT_TRUE(status == 0 || WIFSIGNALED(status)) << "it failed by itself at " << statements;
    killed += status != 0 ? 1 : 0;
    bool was_protected = false;
    EXPECT_EQ(wrong_with(path, place.file("paper"), was_protected), "") << statements;
    left_protected += was_protected ? 1 : 0;
  }
  EXPECT_GT(killed, 10);
  EXPECT_GT(left_protected, 2) << "of those that were ended some had got their keys";
  EXPECT_LT(left_protected, killed);
}

}  // namespace
}  // namespace isograsp::storage::protect_kill_test
