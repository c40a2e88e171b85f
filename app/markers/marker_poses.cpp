// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers convert, decode, poses, links.
#include <algorithm>
#include <memory>

#include "app/console.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"
#include "device/markers/c3d_writer.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/marker_reader.hpp"
#include "device/markers/natnet_log.hpp"
#include "device/markers/qtm_rt_log.hpp"
#include "kinematics/arm_frames.hpp"
#include "kinematics/tables/pose_csv.hpp"

namespace isograsp::app {

namespace {

struct PoseOptions {
  std::string rig;
  std::string in;
  std::string out;
  std::string protocol;
  std::optional<Hand> hand;
  bool integers = false;
};

Result<void> run_convert_markers(const PoseOptions& options) {
  if (auto different = check_different(options.in, options.out); !different) return different;
  if (options.out.ends_with(".c3d"))
    return convert_to_c3d(options.in, options.out,
                          options.integers ? C3dNumbers::integers : C3dNumbers::floats);
  if (options.integers)
    return refused("is of a C3D file"_text, "let --out end with .c3d"_text).about("--integer");
  const auto reader = open_markers(options.in);
  if (!reader) return reader.error();
  auto writer = MarkerCsvWriter::create(options.out, (*reader)->markers());
  if (!writer) return writer.error();
  std::vector<Vec3> p_W((*reader)->markers().size());
  for (;;) {
    double t_s = 0.0;
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) return writer->commit();
    writer->write(t_s, p_W);
  }
}

Result<void> run_decode_markers(const PoseOptions& options) {
  if (auto different = check_different(options.in, options.out); !different) return different;
  constexpr auto kCounted = "%1: %2 rows; %3 repeated, %4 without labels, %5 of other kinds"_text;
  if (options.protocol == "natnet") {
    const auto counts = convert_natnet_log(options.in, options.out);
    if (!counts) return counts.error();
    print_note(kCounted(options.in, counts->rows, counts->repeated, counts->stream.unlabelled,
                        counts->stream.passed_over));
    if (counts->stream.damaged > 0)
      print_note("%1: %2 datagrams are damaged"_text(options.in, counts->stream.damaged));
    return {};
  }
  const auto counts = convert_qtm_rt_log(options.in, options.out);
  if (!counts) return counts.error();
  print_note(kCounted(options.in, counts->frames, counts->repeated, counts->unlabelled,
                      counts->passed_over));
  return {};
}

Result<void> run_poses(const PoseOptions& options) {
  const Hand hand = hand_of(options.hand);
  auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  if (auto different = check_different(options.in, options.out); !different) return different;
  if (auto different = check_different(options.rig, options.out); !different) return different;
  const auto reader = open_markers(options.in);
  if (!reader) return reader.error();
  if (hand == Hand::left) *rig = mirrored(std::move(*rig));
  auto frames = ArmFrames::compile(*rig, (*reader)->markers());
  if (!frames) return about_file(frames.error(), options.in);
  for (const std::string& marker : frames->absent())
    print_note(
        "%1 has no marker '%2' of the rig: it counts as never seen"_text(options.in, marker));
  auto writer = PoseWriter::create(options.out, *rig, hand);
  if (!writer) return writer.error();
  std::vector<Vec3> p_W((*reader)->markers().size());
  std::vector<FramePose> solved(frames->frames());
  for (;;) {
    double t_s = 0.0;
    const auto more = (*reader)->next(t_s, p_W);
    if (!more) return more.error();
    if (!*more) return writer->commit();
    if (hand == Hand::left)
      std::transform(p_W.begin(), p_W.end(), p_W.begin(),
                     [](const Vec3& p) { return mirrored(p); });
    frames->solve(p_W, solved);
    writer->write(t_s, solved);
  }
}

Result<void> run_links(const PoseOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  for (const std::string& read : {options.rig, options.in})
    if (auto different = check_different(read, options.out); !different) return different;
  if (rig->links.empty())
    return refused("has no link"_text, "describe each link in [[link]]"_text).at(options.rig);
  const auto series = read_poses(options.in);
  if (!series) return series.error();
  return write_links(options.out, *rig, *series);
}

}  // namespace

void add_marker_poses(Subcommand markers) {
  const auto add = [&markers](const char* name, const char* help,
                              Result<void> (*work)(const PoseOptions&),
                              const char* out = "Table to write (CSV)") {
    auto options = std::make_shared<PoseOptions>();
    Subcommand command = markers.subcommand(name, help);
    command.option("--out", options->out, out).required().type("FILE");
    command.runs([options, work] { return work(*options); });
    return std::pair(command, options);
  };
  constexpr const char* kMarkers = "Recording: CSV of this program, C3D, TRC or Qualisys TSV";
  {
    auto [command, options] = add("convert", "A recording of markers as a table, or as a C3D file",
                                  run_convert_markers, "Table to write (CSV), or FILE.c3d");
    command.option("IN", options->in, kMarkers).required();
    command.flag("--integer", options->integers,
                 "C3D: integers of 16 bits in place of floats, half as large");
  }
  {
    auto [command, options] =
        add("decode", "A log of a stream of markers as a table", run_decode_markers);
    command.option("--protocol", options->protocol, "How the system speaks")
        .required()
        .one_of({"qtm-rt", "natnet"});
    command.option("LOG", options->in, "Log: (time) ADDRESS:PORT HEX, a line for each piece")
        .required();
  }
  {
    auto [command, options] = add("poses", "Poses of the frames of a rig", run_poses);
    command.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
    command.option("--in", options->in, kMarkers).required().type("FILE");
    command.option("--hand", options->hand, "Which arm; a left one is reflected");
  }
  {
    auto [command, options] = add("links", "Poses and angles of the links of a rig", run_links);
    command.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
    command.option("--poses", options->in, "Poses of its frames (CSV)").required().type("FILE");
  }
}

}  // namespace isograsp::app
