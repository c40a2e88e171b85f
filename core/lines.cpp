// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines.hpp"

#include <algorithm>

namespace isograsp {

Result<LineReader> LineReader::open(const std::string& path, std::size_t longest_line,
                                    Text remedy) {
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  auto file = InputFile::open(path);
  if (!file) return file.error();
  LineReader reader(std::move(*file));
  reader.path_ = path;
  reader.remedy_ = std::move(remedy);
  reader.longest_line_ = longest_line;
  reader.block_.resize(kBlock);
  return reader;
}

/// Moves what is left to the front of the block and reads on; a line longer than the block makes
/// it larger. False: the disk fails.
bool LineReader::fill() {
  std::copy(block_.begin() + static_cast<std::ptrdiff_t>(begin_),
            block_.begin() + static_cast<std::ptrdiff_t>(end_), block_.begin());
  end_ -= begin_;
  begin_ = 0;
  if (end_ == block_.size()) block_.resize(2 * end_);
  const auto count = file_.read(std::span(block_).subspan(end_));
  if (count < 0) return false;
  at_end_ = static_cast<std::size_t>(count) < block_.size() - end_;
  end_ += static_cast<std::size_t>(count);
  return true;
}

Result<bool> LineReader::next() {
  const auto rest = [this] { return std::string_view(block_.data() + begin_, end_ - begin_); };
  std::size_t length = rest().find('\n');
  while (length == std::string_view::npos && !at_end_) {
    const std::size_t searched = end_ - begin_;
    if (searched > longest_line_)
      return refused("this line is longer than %1"_text((longest_line_ >> 20 > 0
                                                             ? "%1 MiB"_text(longest_line_ >> 20)
                                                             : "%1 KiB"_text(longest_line_ >> 10))),
                     remedy_)
          .at(path_, line_ + 1);
    if (!fill()) return failed("cannot be read"_text, "check the disk"_text).at(path_, line_ + 1);
    length = rest().find('\n', searched);
  }
  text_ = rest().substr(0, length);
  if (length == std::string_view::npos && text_.empty()) return false;
  begin_ = length == std::string_view::npos ? end_ : begin_ + length + 1;
  ++line_;
  return true;
}

}  // namespace isograsp
