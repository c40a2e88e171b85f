// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/crypto/content_hash.hpp"

#include <algorithm>
#include <bit>

#include <sodium.h>

#include "storage/crypto/sodium_start.hpp"

namespace isograsp::storage {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are hashed little-endian");

const unsigned char* data_of(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

using Uuid = std::array<std::uint8_t, 16>;

std::string uuid_text(Uuid bytes, unsigned version) {
  bytes[6] = static_cast<std::uint8_t>((bytes[6] & 0x0FU) | (version << 4U));
  bytes[8] = static_cast<std::uint8_t>((bytes[8] & 0x3FU) | 0x80U);  // the variant of RFC 9562
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i == 4 || i == 6 || i == 8 || i == 10) text += '-';
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 0x0FU];
  }
  return text;
}

}  // namespace

struct ContentHasher::State {
  crypto_generichash_state blake2b;
};

ContentHasher::ContentHasher(std::string_view key) : state_(std::make_unique<State>()) {
  start_sodium();
  crypto_generichash_init(&state_->blake2b, key.empty() ? nullptr : data_of(key), key.size(),
                          ContentHash{}.size());
}
ContentHasher::~ContentHasher() = default;

void ContentHasher::add(std::string_view bytes) {
  crypto_generichash_update(&state_->blake2b, data_of(bytes), bytes.size());
}

void ContentHasher::add_number(std::uint64_t number) {
  add({reinterpret_cast<const char*>(&number), sizeof number});
}

void ContentHasher::add_text(std::string_view text) {
  add_number(text.size());
  add(text);
}

ContentHash ContentHasher::hash() {
  ContentHash hash{};
  crypto_generichash_final(&state_->blake2b, hash.data(), hash.size());
  return hash;
}

ContentHash content_hash(std::string_view bytes) {
  start_sodium();
  ContentHash hash{};
  crypto_generichash(hash.data(), hash.size(), data_of(bytes), bytes.size(), nullptr, 0);
  return hash;
}

std::string hex_of(const ContentHash& hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : hash) {
    text += kDigits[byte / kDigits.size()];
    text += kDigits[byte % kDigits.size()];
  }
  return text;
}

std::string random_uuid() {
  start_sodium();
  Uuid bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return uuid_text(bytes, 4);
}

std::string uuid_of(std::string_view name) {
  const ContentHash hash = content_hash(name);
  Uuid bytes{};
  std::copy_n(hash.begin(), bytes.size(), bytes.begin());
  return uuid_text(bytes, 8);
}

}  // namespace isograsp::storage
