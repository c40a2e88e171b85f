// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/qtm_rt_log.hpp"

#include <optional>

#include "device/bus/datagram_log.hpp"
#include "device/markers/marker_csv.hpp"

namespace isograsp {

Result<QtmRtCounts> convert_qtm_rt_log(const std::string& log, const std::string& out) {
  auto reader = DatagramLogReader::open(log);
  if (!reader) return reader.error();
  QtmRtStream stream;
  std::optional<MarkerCsvWriter> writer;
  std::optional<Error> problem;
  std::int64_t first_us = 0;
  std::int64_t last_us = 0;
  const auto row = [&](const QtmRtStream::Row& frame) {
    constexpr double kMicroseconds = 1e6;
    if (problem) return;
    if (!writer) {
      auto created = MarkerCsvWriter::create(out, stream.labels());
      if (!created) {
        problem = created.error();
        return;
      }
      writer.emplace(std::move(*created));
      first_us = frame.stamp_us;
    } else if (frame.stamp_us <= last_us) {
      problem = refused("the time of frame %1 does not increase"_text(frame.frame),
                        "record each measurement by itself"_text)
                    .at(log);
      return;
    }
    last_us = frame.stamp_us;
    writer->write(static_cast<double>(frame.stamp_us - first_us) / kMicroseconds, frame.p_W);
  };
  std::optional<Endpoint> server;
  DatagramEntry entry;
  for (;;) {
    const auto more = reader->next(entry);
    if (!more) return more.error();
    if (!*more) break;
    if (!server) server = entry.from;
    if (entry.from != *server) continue;
    if (auto taken = stream.take(entry.bytes, row); !taken) return Error(taken.error()).at(log);
    if (problem) return *problem;
  }
  if (!writer)
    return refused("holds no frame of labelled markers"_text,
                   "record the stream from its beginning, with its parameters"_text)
        .at(log);
  if (auto done = writer->commit(); !done) return done.error();
  return stream.counts();
}

}  // namespace isograsp
