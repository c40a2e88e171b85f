// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/natnet_log.hpp"

#include <optional>

#include "device/bus/datagram_log.hpp"
#include "device/markers/marker_csv.hpp"
#include "device/markers/marker_reader.hpp"

namespace isograsp {

Result<NatNetLogCounts> convert_natnet_log(const std::string& log, const std::string& out) {
  auto reader = DatagramLogReader::open(log);
  if (!reader) return reader.error();
  NatNetStream stream;
  NatNetStream::Row row;
  NatNetLogCounts counts;
  std::optional<MarkerCsvWriter> writer;
  std::optional<std::uint32_t> server;
  double first_s = 0.0, last_s = 0.0;
  std::int32_t last_frame = 0;
  DatagramEntry entry;
  for (;;) {
    const auto more = reader->next(entry);
    if (!more) return more.error();
    if (!*more) break;
    if (server && entry.from.address != *server) continue;
    switch (stream.take(entry.bytes, row)) {
      case NatNetStream::Step::nothing:
      case NatNetStream::Step::labels:
      case NatNetStream::Step::rate: break;
      case NatNetStream::Step::server: server = entry.from.address; break;
      case NatNetStream::Step::unknown_version:
        return refused("the stream is NatNet %1, which is not known"_text(stream.version()->text()),
                       "let Motive stream version 2.5 to 4.1"_text)
            .at(log);
      case NatNetStream::Step::other_labels:
        return refused("the labels change within the stream"_text,
                       "record each set of markers by itself"_text)
            .at(log);
      case NatNetStream::Step::row: {
        if (!writer) {
          if (auto good = check_labels(stream.labels(), log); !good) return good.error();
          auto created = MarkerCsvWriter::create(out, stream.labels());
          if (!created) return created.error();
          writer.emplace(std::move(*created));
          first_s = row.stamp_s;
        } else if (row.frame <= last_frame) {
          ++counts.repeated;
          break;
        } else if (row.stamp_s <= last_s) {
          return refused("the time of frame %1 does not increase"_text(row.frame),
                         "record each measurement by itself"_text)
              .at(log);
        }
        last_frame = row.frame;
        last_s = row.stamp_s;
        ++counts.rows;
        writer->write(row.stamp_s - first_s, row.p_W);
        break;
      }
    }
  }
  counts.stream = stream.counts();
  if (!writer)
    return refused("holds no frame of labelled markers"_text,
                   "record the stream from its beginning, with its parameters"_text)
        .at(log);
  if (auto done = writer->commit(); !done) return done.error();
  return counts;
}

}  // namespace isograsp
