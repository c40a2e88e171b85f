// SPDX-License-Identifier: GPL-3.0-or-later
// The map of the house (docs/rooms.txt), and its sources.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace isograsp::architecture {

using Names = std::set<std::string>;

struct Room {
  std::string path;    ///< "gui/words"; "gui": the files beside the rooms
  Names without = {};  ///< "Qt", "widgets", folders that the others may include
};

struct Folder {
  std::string name;
  Names uses;               ///< other folders
  Names libraries;          ///< in headers and sources
  Names source_libraries;   ///< in .cpp files, and in headers that are for their room only
  std::vector<Room> rooms;  ///< from the ground up; one at least

  /// Of a file of this folder: the last of its rooms whose path it has. Never outside rooms.
  [[nodiscard]] std::size_t room_of(const std::string& file) const;
};

class House {
 public:
  /// Throws std::runtime_error with the line that makes no sense.
  explicit House(const std::string& map);
  /// Of this project.
  [[nodiscard]] static const House& ours();
  [[nodiscard]] const std::vector<Folder>& folders() const noexcept { return folders_; }
  /// Throws std::out_of_range if there is none.
  [[nodiscard]] const Folder& folder(const std::string& name) const;

 private:
  std::vector<Folder> folders_;
};

struct Source {
  std::string folder;
  std::string file;  ///< from the root of the project: "gui/words/texts.cpp"
  std::vector<std::string> lines;

  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool is_header() const { return file.ends_with(".hpp"); }
};

/// Every .hpp and .cpp file of all folders, by name.
[[nodiscard]] const std::vector<Source>& all_sources();

/// Every .hpp and .cpp file of the tests, by name; the folder is "tests".
[[nodiscard]] const std::vector<Source>& all_tests();

/// The text without comments, literals and lines of the preprocessor: braces that count are left.
[[nodiscard]] std::string code_of(const std::string& text);

}  // namespace isograsp::architecture
