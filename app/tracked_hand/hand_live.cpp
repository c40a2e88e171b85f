// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand record, emulate: hands as they come, and the other end of their wire.
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/device/live_device.hpp"
#include "app/language.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/files.hpp"
#include "device/hand/hand_csv.hpp"
#include "device/hand/hand_device.hpp"
#include "device/hand/hand_server.hpp"

namespace isograsp::app {

namespace {

struct HandLiveOptions {
  std::string stream;
  std::string out;
  std::optional<Hand> side;
  double duration_s = 0.0;
  std::string listen;
  std::string to;
  std::vector<std::string> faults;
  std::uint64_t seed = 1;
  bool loop = false;
  bool json = false;
};

constexpr Timestamp kHandLook = std::chrono::milliseconds(20);

Result<void> run_hand_record(const HandLiveOptions& options) {
  const auto uri = Uri::parse(options.stream);
  if (!uri) return uri.error();
  SteadyClock clock;  // outlives the device, whose thread reads it
  auto device = open_hand_device(*uri, options.side);
  if (!device) return device.error();
  if (uri->scheme == "replay")
    if (auto different = check_different(uri->target, options.out); !different) return different;
  auto out = HandCsvWriter::create(options.out);
  if (!out) return out.error();
  if (auto started = (*device)->start(clock); !started) return started;
  watch_for_interrupt();
  const Timestamp begin = (*device)->now(clock);
  const Timestamp end = begin + from_seconds(options.duration_s);
  ProgressBar progress("Recording"_text);
  std::uint64_t rows = 0;
  HandSample sample;
  while (!interrupted()) {
    const Timestamp now = (*device)->now(clock);
    const ReadStatus status = (*device)->read(std::min(end, now + kHandLook), sample);
    if (status == ReadStatus::finished) break;
    if (status == ReadStatus::sample) {
      out->write(sample.frame);
      ++rows;
      continue;
    }
    // Nothing waits: the stream has ended where the other end has closed it.
    const HandHealth health = (*device)->health();
    if (now >= end || health.fault == HandFault::connection_lost) break;
    progress.show(to_seconds(now - begin) / options.duration_s,
                  "%1"_text(std::string(name_of(health.state))));
  }
  progress.end();
  const HandCounters counters = (*device)->health().counters;
  (*device)->stop();
  if (rows == 0)
    return refused("shows no hand"_text, "record again with the hand over the camera"_text)
        .at(options.stream);
  if (auto written = out->commit(); !written) return written;
  print_line(
      "%1: %2 rows, %3 of them without the hand; %4 rows of the other hand, %5 frames lost, %6 messages damaged"_text(
          options.out, rows, counters.untracked, counters.other_side, counters.lost,
          counters.malformed + counters.late));
  return {};
}

Result<std::unique_ptr<HandServer>> hand_server(const HandLiveOptions& options) {
  std::vector<EmulatedHandFault> faults;
  for (const auto& text : options.faults) {
    const auto fault = EmulatedHandFault::parse(text);
    if (!fault) return fault.error();
    faults.push_back(*fault);
  }
  auto play = HandPlay::read(options.stream);
  if (!play) return play.error();
  play->repeat = options.loop;
  const bool listens = options.to.empty();
  const auto address = parse_endpoint(listens ? options.listen : options.to);
  if (!address)
    return refused("'%1' is no address in numbers with a port"_text(listens ? options.listen
                                                                            : options.to),
                   "write it as 127.0.0.1:6437"_text)
        .about(listens ? "--listen" : "--to");
  HandScene scene(*std::move(play), std::move(faults), options.seed);
  return listens ? open_leap_server(*address, std::move(scene))
                 : open_hand_sender(*address, std::move(scene));
}

Result<void> run_hand_emulate(const HandLiveOptions& options) {
  auto server = hand_server(options);
  if (!server) return server.error();
  watch_for_interrupt();
  if (!options.json)
    print_note(
        "a tracker of hands plays %1 on %2"_text(options.stream, (*server)->address().text()));
  SteadyClock clock;
  const Timestamp end =
      options.duration_s > 0.0 ? clock.now() + from_seconds(options.duration_s) : Timestamp::max();
  while (!interrupted() && clock.now() < end && !(*server)->over())
    (*server)->serve(clock, std::min(end, clock.now() + 5 * kHandLook));
  const HandSceneCounters& made = (*server)->scene().counters();
  const HandServerCounters& given = (*server)->counters();
  if (options.json)
    print_json({{"frames", made.frames},
                {"dropped", made.dropped},
                {"silent", made.silent},
                {"malformed", made.malformed},
                {"sent", given.sent},
                {"clients", given.clients},
                {"closed", given.closed}});
  else
    print_line("%1 frames, %2 lost on purpose"_text(made.frames, made.dropped + made.silent));
  return {};
}

}  // namespace

void add_hand_live(Subcommand hand) {
  auto recorded = std::make_shared<HandLiveOptions>();
  Subcommand record = hand.subcommand("record", "Hands of a tracker to a table");
  record
      .option("--stream", recorded->stream,
              "leap://HOST:PORT, udp-hand://HOST:PORT or replay://FILE.csv")
      .required()
      .type("URI");
  record.option("--out", recorded->out, "Table to write (CSV)").required().type("FILE");
  record.option("--duration", recorded->duration_s, "Seconds; ends early when the other end closes")
      .required()
      .range(0.001, 1e6);
  record.option("--side", recorded->side, "Only this hand; without it both");
  record.footer(
      "Example:\n  isograsp hand record --stream leap://127.0.0.1 --side right --out open.csv "
      "--duration 10");
  record.runs([recorded] { return run_hand_record(*recorded); });

  auto played = std::make_shared<HandLiveOptions>();
  Subcommand emulate = hand.subcommand("emulate", "A tracker of hands in software");
  emulate.option("--stream", played->stream, "Joints of a tracked hand (CSV)")
      .required()
      .type("FILE");
  OptionGroup wire = emulate.exactly_one("Wire");
  wire.option("--listen", played->listen, "Be the Leap service at this address and port (TCP)")
      .type("HOST:PORT");
  wire.option("--to", played->to, "Send datagrams to this address and port, as a script does")
      .type("HOST:PORT");
  emulate.option("--fault", played->faults,
                 "NAME=DETAIL@SECONDSs, e.g. lose=100ms@5s, drop=0.01 (docs/devices.md lists "
                 "them)");
  emulate.option("--seed", played->seed, "Seed of the faults").shows_default();
  emulate.option("--duration", played->duration_s, "Seconds; without it until Ctrl-C")
      .range(0.001, 1e6);
  emulate.flag("--loop", played->loop, "Play the recording again and again");
  emulate.flag("--json", played->json, "Print what was sent as one JSON document");
  emulate.footer(
      "Example:\n  isograsp hand emulate --stream grab.csv --listen 127.0.0.1:6437 --loop");
  emulate.runs([played] { return run_hand_emulate(*played); });
}

}  // namespace isograsp::app
