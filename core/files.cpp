// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files.hpp"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isograsp {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPieceWritten = std::size_t{1} << 16;
constexpr mode_t kOwnerOnly = 0600;

bool is_named(int file, const std::string& name) {
  struct stat own {};
  struct stat named {};
  return fstat(file, &own) == 0 && lstat(name.c_str(), &named) == 0 && own.st_dev == named.st_dev &&
         own.st_ino == named.st_ino;
}

/// False if a living writer holds it.
bool clear_leftover(const std::string& name) {
  const Descriptor left(
      ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (left.is_open() && flock(left.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return false;
  if (!left.is_open() || is_named(left.number(), name)) ::unlink(name.c_str());
  return true;
}

/// Makes a new file of this name, locked as long as it is open; never opens a file that exists, nor
/// one that a link leads to. Closed, with errno, if it cannot be made.
Descriptor create_exclusively(const std::string& name) {
  constexpr int kTries = 100;  // against others that clear away and begin at the same moment
  for (int tries = 0; tries < kTries; ++tries) {
    Descriptor file(
        ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOwnerOnly));
    if (file.is_open()) {
      const bool taken = flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
      if (!taken && is_named(file.number(), name)) return file;
    } else if (errno != EEXIST) {
      return {};
    } else if (!clear_leftover(name)) {
      errno = EBUSY;
      return {};
    }
  }
  errno = EBUSY;
  return {};
}

std::string temporary_name(const fs::path& target) {
  constexpr std::size_t kLongestStem = 200;  // of the 255 bytes that a name may have
  return (target.parent_path() /
          ("." + target.filename().string().substr(0, kLongestStem) + ".part"))
      .string();
}

bool sync_folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const Descriptor opened(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot synchronise a folder.
  return opened.is_open() && (fsync(opened.number()) == 0 || errno == EINVAL);
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

Error cannot_open(const std::string& path, Purpose purpose) {
  std::error_code ignored;
  const bool reading = purpose == Purpose::reading;
  const Text why = fs::is_directory(path, ignored) ? Text("is a folder"_text)
                   : reading                       ? Text("cannot be opened for reading"_text)
                                                   : Text("cannot be opened for writing"_text);
  const auto error = reading ? refused : failed;
  return error(why, "check the path and its permissions"_text).at(path);
}

Result<void> check_different(const std::string& in, const std::string& out) {
  std::error_code ignored;
  if (!fs::equivalent(in, out, ignored)) return {};
  return refused("is the input: it would be lost"_text, "give another name"_text).at(out);
}

Result<InputFile> InputFile::open(const std::string& path) {
  InputFile file;
  // O_NONBLOCK: a pipe without a writer would let the call itself wait.
  file.file_ = Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.file_.is_open() && errno != ENXIO) return cannot_open(path, Purpose::reading);
  if (!file.file_.is_open() || fstat(file.file_.number(), &status) != 0 ||
      !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) return cannot_open(path, Purpose::reading);
    return refused("is not a file but a pipe, a socket or a device"_text,
                   "write it to a file first and name that"_text)
        .at(path);
  }
  file.size_ = static_cast<std::uint64_t>(status.st_size);
  return file;
}

std::ptrdiff_t InputFile::read(std::span<char> to) noexcept {
  std::size_t done = 0;
  while (done < to.size()) {
    const ssize_t count = ::read(file_.number(), to.data() + done, to.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return static_cast<std::ptrdiff_t>(done);
}

Result<FileWriter> FileWriter::create(const std::string& path) {
  FileWriter writer;
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (fs::is_directory(status)) return cannot_open(path, Purpose::writing);
  const bool exists = fs::exists(status);
  // A link stays a link: the file it names is the one that is replaced.
  writer.path_ = exists ? fs::canonical(path, ignored) : fs::path(path);
  // A device or a pipe is written to; replacing it by a file would destroy it.
  if (exists && !fs::is_regular_file(status)) {
    writer.out_ = Descriptor(::open(writer.path_.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
    if (!writer.out_.is_open()) return cannot_open(path, Purpose::writing);
    return writer;
  }
  const std::string temporary = temporary_name(writer.path_);
  writer.out_ = create_exclusively(temporary);
  if (!writer.out_.is_open() && errno == EBUSY)
    return failed("is being written by another program now"_text,
                  "wait until it is done, or give another name"_text)
        .at(path);
  if (!writer.out_.is_open()) return cannot_open(path, Purpose::writing);
  writer.temporary_ = temporary;
  struct stat old {};
  if (stat(writer.path_.c_str(), &old) == 0 && old.st_uid == geteuid())
    static_cast<void>(fchmod(writer.out_.number(), old.st_mode & 0777));
  return writer;
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      out_(std::move(other.out_)),
      waiting_(std::move(other.waiting_)),
      good_(other.good_) {
  other.temporary_.clear();
}

FileWriter::~FileWriter() {
  if (!temporary_.empty() && is_named(out_.number(), temporary_)) ::unlink(temporary_.c_str());
}

void FileWriter::write(std::string_view text) {
  waiting_ += text;
  if (waiting_.size() >= kPieceWritten) flush();
}

std::string FileWriter::name_for_library() const {
  return temporary_.empty() ? "" : "/proc/self/fd/" + std::to_string(out_.number());
}

void FileWriter::flush() noexcept {
  std::string_view rest = waiting_;
  while (good_ && !rest.empty()) {
    const ssize_t count = ::write(out_.number(), rest.data(), rest.size());
    if (count >= 0) rest.remove_prefix(static_cast<std::size_t>(count));
    good_ = count >= 0 || errno == EINTR;
  }
  waiting_.clear();
}

Result<void> FileWriter::commit() {
  flush();
  if (!temporary_.empty())
    good_ = good_ && fsync(out_.number()) == 0 && is_named(out_.number(), temporary_) &&
            ::rename(temporary_.c_str(), path_.c_str()) == 0;
  if (!good_)
    return failed("could not be written completely"_text,
                  "free some disk space and check the permissions of the folder"_text)
        .at(path_);
  const bool named = !std::exchange(temporary_, "").empty();
  if (named && !sync_folder_of(path_))
    return failed("is written, but its folder cannot be synchronised"_text, "check the disk"_text)
        .at(path_);
  out_ = Descriptor();
  return {};
}

Result<std::string> read_text(const std::string& path) {
  constexpr std::uint64_t kLargestText = std::uint64_t{64} << 20;  // no scene or task comes near
  auto file = InputFile::open(path);
  if (!file) return file.error();
  if (file->size() > kLargestText)
    return refused("is larger than 64 MiB"_text, "check that it is the right file"_text).at(path);
  std::string text(file->size(), '\0');
  if (file->read(text) != static_cast<std::ptrdiff_t>(text.size()))
    return cannot_open(path, Purpose::reading);
  return text;
}

Result<void> write_text(const std::string& path, std::string_view text) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  writer->write(text);
  return writer->commit();
}

}  // namespace isograsp
