// SPDX-License-Identifier: GPL-3.0-or-later
// A signature of a whole file, in a file of its own beside it: Ed25519 (RFC 8032) over what it says
// of the file, its SHA-256 (FIPS 180-4) among it. Format: docs/file_formats.md, "Signatures".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "storage/crypto/secret.hpp"

namespace isograsp::storage {

/// What a signature may be of; one of a backup is none of an export.
enum class SignedKind : std::uint8_t { backup, export_list };

struct FileSignature {
  SignedKind kind = SignedKind::backup;
  std::uint64_t bytes = 0;  ///< size of the file
  std::string sha256;       ///< 64 hexadecimal digits
  std::string made_utc;     ///< ISO 8601; empty: not said
  std::string key;          ///< public, 64 hexadecimal digits
  std::string signature;    ///< 128 hexadecimal digits
};

/// Signs with the key that follows from `seed` (kKeySize bytes); all fields but `key` and
/// `signature` are there.
[[nodiscard]] FileSignature signed_with(const Secret& seed, FileSignature statement);
[[nodiscard]] std::string public_key_from(const Secret& seed);
/// It was made by who has the secret part of its key.
[[nodiscard]] bool is_genuine(const FileSignature& signature);

[[nodiscard]] std::string written(const FileSignature& signature);
/// Nothing: not to the byte what written() makes.
[[nodiscard]] std::optional<FileSignature> signature_in(std::string_view text);

struct FileHash {
  std::uint64_t bytes = 0;
  std::string sha256;  ///< 64 hexadecimal digits
};
/// Reads it once, piece by piece.
[[nodiscard]] Result<FileHash> hash_of_file(const std::string& path);

/// So many lower-case hexadecimal digits and nothing else.
[[nodiscard]] bool is_hex(std::string_view text, std::size_t digits) noexcept;

}  // namespace isograsp::storage
