// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/crypto/signature.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <vector>

#include <sodium.h>

#include "core/files.hpp"
#include "core/time.hpp"
#include "storage/crypto/seal.hpp"
#include "storage/crypto/sodium_start.hpp"

namespace isograsp::storage {

namespace {

constexpr std::string_view kSignatureFormat = "isograsp-signature-1";
constexpr std::array<std::string_view, 2> kKindNames{"backup", "export"};
constexpr std::size_t kKeyDigits = 2 * crypto_sign_PUBLICKEYBYTES;
constexpr std::size_t kSignatureDigits = 2 * crypto_sign_BYTES;
constexpr std::size_t kHashDigits = 2 * crypto_hash_sha256_BYTES;
static_assert(kKeySize == crypto_sign_SEEDBYTES);

template <std::size_t Size>
std::string digits_of(const std::array<unsigned char, Size>& bytes) {
  std::string text(2 * Size + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes.data(), Size);
  text.resize(2 * Size);
  return text;
}

/// @pre is_hex(text, 2 * Size)
template <std::size_t Size>
std::array<unsigned char, Size> bytes_in(const std::string& text) {
  std::array<unsigned char, Size> bytes{};
  sodium_hex2bin(bytes.data(), Size, text.data(), text.size(), nullptr, nullptr, nullptr);
  return bytes;
}

const unsigned char* start_of(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

/// What is signed: all lines but the last.
std::string statement_of(const FileSignature& of) {
  std::string text(kSignatureFormat);
  text += "\nkind " + std::string(kKindNames[static_cast<std::size_t>(of.kind)]);
  text += "\nbytes " + std::to_string(of.bytes) + "\nsha256 " + of.sha256;
  if (!of.made_utc.empty()) text += "\nmade " + of.made_utc;
  return text + "\nkey " + of.key + "\n";
}

/// Takes the line "NAME VALUE" off the beginning; nothing: another line stands there.
std::optional<std::string> taken(std::string_view& text, std::string_view name) {
  const auto end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos || !line.starts_with(name) || line.size() <= name.size() ||
      line[name.size()] != ' ')
    return std::nullopt;
  std::string value(line.substr(name.size() + 1));
  text.remove_prefix(end + 1);
  return value;
}

/// The key with its public half behind it, as libsodium takes it.
struct Pair {
  std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
  Secret secret{crypto_sign_SECRETKEYBYTES};
  explicit Pair(const Secret& seed) {
    assert(seed.size() == kKeySize);
    start_sodium();
    crypto_sign_seed_keypair(open.data(), secret.data(), seed.data());
  }
};

}  // namespace

bool is_hex(std::string_view text, std::size_t digits) noexcept {
  return text.size() == digits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

std::string public_key_from(const Secret& seed) {
  return digits_of(Pair(seed).open);
}

FileSignature signed_with(const Secret& seed, FileSignature statement) {
  const Pair pair(seed);
  statement.key = digits_of(pair.open);
  const std::string text = statement_of(statement);
  std::array<unsigned char, crypto_sign_BYTES> signature{};
  crypto_sign_detached(signature.data(), nullptr, start_of(text), text.size(), pair.secret.data());
  statement.signature = digits_of(signature);
  return statement;
}

bool is_genuine(const FileSignature& of) {
  start_sodium();
  if (!is_hex(of.key, kKeyDigits) || !is_hex(of.signature, kSignatureDigits)) return false;
  const std::string text = statement_of(of);
  const auto signature = bytes_in<crypto_sign_BYTES>(of.signature);
  const auto key = bytes_in<crypto_sign_PUBLICKEYBYTES>(of.key);
  return crypto_sign_verify_detached(signature.data(), start_of(text), text.size(), key.data()) ==
         0;
}

std::string written(const FileSignature& signature) {
  return statement_of(signature) + "signature " + signature.signature + "\n";
}

std::optional<FileSignature> signature_in(std::string_view text) {
  FileSignature read;
  std::string_view rest = text;
  const auto format = rest.find('\n');
  if (format == std::string_view::npos) return std::nullopt;
  rest.remove_prefix(format + 1);
  const auto kind = taken(rest, "kind");
  const auto bytes = taken(rest, "bytes");
  const auto hash = taken(rest, "sha256");
  const auto made = taken(rest, "made");
  const auto key = taken(rest, "key");
  const auto signature = taken(rest, "signature");
  if (!kind || !bytes || !hash || !key || !signature) return std::nullopt;
  const auto name = std::find(kKindNames.begin(), kKindNames.end(), *kind);
  if (name == kKindNames.end() || !is_hex(*hash, kHashDigits)) return std::nullopt;
  if (made && !time_of_utc(*made)) return std::nullopt;
  const char* const end = bytes->data() + bytes->size();
  if (std::from_chars(bytes->data(), end, read.bytes).ptr != end) return std::nullopt;
  read.kind = static_cast<SignedKind>(name - kKindNames.begin());
  read.sha256 = *hash;
  read.made_utc = made.value_or("");
  read.key = *key;
  read.signature = *signature;
  if (written(read) != text) return std::nullopt;
  return read;
}

Result<FileHash> hash_of_file(const std::string& path) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  start_sodium();
  auto file = InputFile::open(path);
  if (!file) return file.error();
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  FileHash hash;
  std::vector<char> piece(kPiece);
  for (;;) {
    const auto count = file->read(piece);
    if (count < 0) return failed("cannot be read"_text, "check the disk"_text).at(path);
    if (count == 0) break;
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(piece.data()),
                              static_cast<unsigned long long>(count));
    hash.bytes += static_cast<std::uint64_t>(count);
  }
  std::array<unsigned char, crypto_hash_sha256_BYTES> digest{};
  crypto_hash_sha256_final(&state, digest.data());
  hash.sha256 = digits_of(digest);
  return hash;
}

}  // namespace isograsp::storage
