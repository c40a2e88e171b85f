// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/staging_folder.hpp"

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

namespace isograsp {

namespace {

namespace fs = std::filesystem;

constexpr mode_t kOwnerFolder = 0700;

bool is_still(const Descriptor& folder, const std::string& path) {
  struct stat own {};
  struct stat named {};
  return fstat(folder.number(), &own) == 0 && lstat(path.c_str(), &named) == 0 &&
         own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

/// The folder of this name, locked; closed, with errno, if it cannot be had.
Descriptor locked(const std::string& path) {
  Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!folder.is_open()) return {};
  // Some file systems have no locks; there, as without the folder, two programs see each other's
  // files and one of them fails.
  if (flock(folder.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return {};
  if (is_still(folder, path)) return folder;
  errno = ESTALE;  // another one has cleared it away
  return {};
}

}  // namespace

Result<StagingFolder> StagingFolder::beside(const std::string& target) {
  constexpr int kTries = 100;  // against others that clear away and begin at the same moment
  std::error_code failure;
  fs::path whole = fs::absolute(target, failure).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // "folder/"
  StagingFolder made;
  made.path_ = whole.parent_path() / ("." + whole.filename().string() + ".making");
  made.file_ = fs::path(made.path_) / whole.filename();
  for (int tries = 0; tries < kTries; ++tries) {
    if (::mkdir(made.path_.c_str(), kOwnerFolder) != 0 && errno != EEXIST) break;
    made.lock_ = locked(made.path_);
    if (made.lock_.is_open()) {
      for (const auto& left : fs::directory_iterator(made.path_, failure))
        fs::remove_all(left.path(), failure);
      return made;
    }
    if (errno == EWOULDBLOCK)
      return failed("is being written by another program now"_text,
                    "wait until it is done, or give another name"_text)
          .at(target);
    // A link or a file in its place is not followed, and nobody's work is in it.
    if (errno == ENOTDIR || errno == ELOOP) fs::remove(made.path_, failure);
  }
  return failed("its folder is read-only"_text, "choose a folder that you may write to"_text)
      .at(target);
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  if (lock_.is_open() && is_still(lock_, path_)) fs::remove_all(path_, ignored);
}

}  // namespace isograsp
