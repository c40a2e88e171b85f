// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files.hpp"

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace isograsp {

Error cannot_open(const std::string& path, const char* purpose) {
  std::error_code ignored;
  const std::string why = std::filesystem::is_directory(path, ignored)
                              ? "is a folder"
                              : std::string("cannot be opened for ") + purpose;
  return {Error::Code::bad_input, why, "check the path and its permissions", path, 0, ""};
}

Result<FileWriter> FileWriter::create(const std::string& path) {
  FileWriter writer;
  writer.path_ = path;
  writer.temporary_ = path + ".part";
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return cannot_open(path, "writing");
  writer.out_.open(writer.temporary_, std::ios::binary | std::ios::trunc);
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
  if (out_.good()) std::filesystem::rename(temporary_, path_, failure);
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
