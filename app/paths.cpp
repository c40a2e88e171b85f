// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/paths.hpp"

#include <cstdlib>
#include <filesystem>

namespace isograsp::app {

namespace fs = std::filesystem;

namespace {
std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}
}  // namespace

std::string library_folder() {
  if (const auto chosen = environment("ISOGRASP_LIBRARY"); !chosen.empty()) return chosen;
  std::error_code ignored;
  if (fs::is_directory(ISOGRASP_SOURCE_LIBRARY, ignored)) return ISOGRASP_SOURCE_LIBRARY;
  // PREFIX/bin/isograsp is this program: the prefix is where it was installed or moved to.
  return fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path() / "share/isograsp";
}

std::string default_database() {
  fs::path base = environment("XDG_DATA_HOME");
  if (base.empty()) base = fs::path(environment("HOME")) / ".local/share";
  std::error_code ignored;
  fs::create_directories(base / "isograsp", ignored);
  return base / "isograsp" / "clinic.db";
}

}  // namespace isograsp::app
