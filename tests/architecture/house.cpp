// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/house.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace isograsp::architecture {

namespace fs = std::filesystem;

namespace {

std::string text_of_file(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

Names words_in(const std::string& text) {
  std::istringstream in(text);
  Names words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

void read_below(const std::string& folder, std::vector<Source>& found) {
  const fs::path root = ISOGRASP_SOURCE_DIR;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".hpp" && extension != ".cpp") continue;
    Source source{folder, entry.path().lexically_relative(root), {}};
    std::istringstream in(text_of_file(entry.path()));
    for (std::string line; std::getline(in, line);) source.lines.push_back(line);
    found.push_back(std::move(source));
  }
}

/// By name. Throws std::runtime_error if these are too few to be all.
std::vector<Source> sorted(std::vector<Source> found, std::size_t fewest) {
  if (found.size() < fewest) throw std::runtime_error("the sources were not found");
  std::sort(found.begin(), found.end(),
            [](const Source& a, const Source& b) { return a.file < b.file; });
  return found;
}

}  // namespace

std::size_t Folder::room_of(const std::string& file) const {
  std::size_t found = rooms.size();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const bool in_it = file.starts_with(rooms[i].path + "/");
    if (in_it && (found == rooms.size() || rooms[i].path.size() > rooms[found].path.size()))
      found = i;
  }
  if (found == rooms.size()) throw std::runtime_error(file + " stands in no room of " + name);
  return found;
}

House::House(const std::string& map) {
  std::istringstream in(map);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const auto colon = line.find(':');
    if (colon == std::string::npos) throw std::runtime_error("no colon in: " + line);
    const std::string rest = line.substr(colon + 1);
    if (line[0] != ' ') {
      folders_.push_back({line.substr(0, colon), {}, {}, {}, {}});
      continue;
    }
    if (folders_.empty()) throw std::runtime_error("belongs to no folder: " + line);
    Folder& folder = folders_.back();
    const std::string key = line.substr(2, colon - 2);
    if (key == "uses") {
      folder.uses = words_in(rest);
    } else if (key == "library") {
      folder.libraries = words_in(rest);
    } else if (key == "source library") {
      folder.source_libraries = words_in(rest);
    } else if (key.starts_with("room ")) {
      const std::string room = key.substr(5);
      const auto without = rest.rfind("; no ");
      folder.rooms.push_back(
          {room == "." ? folder.name : folder.name + "/" + room,
           words_in(without == std::string::npos ? "" : rest.substr(without + 5))});
    } else {
      throw std::runtime_error("unknown: " + line);
    }
  }
  for (Folder& folder : folders_)
    if (folder.rooms.empty()) folder.rooms.push_back({folder.name});
}

const House& House::ours() {
  static const House house(text_of_file(ISOGRASP_SOURCE_DIR "/docs/rooms.txt"));
  return house;
}

const Folder& House::folder(const std::string& name) const {
  const auto found = std::find_if(folders_.begin(), folders_.end(),
                                  [&](const Folder& folder) { return folder.name == name; });
  if (found == folders_.end()) throw std::out_of_range("no folder " + name);
  return *found;
}

std::string Source::text() const {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

const std::vector<Source>& all_sources() {
  static const auto sources = [] {
    std::vector<Source> found;
    for (const Folder& folder : House::ours().folders()) read_below(folder.name, found);
    return sorted(std::move(found), 500);
  }();
  return sources;
}

const std::vector<Source>& all_tests() {
  static const auto tests = [] {
    std::vector<Source> found;
    read_below("tests", found);
    return sorted(std::move(found), 250);
  }();
  return tests;
}

std::string code_of(const std::string& text) {
  static const std::regex kNoCode(
      R"re(//[^\n]*|/\*[^]*?\*/|R"(\w*)\([^]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'|#(?:[^\n]*\\\n)*[^\n]*)re");
  std::string code;
  auto from = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), kNoCode), end; at != end; ++at) {
    code.append(from, (*at)[0].first);
    code += ' ';
    from = (*at)[0].second;
  }
  return code.append(from, text.cend());
}

}  // namespace isograsp::architecture
