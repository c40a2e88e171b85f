// SPDX-License-Identifier: GPL-3.0-or-later
// Passphrases, passwords, PINs and keys in memory that is locked, fenced, kept out of core dumps
// and wiped when it is given back.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp::storage {

/// Bytes that nobody else should see. Never copied by accident; Secret::copy() says so.
class Secret {
 public:
  Secret() = default;
  explicit Secret(std::size_t size);  ///< zeros
  explicit Secret(std::string_view text);
  /// Takes the text and wipes it where it stood.
  [[nodiscard]] static Secret taken_from(std::string& text);
  /// Random bytes of the operating system.
  [[nodiscard]] static Secret random(std::size_t size);
  /// First line of a small file, without its end. Refused: an empty line, more than 1024
  /// characters, a zero byte. Errors name the file, never what it holds.
  [[nodiscard]] static Result<Secret> from_file(const std::string& path);
  [[nodiscard]] Secret copy() const;

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] unsigned char* data() noexcept { return bytes_.get(); }
  [[nodiscard]] const unsigned char* data() const noexcept { return bytes_.get(); }
  [[nodiscard]] std::string_view text() const noexcept;
  /// `count` bytes from `begin` on, as a secret of their own. @pre they exist
  [[nodiscard]] Secret part(std::size_t begin, std::size_t count) const;

 private:
  struct Free {
    void operator()(unsigned char* bytes) const noexcept;  ///< wipes
  };
  std::unique_ptr<unsigned char[], Free> bytes_;
  std::size_t size_ = 0;
};

}  // namespace isograsp::storage
