// SPDX-License-Identifier: GPL-3.0-or-later
// A protected database with an administrator's login, a therapist and a researcher.
#pragma once

#include "storage/access/accounts.hpp"
#include "storage/access/audit_log.hpp"
#include "tests/storage/examples.hpp"

namespace isograsp::storage {

inline Secret secret(const char* text) {
  return Secret{std::string_view(text)};
}

/// Somebody has the recovery key on paper.
inline Access::Protected make_protected(const std::string& path) {
  auto made = must(Access::create(path, secret("the clinic's passphrase"), &kCheapKeyCost));
  must(accept_recovery_key(*made.access, made.recovery_key));
  return made;
}

struct ProtectedClinic : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::int64_t now_s = 1'800'000'000;
  Secret recovery_key;
  std::unique_ptr<Access> access;

  ProtectedClinic() {
    auto made = make_protected(path);
    recovery_key = std::move(made.recovery_key);
    access = std::move(made.access);
    must(add_user(*access, "Ada", Role::administrator, secret("ada's password"), kCheapKeyCost));
    must(add_user(*access, "Theo", Role::therapist, secret("theo's password"), kCheapKeyCost));
    must(add_user(*access, "Rita", Role::researcher, secret("rita's password"), kCheapKeyCost));
  }
  /// The same file as a program that was started anew sees it: nobody logged in.
  void restart() {
    access.reset();
    access = must(Access::open(path, [this] { return now_s; }));
  }
  void as(const char* name) {
    std::string password = name;
    password[0] = static_cast<char>(password[0] - 'A' + 'a');
    must(access->log_in(name, secret((password + "'s password").c_str())));
  }
};

/// Why something was refused; empty: it was not.
template <class T>
std::string refusal(const Result<T>& result) {
  return result ? "" : result.error().message();
}

}  // namespace isograsp::storage
