// SPDX-License-Identifier: GPL-3.0-or-later
// Text that only the holder of a key can read, and that nobody can change or move elsewhere
// unnoticed: XChaCha20-Poly1305 (IETF) with a random nonce; and keys from passwords and keys.
// Inside storage/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "storage/crypto/content_hash.hpp"
#include "storage/crypto/secret.hpp"

namespace isograsp::storage {

inline constexpr std::size_t kKeySize = 32;

/// "sealed:1:" and base64 of nonce, ciphertext and tag. `place` says where the text stands (it is
/// authenticated, not stored): a sealed text that was carried elsewhere cannot be opened. The
/// length of the text is hidden up to the next multiple of 64 bytes.
[[nodiscard]] std::string seal(const Secret& key, std::string_view place, std::string_view text);
/// Nothing: another key, another place, or a changed byte.
[[nodiscard]] std::optional<Secret> unseal(const Secret& key, std::string_view place,
                                           std::string_view sealed);
[[nodiscard]] bool is_sealed(std::string_view text);

/// A key of its own for each number, from which neither `key` nor another one follows.
[[nodiscard]] Secret derived_key(const Secret& key, std::uint64_t number);

/// Cost of making a key from a password: Argon2id (RFC 9106).
struct KeyCost {
  std::uint64_t operations = 3;
  std::uint64_t memory_bytes = std::uint64_t{256} << 20;
};
/// As little as Argon2id allows; for tests.
inline constexpr KeyCost kCheapKeyCost{1, 8192};
/// What a file may ask for; more would only stop the program.
[[nodiscard]] bool is_reasonable(const KeyCost& cost);
/// `salt`: 32 hexadecimal digits. Nothing: not enough memory. @pre is_reasonable(cost)
[[nodiscard]] std::optional<Secret> key_from_password(const Secret& password,
                                                      const std::string& salt, const KeyCost& cost);

/// `bytes` random bytes as hexadecimal digits.
[[nodiscard]] std::string random_hex(std::size_t bytes);

/// ContentHasher over parts, each with its length before it, so that no two lists of parts are
/// alike.
class Digest {
 public:
  explicit Digest(const Secret* key = nullptr);
  Digest& add(std::string_view part);
  Digest& add(std::int64_t number);
  [[nodiscard]] std::string hex();  ///< 64 digits; ends the digest

 private:
  ContentHasher hasher_;
};

}  // namespace isograsp::storage
