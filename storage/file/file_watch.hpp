// SPDX-License-Identifier: GPL-3.0-or-later
// Are the file of an open connection and the files beside it still those that it was opened with,
// and untouched by anything but SQLite? SQLite itself reports nothing when its file is
// unlinked, moved or overwritten. Inside storage/ only.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/text.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

class FileWatch {
 public:
  /// `sql`: in WAL mode, has read. @pre it outlives this
  FileWatch(soci::session& sql, std::string real_path);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// What has happened, for a user: "the file was deleted or moved away". Nothing: all is in place.
  /// Once it has found something it returns that every time. `writing`: inside a write transaction,
  /// when the write-ahead log stands still and can be compared, too. Looks at names, inodes, sizes,
  /// headers and times; microseconds.
  [[nodiscard]] const std::optional<Text>& fault(bool writing);
  /// After a fault, once, outside of a transaction: what was confirmed and stands in the log is
  /// brought into the file of this connection if both are sound, so that no other file can take
  /// that log for its own; and closing the connection will remove nothing.
  void leave();
  /// No name leads to the file any more, and what the connection reads is sound: when it closes,
  /// the file is gone.
  [[nodiscard]] bool is_last_hold() const;

 private:
  struct Picture;
  [[nodiscard]] std::optional<Text> look(bool writing);
  [[nodiscard]] std::optional<Text> look_at_main();
  [[nodiscard]] std::optional<Text> look_at_log(bool writing);

  std::unique_ptr<Picture> before_;
  std::optional<Text> fault_;
  bool sound_ = true;  ///< what the connection reads and writes is what it was opened with
  bool left_ = false;
};

}  // namespace isograsp::storage
