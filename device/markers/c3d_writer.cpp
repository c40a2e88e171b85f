// SPDX-License-Identifier: GPL-3.0-or-later
// Layout: device/markers/c3d_codec.cpp. Scale = largest coordinate / 32000 [mm], negative where the
// data are floats. Counts of frames are words of 16 bits and stop at 65535; the group TRIAL has
// them whole, and POINT:LONG_FRAMES as a float. Groups that readers ask for are there, without
// channels.
#include "device/markers/c3d_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>

#include "device/markers/c3d_codec.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

namespace {

constexpr double kMillimetres = 1e3;
constexpr double kLargestInteger = 32000.0;
constexpr std::size_t kMostInWord = 65535;
constexpr std::size_t kMostInByte = 255;
constexpr std::size_t kLongestLabel = 127;

void append_word(std::string& bytes, std::size_t value) {
  bytes += static_cast<char>(value & 0xFFU);
  bytes += static_cast<char>((value >> 8U) & 0xFFU);
}
void append_float(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  append_word(bytes, bits & 0xFFFFU);
  append_word(bytes, bits >> 16U);
}

/// Of one step of an integer, as the file holds it [mm].
float step_mm(const C3dRecording& recording) {
  const double step = recording.largest_m * kMillimetres / kLargestInteger;
  return step > 0.0 ? static_cast<float>(step) : 1.0F;
}
float signed_scale(const C3dRecording& recording) {
  return recording.numbers == C3dNumbers::floats ? -step_mm(recording) : step_mm(recording);
}

/// Records of a parameter section.
class ParameterSection {
 public:
  void group(std::string_view name) {
    ++group_;
    begin(name, -group_);
    end(std::string(1, '\0'));  // no description
  }
  void word(std::string_view name, std::size_t value) { words(name, {}, std::array{value}); }
  void words(std::string_view name, const std::string& dimensions,
             std::span<const std::size_t> values) {
    std::string rest{'\x02', static_cast<char>(dimensions.size())};
    rest += dimensions;
    for (const std::size_t value : values) append_word(rest, value);
    parameter(name, rest);
  }
  void number(std::string_view name, float value) {
    std::string rest{'\x04', '\0'};
    append_float(rest, value);
    parameter(name, rest);
  }
  /// Texts of equal length, one behind the other.
  void texts(std::string_view name, std::span<const std::string> all, std::size_t length) {
    std::string rest{'\xFF', '\x02', static_cast<char>(length), static_cast<char>(all.size())};
    for (std::string text : all) {
      text.resize(length, ' ');
      rest += text;
    }
    parameter(name, rest);
  }
  /// The section in whole blocks.
  [[nodiscard]] std::string blocks() const {
    constexpr std::size_t kHead = 4;
    const std::size_t count = (kHead + bytes_.size() + kC3dBlock - 1) / kC3dBlock;
    constexpr char kForIntel = 84;
    std::string all{'\x01', '\x50', static_cast<char>(std::min(count, kMostInByte)), kForIntel};
    all += bytes_;
    all[kHead + last_step_] = all[kHead + last_step_ + 1] = '\0';  // no record behind the last one
    all.resize(count * kC3dBlock, '\0');
    return all;
  }

 private:
  void begin(std::string_view name, int group) {
    bytes_ += static_cast<char>(name.size());
    bytes_ += static_cast<char>(group);
    bytes_ += name;
  }
  void end(const std::string& rest) {
    last_step_ = bytes_.size();
    append_word(bytes_, 2 + rest.size());
    bytes_ += rest;
  }
  void parameter(std::string_view name, const std::string& rest) {
    begin(name, group_);
    end(rest + '\0');  // no description
  }

