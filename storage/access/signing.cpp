// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/signing.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>

#include <sodium.h>
#include <unistd.h>

#include "core/files.hpp"
#include "core/staging_folder.hpp"
#include "storage/access/clinic_key.hpp"

namespace isograsp::storage {

namespace fs = std::filesystem;

namespace {

/// Number of the seed among the keys that follow from that of the audit log; part of the format.
constexpr std::uint64_t kSigningKey = 1;
constexpr std::size_t kDigitsOfKey = 2 * kKeySize;  // of the secret half and of the public one

/// Nothing: there is none, or it is no key.
std::optional<Secret> seed_in(const std::string& path) {
  auto line = Secret::from_file(path);
  if (!line || !is_hex(line->text(), kDigitsOfKey)) return std::nullopt;
  Secret seed(kKeySize);
  sodium_hex2bin(seed.data(), seed.size(), line->text().data(), line->size(), nullptr, nullptr,
                 nullptr);
  return seed;
}

/// Who may write the database may sign; who may only read it may not.
void let_writers_read(const std::string& key, const std::string& database) {
  give_permissions_of(database, key);
  std::error_code ignored;
  const auto of_database = fs::status(database, ignored).permissions();
  auto mode = fs::perms::owner_read | fs::perms::owner_write;
  if ((of_database & fs::perms::group_write) != fs::perms::none) mode |= fs::perms::group_read;
  if ((of_database & fs::perms::others_write) != fs::perms::none) mode |= fs::perms::others_read;
  fs::permissions(key, mode, ignored);
}

/// Of several programs that make it at once, one wins. Problems are ignored: then there is none.
void make_seed(const std::string& path, const std::string& database) {
  const auto staging = StagingFolder::beside(path);
  if (!staging || !write_text(staging->file(), random_hex(kKeySize) + "\n")) return;
  let_writers_read(staging->file(), database);
  if (::link(staging->file().c_str(), path.c_str()) != 0) return;
  static_cast<void>(sync_path(fs::path(path).parent_path()));
}

bool is_something(const std::string& path) {
  std::error_code failure;
  const auto status = fs::symlink_status(path, failure);
  if (!fs::exists(status)) return false;
  return !fs::is_regular_file(status) || fs::file_size(path, failure) > 0;
}

struct Opened {
  Database database;
  std::shared_ptr<LoginState> state;
};

Result<Opened> opened_to_sign(const std::string& path) {
  auto database = Database::open(path, OpenMode::read_only);
  if (!database) return database.error();
  std::shared_ptr<LoginState> state;
  const auto read = database->guard("opening"_text, [&] { state = login_state_of(*database); });
  if (!read) return read.error();
  return Opened{*std::move(database), std::move(state)};
}

}  // namespace

std::string signature_file_of(const std::string& file) {
  return file + ".sig";
}

std::string signing_key_file_of(const std::string& database) {
  return database + "-signing-key";
}

std::optional<Secret> signing_seed(const Database& database, const LoginState& state, bool make) {
  if (state.is_protected()) {
    const Login login = state.login();
    if (!login.keys) return std::nullopt;
    return derived_key(login.keys->audit, kSigningKey);
  }
  const std::string path = signing_key_file_of(database.real_path());
  std::error_code ignored;
  if (make && !fs::exists(fs::symlink_status(path, ignored))) make_seed(path, database.real_path());
  return seed_in(path);
}

Result<FileSignature> signature_of(const Secret& seed, const std::string& file, SignedKind kind,
                                   const std::string& made_utc) {
  auto hash = hash_of_file(file);
  if (!hash) return hash.error();
  return signed_with(seed, {kind, hash->bytes, hash->sha256, made_utc, "", ""});
}

Result<std::string> public_key_of(const std::string& database) {
  const auto opened = opened_to_sign(database);
  if (!opened) return opened.error();
  const auto seed = signing_seed(opened->database, *opened->state, false);
  return seed ? public_key_from(*seed) : std::string();
}

Result<std::string> sign_file(const std::string& database, const std::string& file, SignedKind kind,
                              const std::string& made_utc) {
  const auto opened = opened_to_sign(database);
  if (!opened) return opened.error();
  const auto seed = signing_seed(opened->database, *opened->state, true);
  if (!seed) return std::string();
  const auto made = signature_of(*seed, file, kind, made_utc);
  if (!made) return made.error();
  if (const auto stored = write_text(signature_file_of(file), written(*made)); !stored)
    return stored.error();
  return made->key;
}

Result<FileSignature> check_signature(const std::string& file, SignedKind kind,
                                      const std::string& key) {
  if (!key.empty() && !is_hex(key, kDigitsOfKey))
    return refused("is no public key"_text,
                   "give its 64 digits, as isograsp db audit prints them"_text)
        .about("--key");
  if (const auto there = InputFile::open(file); !there) return there.error();
  const std::string beside = signature_file_of(file);
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(beside, ignored)))
    return failed("is not signed: there is no file of this name with .sig behind it"_text,
                  "take one that is signed"_text)
        .at(file);
  const auto text = read_text(beside);
  if (!text) return text.error();
  const auto signature = signature_in(*text);
  if (!signature || !is_genuine(*signature))
    return failed("is no signature of isograsp, or was altered"_text,
                  "take a copy that is as it was made"_text)
        .at(beside);
  if (signature->kind != kind)
    return failed("is a signature of something else"_text,
                  "take the one that was made with it"_text)
        .at(beside);
  if (!key.empty() && signature->key != key)
    return failed("is signed with another key: %1"_text(signature->key),
                  "take one that this clinic has made"_text)
        .at(file);
  const auto size = fs::file_size(file, ignored);  // before the hash, which takes its time
  const auto hash = size == signature->bytes ? hash_of_file(file) : FileHash{};
  if (!hash) return hash.error();
  if (signature->bytes != hash->bytes || signature->sha256 != hash->sha256)
    return failed("is not what was signed: it was altered, or is another file"_text,
                  "take a copy that is as it was made"_text)
        .at(file);
  if (kind == SignedKind::backup)
    for (const char* log : {"-wal", "-journal"})
      if (is_something(file + log))
        return failed("a log of changes stands beside it, which is not signed"_text,
                      "move %1 away"_text(file + log))
            .at(file);
  return *signature;
}

}  // namespace isograsp::storage
