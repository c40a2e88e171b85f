// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/crypto/secret.hpp"

#include <array>
#include <cassert>
#include <cstring>
#include <new>

#include <sodium.h>

#include "core/files.hpp"
#include "storage/crypto/sodium_start.hpp"

namespace isograsp::storage {

void Secret::Free::operator()(unsigned char* bytes) const noexcept {
  sodium_free(bytes);
}

Secret::Secret(std::size_t size) : size_(size) {
  start_sodium();
  bytes_.reset(static_cast<unsigned char*>(sodium_malloc(size)));
  if (!bytes_) throw std::bad_alloc();
  sodium_memzero(bytes_.get(), size);
}

Secret::Secret(std::string_view text) : Secret(text.size()) {
  if (!text.empty()) std::memcpy(bytes_.get(), text.data(), text.size());
}

Secret Secret::taken_from(std::string& text) {
  Secret secret{std::string_view(text)};
  sodium_memzero(text.data(), text.size());
  text.clear();
  return secret;
}

Secret Secret::random(std::size_t size) {
  Secret secret(size);
  randombytes_buf(secret.data(), size);
  return secret;
}

Result<Secret> Secret::from_file(const std::string& path) {
  auto file = InputFile::open(path);
  if (!file) return file.error();
  constexpr std::size_t kLongest = 1024;
  Secret all(kLongest + 2);  // with the end of the line, and one more to see that there is more
  const auto count = file->read({reinterpret_cast<char*>(all.data()), all.size()});
  if (count < 0) return refused("cannot be read"_text, "check the disk"_text).at(path);
  const auto size = static_cast<std::size_t>(count);
  const auto* const end = static_cast<const unsigned char*>(std::memchr(all.data(), '\n', size));
  std::size_t length = end != nullptr ? static_cast<std::size_t>(end - all.data()) : size;
  if (length > 0 && all.data()[length - 1] == '\r') --length;
  if (length == 0)
    return refused("its first line is empty"_text, "write the secret there"_text).at(path);
  if (length > kLongest)
    return refused("its first line is too long"_text, "give at most 1024 characters"_text).at(path);
  if (std::memchr(all.data(), '\0', length) != nullptr)
    return refused("holds a zero byte"_text, "write the secret as text"_text).at(path);
  return all.part(0, length);
}

Secret Secret::copy() const {
  return empty() ? Secret() : part(0, size_);
}

std::string_view Secret::text() const noexcept {
  return {reinterpret_cast<const char*>(bytes_.get()), size_};
}

Secret Secret::part(std::size_t begin_at, std::size_t count) const {
  assert(begin_at + count <= size_);
  return Secret(text().substr(begin_at, count));
}

}  // namespace isograsp::storage