  std::string bytes_;
  std::size_t last_step_ = 0;  ///< where the last record says how far the next one is
  int group_ = 0;
};

ParameterSection parameters_of(const C3dRecording& recording, std::size_t data_block) {
  const auto& labels = recording.markers;
  ParameterSection section;
  section.group("POINT");
  section.word("USED", labels.size());
  section.number("SCALE", signed_scale(recording));
  section.number("RATE", static_cast<float>(recording.rate_Hz));
  section.word("DATA_START", data_block);
  section.word("FRAMES", std::min(recording.frames, kMostInWord));
  if (recording.frames > kMostInWord)
    section.number("LONG_FRAMES", static_cast<float>(recording.frames));
  section.texts("UNITS", std::array{std::string("mm")}, 2);
  std::size_t length = 1;
  for (const std::string& label : labels) length = std::max(length, label.size());
  for (std::size_t first = 0, part = 1; first < labels.size(); first += kMostInByte, ++part) {
    const auto some =
        std::span(labels).subspan(first, std::min(kMostInByte, labels.size() - first));
    const std::string suffix = part == 1 ? "" : std::to_string(part);
    section.texts("LABELS" + suffix, some, length);
    section.texts("DESCRIPTIONS" + suffix, std::vector<std::string>(some.size(), " "), 1);
  }
  section.group("ANALOG");
  section.word("USED", 0);
  section.number("GEN_SCALE", 1.0F);
  section.number("RATE", 0.0F);  // as the head says: no samples of a frame
  section.group("FORCE_PLATFORM");
  section.word("USED", 0);
  section.group("TRIAL");
  section.words("ACTUAL_START_FIELD", "\x02", std::array<std::size_t, 2>{1, 0});
  section.words(
      "ACTUAL_END_FIELD", "\x02",
      std::array<std::size_t, 2>{recording.frames & kMostInWord, recording.frames >> 16U});
  return section;
}

/// The rows of a recording on the grid that C3D has.
class FrameGrid {
 public:
  explicit FrameGrid(double rate_Hz) : rate_Hz_(rate_Hz) {}
  /// One row after the other. Errors: it lies between two frames.
  Result<std::size_t> frame_at(double t_s) {
    if (!first_s_) first_s_ = t_s;
    const double frame = (t_s - *first_s_) * rate_Hz_;
    const double nearest = std::round(frame);
    if (std::abs(frame - nearest) > kOffGrid || (last_ && nearest <= static_cast<double>(*last_)))
      return refused(
          "the row at %1 s is not on a grid of %2 Hz"_text(shortest(t_s), fixed(rate_Hz_, 3)),
          "a C3D file has no times: give a recording with a constant rate"_text);
    last_ = static_cast<std::size_t>(nearest);
    return *last_;
  }

 private:
  static constexpr double kOffGrid = 0.25;  // of a step: times of files are rounded
  double rate_Hz_;
  std::optional<double> first_s_;
  std::optional<std::size_t> last_;
};

/// The rate of rows of which some may be missing: that of the whole record, counted in usual steps.
double rate_of(const std::vector<double>& t_s) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < t_s.size(); ++k) steps.push_back(t_s[k] - t_s[k - 1]);
  if (steps.empty()) return 1.0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  double counted = 0.0;
  for (std::size_t k = 1; k < t_s.size(); ++k)
    counted += std::max(1.0, std::round((t_s[k] - t_s[k - 1]) / *middle));
  return counted / (t_s.back() - t_s.front());
}

Result<C3dRecording> look_through(const std::string& in, C3dNumbers numbers) {
  const auto reader = open_markers(in);
  if (!reader) return reader.error();
  C3dRecording recording;
  recording.markers = (*reader)->markers();
  recording.numbers = numbers;
  std::vector<double> times_s;
  std::vector<Vec3> p_W(recording.markers.size());
  for (double t_s = 0.0;;) {
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) break;
    times_s.push_back(t_s);
    for (const Vec3& p : p_W)
      if (p.allFinite())
        recording.largest_m = std::max(recording.largest_m, p.cwiseAbs().maxCoeff());
  }
  recording.rate_Hz = rate_of(times_s);
  FrameGrid grid(recording.rate_Hz);
  for (const double t_s : times_s) {
    const auto frame = grid.frame_at(t_s);
    if (!frame) return Error(frame.error()).at(in);
    recording.frames = *frame + 1;
  }
  if (recording.frames == 0) return refused("has no row"_text, "give a recording"_text).at(in);
  return recording;
}

}  // namespace

