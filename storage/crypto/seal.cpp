// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/crypto/seal.hpp"

#include <array>
#include <cassert>
#include <cstring>
#include <vector>

#include <sodium.h>

namespace isograsp::storage {

namespace {

constexpr std::string_view kPrefix = "sealed:1:";
constexpr std::size_t kPad = 64;
constexpr std::size_t kNonce = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
constexpr std::size_t kTag = crypto_aead_xchacha20poly1305_ietf_ABYTES;
constexpr int kBase64 = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
static_assert(kKeySize == crypto_aead_xchacha20poly1305_ietf_KEYBYTES);
static_assert(kKeySize == crypto_kdf_KEYBYTES);

const unsigned char* bytes(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

std::string hex_of(const unsigned char* data, std::size_t size) {
  std::string text(2 * size + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), data, size);
  text.resize(2 * size);
  return text;
}

}  // namespace

std::string seal(const Secret& key, std::string_view place, std::string_view text) {
  assert(key.size() == kKeySize);
  const std::size_t padded_size = (text.size() / kPad + 1) * kPad;
  Secret padded(padded_size);
  if (!text.empty()) std::memcpy(padded.data(), text.data(), text.size());
  std::size_t size = 0;
  sodium_pad(&size, padded.data(), text.size(), kPad, padded_size);
  std::vector<unsigned char> box(kNonce + padded_size + kTag);
  randombytes_buf(box.data(), kNonce);
  crypto_aead_xchacha20poly1305_ietf_encrypt(box.data() + kNonce, nullptr, padded.data(),
                                             padded_size, bytes(place), place.size(), nullptr,
                                             box.data(), key.data());
  std::string encoded(sodium_base64_encoded_len(box.size(), kBase64), '\0');
  sodium_bin2base64(encoded.data(), encoded.size(), box.data(), box.size(), kBase64);
  encoded.pop_back();  // the final zero
  return std::string(kPrefix) + encoded;
}

std::optional<Secret> unseal(const Secret& key, std::string_view place, std::string_view sealed) {
  assert(key.size() == kKeySize);
  if (!is_sealed(sealed)) return std::nullopt;
  sealed.remove_prefix(kPrefix.size());
  if (sealed.size() < kNonce + kPad + kTag) return std::nullopt;
  std::vector<unsigned char> box(sealed.size());
  std::size_t size = 0;
  const char* end = nullptr;
  if (sodium_base642bin(box.data(), box.size(), sealed.data(), sealed.size(), nullptr, &size, &end,
                        kBase64) != 0 ||
      end != sealed.data() + sealed.size() || size < kNonce + kPad + kTag)
    return std::nullopt;
  Secret padded(size - kNonce - kTag);
  if (crypto_aead_xchacha20poly1305_ietf_decrypt(padded.data(), nullptr, nullptr,
                                                 box.data() + kNonce, size - kNonce, bytes(place),
                                                 place.size(), box.data(), key.data()) != 0)
    return std::nullopt;
  std::size_t length = 0;
  if (sodium_unpad(&length, padded.data(), padded.size(), kPad) != 0) return std::nullopt;
  return padded.part(0, length);
}

bool is_sealed(std::string_view text) {
  return text.starts_with(kPrefix);
}

Secret derived_key(const Secret& key, std::uint64_t number) {
  assert(key.size() == kKeySize);
  constexpr char kContext[crypto_kdf_CONTEXTBYTES + 1] = "IsoGrasp";
  Secret derived(kKeySize);
  crypto_kdf_derive_from_key(derived.data(), kKeySize, number, kContext, key.data());
  return derived;
}

bool is_reasonable(const KeyCost& cost) {
  constexpr std::uint64_t kMostOperations = 100;
  constexpr std::uint64_t kMostMemory = std::uint64_t{4} << 30;
  return cost.operations >= crypto_pwhash_argon2id_OPSLIMIT_MIN &&
         cost.operations <= kMostOperations &&
         cost.memory_bytes >= crypto_pwhash_argon2id_MEMLIMIT_MIN &&
         cost.memory_bytes <= kMostMemory;
}

std::optional<Secret> key_from_password(const Secret& password, const std::string& salt,
                                        const KeyCost& cost) {
  assert(is_reasonable(cost));
  std::array<unsigned char, crypto_pwhash_SALTBYTES> salt_bytes{};
  std::size_t size = 0;
  if (sodium_hex2bin(salt_bytes.data(), salt_bytes.size(), salt.data(), salt.size(), nullptr, &size,
                     nullptr) != 0 ||
      size != salt_bytes.size())
    return std::nullopt;
  Secret key(kKeySize);
  if (crypto_pwhash(key.data(), key.size(), password.text().data(), password.size(),
                    salt_bytes.data(), cost.operations, static_cast<std::size_t>(cost.memory_bytes),
                    crypto_pwhash_ALG_ARGON2ID13) != 0)
    return std::nullopt;
  return key;
}

std::string random_hex(std::size_t count) {
  const Secret random = Secret::random(count);
  return hex_of(random.data(), count);
}

Digest::Digest(const Secret* key) : hasher_(key != nullptr ? key->text() : std::string_view()) {}

Digest& Digest::add(std::string_view part) {
  hasher_.add_text(part);
  return *this;
}

Digest& Digest::add(std::int64_t number) {
  return add(std::to_string(number));
}

std::string Digest::hex() {
  const ContentHash hash = hasher_.hash();
  return hex_of(hash.data(), hash.size());
}

}  // namespace isograsp::storage
