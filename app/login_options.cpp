// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/login_options.hpp"

#include <filesystem>

#include "app/console.hpp"

namespace isograsp::app {

namespace {

Result<void> log_in_to(storage::Access& access, const LoginOptions& options) {
  if (options.user.empty() != options.password_file.empty())
    return refused("a name and a password belong together"_text,
                   "give --user and --password-file"_text)
        .about("--user");
  const bool by_passphrase = !options.passphrase_file.empty();
  const bool by_recovery = !options.recovery_key_file.empty();
  if (by_passphrase && by_recovery)
    return refused("stands beside a passphrase"_text, "give one of them"_text)
        .about("--recovery-key-file");
  if (by_passphrase || by_recovery) {
    const auto secret = storage::Secret::from_file(by_passphrase ? options.passphrase_file
                                                                 : options.recovery_key_file);
    if (!secret) return secret.error();
    auto done = by_passphrase ? access.log_in_with_passphrase(*secret)
                              : access.log_in_with_recovery_key(*secret);
    if (!done || options.user.empty()) return done;
  }
  // A user who is named beside the passphrase is the one who acts: the log names people.
  const auto password = storage::Secret::from_file(options.password_file);
  if (!password) return password.error();
  return access.log_in(options.user, *password);
}

Result<std::unique_ptr<storage::Access>> logged_in(Result<std::unique_ptr<storage::Access>> access,
                                                   const std::string& database,
                                                   const LoginOptions& options,
                                                   bool is_copy = false) {
  if (!access) return access.error();
  const bool asks = (*access)->is_protected();
  if (asks && !options.given())
    return refused("is protected"_text,
                   "give --passphrase-file, or --user and --password-file"_text)
        .at(database);
  if (!asks && options.given())
    return refused("is not protected: it asks for no login"_text, "leave the login out"_text)
        .at(database);
  if (asks)
    if (const auto done = log_in_to(**access, options); !done) return done.error();
  if (!is_copy)
    for (const Text& notice : (*access)->notices()) print_note(notice);
  return access;
}

using Open = Result<std::unique_ptr<storage::Access>> (*)(const std::string&);

Result<std::unique_ptr<storage::Access>> log_in_if_asked(const std::string& database,
                                                         const LoginOptions& options, Open open) {
  if (storage::is_protected_database(database)) return logged_in(open(database), database, options);
  std::error_code ignored;
  if (options.given())
    return refused(std::filesystem::exists(database, ignored)
                       ? "is not protected: it asks for no login"_text
                       : "does not exist, and is not made with protection here"_text,
                   std::filesystem::exists(database, ignored)
                       ? "leave the login out, or check the name of the file"_text
                       : "make it with isograsp db init --protected"_text)
        .at(database);
  return std::unique_ptr<storage::Access>();
}

}  // namespace

void LoginOptions::add_to(Subcommand command) {
  command.option("--passphrase-file", passphrase_file,
                 "File with the clinic's passphrase (protected databases)");
  command.option("--user", user, "Account that works (protected databases)");
  command.option("--password-file", password_file, "File with the password of --user");
  command.option("--recovery-key-file", recovery_key_file,
                 "File with the printed recovery key, in place of the passphrase");
}

bool LoginOptions::given() const noexcept {
  return !passphrase_file.empty() || !user.empty() || !password_file.empty() ||
         !recovery_key_file.empty();
}

Result<std::unique_ptr<storage::Access>> log_in(const std::string& database,
                                                const LoginOptions& options) {
  return log_in_if_asked(database, options,
                         [](const std::string& file) { return storage::Access::open(file); });
}

Result<std::unique_ptr<storage::Access>> log_in_to_migrate(const std::string& database,
                                                           const LoginOptions& options) {
  return log_in_if_asked(database, options, storage::Access::open_to_migrate);
}

Result<std::unique_ptr<storage::Access>> open_access(const std::string& database,
                                                     const LoginOptions& options, bool is_copy) {
  return logged_in(storage::Access::open(database), database, options, is_copy);
}

}  // namespace isograsp::app
