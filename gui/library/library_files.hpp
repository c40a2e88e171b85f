// SPDX-License-Identifier: GPL-3.0-or-later
// The files behind the library page: the shipped library, which is never written, and the clinic's
// own one beside its database. What a stored trial used is never overwritten: Save keeps the former
// file under history/ and gives a task the next version (docs/file_formats.md, "Own library").
// No Qt, no database; any thread, one at a time.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace isograsp::gui {

enum class LibraryKind : std::uint8_t { tasks, scenes, protocols, postures };
inline constexpr std::size_t kLibraryKindCount = 4;
/// Hold for which a scene is compiled when it is checked and described: of a session at 100 Hz [s].
inline constexpr double kLibraryHold_s = 0.01;
/// Its folder: "tasks", "scenes", "protocols", "postures".
[[nodiscard]] std::string_view folder_of(LibraryKind kind) noexcept;

/// One file, shipped or own.
struct LibraryEntry {
  LibraryKind kind = LibraryKind::tasks;
  std::string path;
  std::string name;    ///< for people; that of the file if it cannot be read
  std::string group;   ///< heading among shipped tasks; empty for other kinds
  bool own = false;    ///< may be edited
  bool sound = true;   ///< it can be read without an error
  bool draft = false;  ///< an unsaved text of it is kept
};

/// What stored trials, for a protocol stored sessions, say of a file that is about to be replaced.
struct FileUse {
  bool used = false;  ///< one of them used the text that stands there now
  int newest_version =
      0;  ///< of a task of the new name with another text than the new one; 0: none
};

/// The value of the top-level key `name` or the text with another one. Other lines stay as they
/// are; a key that is absent is put behind `format`.
[[nodiscard]] std::string name_in(std::string_view text);
[[nodiscard]] std::string with_name(std::string_view text, const std::string& name);
[[nodiscard]] std::string with_version(std::string_view text, int version);

class LibraryFiles {
 public:
  LibraryFiles(std::string shipped, std::string own);

  [[nodiscard]] const std::string& shipped() const noexcept { return shipped_; }
  [[nodiscard]] const std::string& own() const noexcept { return own_; }

  /// Own ones first, then the shipped ones by group; each in the order of names.
  [[nodiscard]] std::vector<LibraryEntry> list(LibraryKind kind) const;
  [[nodiscard]] Result<std::string> read(const LibraryEntry& entry) const;

  /// The first problem that keeps the text from being used as that file: the reader's own error, or
  /// a scene, task, file of postures or curve that it names and that cannot be used.
  [[nodiscard]] Result<void> check(LibraryKind kind, const std::string& text,
                                   const std::string& path) const;
  /// Results are compared by the names of their tasks: no two files of a kind may share one.
  [[nodiscard]] Result<void> check_name(LibraryKind kind, const std::string& text,
                                        const std::string& path) const;

  /// A new own file with this text under the next free name "… (copy)"; its version begins at 1.
  /// The curve that a task names is copied, too. Text that cannot be read is taken as it is.
  [[nodiscard]] Result<LibraryEntry> duplicate(const LibraryEntry& entry,
                                               const std::string& text) const;

  /// A new own file STEM.toml, or STEM_2.toml … if that is taken, with this text under its name or,
  /// if another file has that, under "NAME (2)" ….
  [[nodiscard]] Result<LibraryEntry> add(LibraryKind kind, const std::string& stem,
                                         const std::string& text) const;

  struct Saved {
    std::string text;  ///< as it stands in the file: its version may have been raised
    int version = 0;   ///< of a task; 0: other kinds
    bool raised = false;
    std::string kept;  ///< where the former file is now; empty: no trial used it, it is replaced
  };
  /// Replaces an own file, after both checks. `former`: what was read from it; a file that says
  /// something else by now is refused. The draft goes.
  [[nodiscard]] Result<Saved> save(const LibraryEntry& entry, const std::string& former,
                                   const std::string& text, const FileUse& use) const;

  /// Puts an own file away and says where it is; bring_back() undoes that.
  [[nodiscard]] Result<std::string> remove(const LibraryEntry& entry) const;
  [[nodiscard]] Result<void> bring_back(const std::string& removed,
                                        const LibraryEntry& entry) const;

  /// A text being edited, so that no crash loses it.
  [[nodiscard]] Result<void> keep_draft(const LibraryEntry& entry, const std::string& text) const;
  [[nodiscard]] std::optional<std::string> draft(const LibraryEntry& entry) const;
  void drop_draft(const LibraryEntry& entry) const;

 private:
  [[nodiscard]] std::vector<LibraryEntry> files_in(LibraryKind kind, bool own) const;
  /// Names and stems that a new file of the kind cannot have.
  struct Taken {
    std::set<std::string> names;
    std::set<std::string> stems;
  };
  [[nodiscard]] Taken taken(LibraryKind kind) const;
  [[nodiscard]] std::string draft_path(const LibraryEntry& entry) const;
  [[nodiscard]] Result<std::string> put_away(const LibraryEntry& entry, const char* where,
                                             bool copy) const;

  std::string shipped_;
  std::string own_;
};

}  // namespace isograsp::gui
