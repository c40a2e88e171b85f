// SPDX-License-Identifier: GPL-3.0-or-later
// A hash of content, 32 bytes: BLAKE2b-256 (Aumasson et al. 2013, RFC 7693), as in Python's
// hashlib.blake2b(…, digest_size=32). And UUIDs, which tell rows of different stations apart.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace isograsp::storage {

using ContentHash = std::array<std::uint8_t, 32>;

[[nodiscard]] ContentHash content_hash(std::string_view bytes);

/// Of content that is given in pieces.
class ContentHasher {
 public:
  /// With a key (at most 64 bytes) only its holders can make the hash.
  explicit ContentHasher(std::string_view key = {});
  ~ContentHasher();
  ContentHasher(const ContentHasher&) = delete;
  ContentHasher& operator=(const ContentHasher&) = delete;
  void add(std::string_view bytes);
  /// Little-endian, eight bytes.
  void add_number(std::uint64_t number);
  /// Its length first: "ab", "c" is not "a", "bc".
  void add_text(std::string_view text);
  /// Call once, at the end.
  [[nodiscard]] ContentHash hash();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] inline std::string_view bytes_of(const ContentHash& hash) noexcept {
  return {reinterpret_cast<const char*>(hash.data()), hash.size()};
}

/// 64 hexadecimal digits.
[[nodiscard]] std::string hex_of(const ContentHash& hash);

/// Version 4 (RFC 9562): random.
[[nodiscard]] std::string random_uuid();
/// Version 8 (RFC 9562): always the same of the same name.
[[nodiscard]] std::string uuid_of(std::string_view name);

}  // namespace isograsp::storage
