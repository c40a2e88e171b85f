// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand calibrate, angles, convert.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/paths.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/lines.hpp"
#include "device/hand/hand_csv.hpp"
#include "device/hand/leap_json.hpp"
#include "kinematics/attitude.hpp"
#include "virtual_hand/hand_frame.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;

struct HandStreamOptions {
  std::string stream;
  std::string hand;
  std::optional<Hand> side;
  std::string from;
  std::string out;
  bool json = false;
};

Result<void> run_hand_calibrate(const HandStreamOptions& options) {
  const auto model = load_hand(std::string(library_folder()) + "/hands/default.toml");
  if (!model) return model.error();
  const auto frames = read_hand_csv(options.stream);
  if (!frames) return frames.error();
  const auto calibrated = calibrated_hand(*frames, *options.side, *model);
  if (!calibrated) return Error(calibrated.error()).at(options.stream);
  if (auto different = check_different(options.stream, options.out); !different) return different;
  HandModel hand = calibrated->hand;
  hand.name = "calibrated";
  if (auto written = write_text(options.out, hand_text(hand)); !written) return written;
  if (!options.json) {
    print_line("%1 frames, the hand is %2 mm long"_text(calibrated->frames,
                                                        fixed(1e3 * hand.length_m, 1).digits));
    return {};
  }
  auto fingers = HandJson::array();
  for (std::size_t d = 0; d < kDigitCount; ++d)
    fingers.push_back({{"name", kDigitNames[d]},
                       {"lengths_m", hand.digits[d].lengths_m},
                       {"base_m", place_json(hand.digits[d].base_m)},
                       {"radii_m", hand.digits[d].radii_m}});
  print_json({{"hand_length_m", hand.length_m},
              {"frames", calibrated->frames},
              {"fingers", std::move(fingers)}});
  return {};
}

Result<void> run_hand_angles(const HandStreamOptions& options) {
  auto hand = load_hand(options.hand);
  if (!hand) return hand.error();
  hand->side = *options.side;
  const auto frames = read_hand_csv(options.stream);
  if (!frames) return frames.error();
  for (const std::string& read : {options.stream, options.hand})
    if (auto different = check_different(read, options.out); !different) return different;
  auto out = FileWriter::create(options.out);
  if (!out) return out.error();
  std::string text = "t_s,palm_qw,palm_qx,palm_qy,palm_qz";
  for (const std::string_view digit : kDigitNames)
    for (const std::string_view angle : kDigitAngleNames)
      text += "," + std::string(digit) + "_" + std::string(angle) + "_rad";
  out->write(text + ",residual_m\n");
  for (const HandFrame& frame : *frames) {
    if (frame.side != *options.side || !frame.tracked) continue;
    const auto fit = fitted_pose(*hand, frame);
    if (!fit) continue;
    text.clear();
    const Quat q = canonical(fit->pose.X_WP.q);
    for (const double value : {frame.t_s, q.w(), q.x(), q.y(), q.z()})
      text += (text.empty() ? "" : ",") + format_number(value);
    for (const DigitAngles& angles : fit->pose.angles)
      for (const double angle_rad : angles) text += "," + format_number(angle_rad);
    out->write(text + "," + format_number(fit->residual_m) + "\n");
  }
  return out->commit();
}

Result<void> run_hand_convert(const HandStreamOptions& options) {
  if (auto different = check_different(options.stream, options.out); !different) return different;
  auto lines = LineReader::open(options.stream, LeapDecoder::kLongestMessage,
                                "give one message in each line"_text);
  if (!lines) return lines.error();
  auto out = HandCsvWriter::create(options.out);
  if (!out) return out.error();
  LeapDecoder decoder;
  std::vector<HandFrame> hands;
  std::size_t rows = 0;
  for (;;) {
    const auto more = lines->next();
    if (!more) return more.error();
    if (!*more) break;
    if (lines->text().empty()) continue;
    const auto kind = decoder.take(lines->text(), hands);
    if (kind == LeapDecoder::Kind::damaged)
      return refused("is no message of the Leap service"_text,
                     "give one JSON object of protocol v6 in each line"_text)
          .at(options.stream, lines->line());
    if (kind == LeapDecoder::Kind::late)
      return refused("time does not increase"_text, "sort the rows and remove repeats"_text)
          .at(options.stream, lines->line(), "timestamp");
    for (const HandFrame& hand : hands) out->write(hand);
    rows += hands.size();
  }
  if (rows == 0)
    return refused("shows no hand"_text, "record again with the hand over the camera"_text)
        .at(options.stream);
  if (auto done = out->commit(); !done) return done;
  print_line("%1 rows"_text(rows));
  return {};
}

}  // namespace

void add_hand_streams(Subcommand hand) {
  const auto of_stream = [](Subcommand command, const std::shared_ptr<HandStreamOptions>& options) {
    command.option("--stream", options->stream, "Joints of a tracked hand (CSV)")
        .required()
        .type("FILE");
    command.option("--side", options->side, "Which hand of the stream").required();
  };
  auto person = std::make_shared<HandStreamOptions>();
  Subcommand calibrate = hand.subcommand("calibrate", "The size of a person's hand");
  of_stream(calibrate, person);
  calibrate.option("--out", person->out, "Hand to write").required().type("FILE.toml");
  calibrate.flag("--json", person->json, "Print one JSON document");
  calibrate.runs([person] { return run_hand_calibrate(*person); });

  auto posed = std::make_shared<HandStreamOptions>();
  Subcommand angles = hand.subcommand("angles", "Angles of a hand in each frame");
  of_stream(angles, posed);
  angles.option("--hand", posed->hand, "Hand (isograsp-hand-1)").required().type("FILE.toml");
  angles.option("--out", posed->out, "Table to write (CSV)").required().type("FILE");
  angles.runs([posed] { return run_hand_angles(*posed); });

  auto messages = std::make_shared<HandStreamOptions>();
  messages->from = "leap-v6";
  Subcommand convert = hand.subcommand("convert", "Messages of a tracker as a table");
  convert.option("--from", messages->from, "What the messages are")
      .one_of({"leap-v6"})
      .shows_default();
  convert.option("IN", messages->stream, "One message in each line").required();
  convert.option("--out", messages->out, "Table to write (CSV)").required().type("FILE");
  convert.runs([messages] { return run_hand_convert(*messages); });
}

}  // namespace isograsp::app