Result<std::string> c3d_head(const C3dRecording& recording) {
  for (const std::string& label : recording.markers)
    if (label.size() > kLongestLabel)
      return refused("the label '%1' is longer than a C3D file can hold"_text(label),
                     "give the marker a shorter name"_text);
  if (!(recording.rate_Hz > 0.0) || !std::isfinite(recording.rate_Hz))
    return refused("does not say its rate"_text, "export it again"_text);
  // The first data block is written in the section whose length it depends on.
  const std::size_t blocks = parameters_of(recording, 0).blocks().size() / kC3dBlock;
  if (blocks > kMostInByte)
    return refused("the labels are longer than a C3D file can hold"_text,
                   "give the markers shorter names"_text);
  const std::size_t data_block = 2 + blocks;
  std::string head{'\x02', '\x50'};
  append_word(head, recording.markers.size());
  append_word(head, 0);  // analog values of a frame
  append_word(head, 1);  // first frame
  append_word(head, std::min(recording.frames, kMostInWord));
  append_word(head, 0);  // nothing was interpolated
  append_float(head, signed_scale(recording));
  append_word(head, data_block);
  append_word(head, 0);  // analog samples of a frame
  append_float(head, static_cast<float>(recording.rate_Hz));
  head.resize(kC3dBlock, '\0');
  return head + parameters_of(recording, data_block).blocks();
}

void append_c3d_frame(std::string& bytes, const C3dRecording& recording,
                      std::span<const Vec3> p_W) {
  const bool floats = recording.numbers == C3dNumbers::floats;
  const auto step = static_cast<double>(step_mm(recording));
  for (const Vec3& p : p_W) {
    const bool seen = p.allFinite();
    for (int axis = 0; axis < 3; ++axis) {
      const double mm = seen ? p[axis] * kMillimetres : 0.0;
      if (floats)
        append_float(bytes, static_cast<float>(mm));
      else
        append_word(bytes,
                    static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(mm / step))));
    }
    const int residual = seen ? 0 : -1;
    if (floats)
      append_float(bytes, static_cast<float>(residual));
    else
      append_word(bytes, static_cast<std::uint16_t>(residual));
  }
}

Result<void> convert_to_c3d(const std::string& in, const std::string& out, C3dNumbers numbers) {
  const auto recording = look_through(in, numbers);
  if (!recording) return recording.error();
  const auto head = c3d_head(*recording);
  if (!head) return Error(head.error()).at(in);
  const auto reader = open_markers(in);
  if (!reader) return reader.error();
  auto file = FileWriter::create(out);
  if (!file) return file.error();
  file->write(*head);
  std::vector<Vec3> p_W(recording->markers.size());
  const std::vector<Vec3> nothing(p_W.size(), unseen_marker());
  FrameGrid grid(recording->rate_Hz);
  std::string bytes;
  std::size_t written = 0;
  for (double t_s = 0.0;;) {
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) break;
    const auto frame = grid.frame_at(t_s);
    if (!frame || *frame >= recording->frames)
      return failed("has changed while it was read"_text, "try again"_text).at(in);
    bytes.clear();
    for (; written < *frame; ++written) append_c3d_frame(bytes, *recording, nothing);
    append_c3d_frame(bytes, *recording, p_W);
    ++written;
    file->write(bytes);
  }
  if (written != recording->frames)
    return failed("has changed while it was read"_text, "try again"_text).at(in);
  return file->commit();
}

}  // namespace isograsp
