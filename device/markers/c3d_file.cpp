// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/c3d_file.hpp"

#include <cstdint>
#include <vector>

#include "core/files.hpp"
#include "device/markers/c3d_codec.hpp"

namespace isograsp {

namespace {

/// Fills `to` from the file; false: it ends before.
Result<bool> read_bytes(InputFile& file, std::span<std::uint8_t> to, const std::string& path) {
  // Characters and bytes may alias.
  const auto count = file.read({reinterpret_cast<char*>(to.data()), to.size()});
  if (count < 0) return failed("cannot be read"_text, "check the disk"_text).at(path);
  return static_cast<std::size_t>(count) == to.size();
}

class C3dFile final : public MarkerReader {
 public:
  C3dFile(InputFile file, C3dLayout layout, std::string path)
      : file_(std::move(file)),
        layout_(std::move(layout)),
        frame_(layout_.frame_bytes),
        path_(std::move(path)) {
    for (const C3dPoint& point : layout_.points)
      markers_.emplace_back(without_subject(point.label));
  }

  Result<bool> next(double& t_s, std::span<Vec3> p_W) override {
    if (at_ == layout_.frames) return false;
    const auto whole = read_bytes(file_, frame_, path_);
    if (!whole) return whole.error();
    if (!*whole)
      return refused("ends within frame %1 of %2"_text(at_ + 1, layout_.frames),
                     "give a whole C3D file"_text)
          .at(path_);
    t_s = static_cast<double>(at_) / layout_.rate_Hz;
    decode_c3d_frame(layout_, frame_, p_W);
    ++at_;
    return true;
  }

 private:
  InputFile file_;
  C3dLayout layout_;
  std::vector<std::uint8_t> frame_;
  std::string path_;
  std::size_t at_ = 0;
};

}  // namespace

Result<std::unique_ptr<MarkerReader>> open_c3d(const std::string& path) {
  auto file = InputFile::open(path);
  if (!file) return file.error();
  std::vector<std::uint8_t> head(kC3dBlock);
  auto whole = read_bytes(*file, head, path);
  if (!whole) return whole.error();
  if (!*whole) return refused("ends before its data"_text, "give a whole C3D file"_text).at(path);
  const auto start = c3d_data_start(head);
  if (!start) return Error(start.error()).at(path);
  if (*start > file->size())
    return refused("ends before its data"_text, "give a whole C3D file"_text).at(path);
  head.resize(*start);
  whole = read_bytes(*file, std::span(head).subspan(kC3dBlock), path);
  if (!whole) return whole.error();
  auto layout = parse_c3d_head(head);
  if (!layout) return Error(layout.error()).at(path);
  auto reader = std::make_unique<C3dFile>(std::move(*file), std::move(*layout), path);
  if (auto good = check_labels(reader->markers(), path); !good) return good.error();
  return std::unique_ptr<MarkerReader>(std::move(reader));
}

}  // namespace isograsp
