// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files.hpp"

#include <cstdint>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace isograsp {

Error cannot_open(const std::string& path, const char* purpose) {
  std::error_code ignored;
  const std::string why = std::filesystem::is_directory(path, ignored)
                              ? "is a folder"
                              : std::string("cannot be opened for ") + purpose;
  const bool reading = std::string_view(purpose) == "reading";
  return {reading ? Error::Code::bad_input : Error::Code::failed,
          why,
          "check the path and its permissions",
          path,
          0,
          ""};
}

Result<void> check_different(const std::string& in, const std::string& out) {
  std::error_code ignored;
  if (!std::filesystem::equivalent(in, out, ignored)) return {};
  return Error{
      Error::Code::bad_input, "is the input: it would be lost", "give another name", out, 0, ""};
}

Result<FileWriter> FileWriter::create(const std::string& path) {
  namespace fs = std::filesystem;
  FileWriter writer;
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  if (fs::is_directory(status)) return cannot_open(path, "writing");
  const bool exists = fs::exists(status);
  // A link stays a link: the file it names is the one that is replaced.
  const fs::path target = exists ? fs::canonical(path, ignored) : fs::path(path);
  writer.path_ = target;
  // A device or a pipe is written to; replacing it by a file would destroy it.
  const bool replace = !exists || fs::is_regular_file(status);
  if (replace) writer.temporary_ = target.string() + ".part-" + std::to_string(getpid());
  writer.out_.open(replace ? writer.temporary_ : writer.path_, std::ios::binary | std::ios::trunc);
  if (!writer.out_.is_open()) {
    writer.temporary_.clear();
    return cannot_open(path, "writing");
  }
  return writer;
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      out_(std::move(other.out_)) {
  other.temporary_.clear();
}

FileWriter::~FileWriter() {
  if (temporary_.empty()) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void FileWriter::write(std::string_view text) {
  out_.write(text.data(), static_cast<std::streamsize>(text.size()));
}

Result<void> FileWriter::commit() {
  out_.close();
  std::error_code failure;
  if (out_.good() && !temporary_.empty()) std::filesystem::rename(temporary_, path_, failure);
  if (!out_.good() || failure)
    return Error{Error::Code::failed,
                 "could not be written completely",
                 "free some disk space and check the permissions of the folder",
                 path_,
                 0,
                 ""};
  temporary_.clear();
  return {};
}

Result<std::string> read_text(const std::string& path) {
  constexpr std::uintmax_t kLargestText = std::uintmax_t{64} << 20;  // no scene or task comes near
  std::error_code failure;
  const auto size = std::filesystem::file_size(path, failure);
  if (failure) return cannot_open(path, "reading");
  if (size > kLargestText)
    return Error{Error::Code::bad_input,
                 "is larger than 64 MiB",
                 "check that it is the right file",
                 path,
                 0,
                 ""};
  std::ifstream in(path, std::ios::binary);
  std::string text(size, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size)))
    return cannot_open(path, "reading");
  return text;
}

Result<void> write_text(const std::string& path, std::string_view text) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  writer->write(text);
  return writer->commit();
}

}  // namespace isograsp
