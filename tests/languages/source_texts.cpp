// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/languages/source_texts.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "core/files.hpp"
#include "session/library/library.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::languages {

namespace fs = std::filesystem;

namespace {

/// A character of the basic plane as UTF-8.
std::string utf8(unsigned character) {
  const auto byte = [](unsigned value) { return static_cast<char>(value); };
  if (character < 0x80) return {byte(character)};
  const char last = byte(0x80 | (character & 0x3F));
  if (character < 0x800) return {byte(0xC0 | (character >> 6)), last};
  return {byte(0xE0 | (character >> 12)), byte(0x80 | ((character >> 6) & 0x3F)), last};
}

/// Text in quotes up to `at`, which stands at its first quote and then behind its last.
std::string quoted(std::string_view code, std::size_t& at) {
  std::string text;
  const char quote = code[at];
  for (++at; at < code.size() && code[at] != quote; ++at) {
    if (code[at] == '\\' && at + 1 < code.size()) {
      ++at;
      constexpr std::size_t kDigits = 4;  // of \u00a0
      unsigned character = 0;
      if (code[at] == 'u' && at + kDigits < code.size() &&
          std::from_chars(&code[at + 1], &code[at + 1] + kDigits, character, 16).ec == std::errc())
        text += utf8(character), at += kDigits;
      else
        text += code[at] == 'n' ? '\n' : code[at];
    } else {
      text += code[at];
    }
  }
  ++at;
  return text;
}

bool of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool has_letter(const std::string& text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

void add_library(std::set<std::string>& texts, const std::string& library) {
  for (const auto& entry : fs::directory_iterator(library + "/tasks")) {
    const auto text = read_text(entry.path());
    if (entry.path().extension() != ".toml" || !text) continue;
    if (const auto spec = tasks::parse_task(*text, entry.path()))
      texts.insert({spec->name, spec->instruction});
  }
  for (const auto& entry : fs::directory_iterator(library + "/protocols"))
    if (const auto protocol = session::read_protocol(entry.path(), library))
      texts.insert(protocol->spec.name);
  // As a session stores the device.
  for (const auto& entry : fs::directory_iterator(library + "/patients"))
    if (entry.path().extension() == ".toml")
      texts.insert(english("Simulated sensors, %1 patient"_text(entry.path().stem().string())));
}

}  // namespace

std::set<std::string> texts_in_code(std::string_view code) {
  constexpr std::string_view kSuffix = "_text";
  std::set<std::string> texts;
  std::string literal;  ///< what the literals side by side say so far
  for (std::size_t at = 0; at < code.size();) {
    const auto rest = code.substr(at);
    if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
      ++at;
    } else if (rest.starts_with("//") || rest.starts_with("#include")) {
      at = std::min(code.find('\n', at), code.size());
    } else if (rest.starts_with("R\"(")) {
      at = std::min(code.find(")\"", at), code.size() - 2) + 2;
    } else if (rest[0] == '"') {
      literal += quoted(code, at);
      if (code.substr(at).starts_with(kSuffix)) {
        texts.insert(std::exchange(literal, {}));
        at += kSuffix.size();
      }
    } else {
      literal.clear();
      if (rest[0] == '\'' && (at == 0 || !of_word(code[at - 1])))
        static_cast<void>(quoted(code, at));
      else
        ++at;
    }
  }
  return texts;
}

std::set<std::string> all_texts(const std::string& source_folder) {
  std::set<std::string> texts;
  for (const char* folder : {"core", "hand", "kinematics", "device", "grasp_model", "bimanual",
                             "virtual_patient", "statistics", "tasks", "storage", "session",
                             "exports", "reports", "gui", "app", "languages"})
    for (const auto& entry : fs::recursive_directory_iterator(source_folder + "/" + folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      const auto code = read_text(entry.path());
      if (!code) throw std::runtime_error(entry.path().string() + " cannot be read");
      texts.merge(texts_in_code(*code));
    }
  add_library(texts, source_folder + "/library");
  // Names that stand in sentences as Known.
  texts.insert({"right", "left", "thumb", "index", "middle", "therapist", "researcher",
                "administrator", "the network", "serial lines", "completed", "aborted",
                "interrupted"});
  for (const int failure :
       {EACCES,       EADDRINUSE,   EADDRNOTAVAIL, EBUSY,  ECONNREFUSED, ECONNRESET, EDQUOT,
        EEXIST,       EHOSTUNREACH, EINVAL,        EIO,    EISDIR,       ELOOP,      EMFILE,
        ENAMETOOLONG, ENETDOWN,     ENETUNREACH,   ENODEV, ENOENT,       ENOMEM,     ENOSPC,
        ENOTDIR,      ENOTEMPTY,    ENXIO,         EPERM,  EROFS,        ETIMEDOUT,  ETXTBSY})
    texts.insert(std::strerror(failure));
  std::erase_if(texts, [](const std::string& text) { return !has_letter(text); });
  return texts;
}

}  // namespace isograsp::languages
