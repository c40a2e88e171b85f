// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/message_texts.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/files.hpp"
#include "device/config/family_facts.hpp"
#include "tests/gui/source_messages.hpp"

namespace isograsp::gui {

namespace {

namespace fs = std::filesystem;
using Texts = std::set<std::string>;

/// Of all sources below the windows and of the windows themselves.
Texts messages_below(const std::string& source_folder) {
  // The command line alone reaches these, and pages of reports are not in this language.
  static const std::set<std::string> kElsewhere{
      "emulator",        "import.cpp",           "merge.cpp",
      "person_rows.cpp", "protocol_run.cpp",     "read_recording.cpp",
      "recording.cpp",   "study_analysis.cpp",   "study_data.cpp",
      "study_file.cpp",  "last_trial_plots.cpp", "patient_page.cpp"};
  Texts messages;
  const auto take = [&](const fs::path& file) {
    const auto code = read_text(file);
    if (code) messages.merge(messages_in(*code));
  };
  for (const char* folder :
       {"core", "hand", "device", "grasp_model", "virtual_patient", "statistics", "tasks",
        "storage", "session", "exports", "reports", "gui"}) {
    fs::recursive_directory_iterator at(source_folder + "/" + folder);
    for (const auto end = fs::end(at); at != end; ++at) {
      if (kElsewhere.count(at->path().filename()) > 0) {
        at.disable_recursion_pending();
        continue;
      }
      const auto kind = at->path().extension();
      if (kind == ".cpp" || kind == ".hpp") take(at->path());
    }
  }
  return messages;
}

/// What messages name: words that stand at the places of others.
Texts named_in_messages() {
  Texts texts{
      // of a sensor
      "the thumb's sensor", "the index's sensor", "the middle's sensor", "the thumb's sensor (%1)",
      "the index finger's sensor (%1)", "the middle finger's sensor (%1)", "base %1",
      "%1 shifts or turns its forces before it sends them", "%1 sends at %2 Hz, not at %3",
      "%1 does not tell its rate", "identifier %1", "subdevice %1", "node %1",
      "its error code is %1", "calibration slot %1 was asked for, it chose slot %2",
      "calibration slot %1 holds a matrix, counts or units that cannot be used",
      "it says itself that calibration slot %1 is bad",
      "it says that its sensor is not initialised", "one of its full scales is zero",
      "one of its full scales is not positive",
      "check its cable; after it was plugged in the card needs ten seconds",
      "check its power, its cable, its address and the baud rate",
      "check its power, its cable and its address",
      "check its power, its cable and the 120 ohm at both ends of the bus",
      "%1, and the bit rate of the interface: boards leave the factory at 250 kbit/s",
      "it does not answer in time", "it refuses the connection", "the network", "serial lines",
      // of a file
      "a table", "an array", "text", "an integer", "a number", "true or false", "a date or time",
      "%1 values", "%1 to %2", "missing", "mass", "inertia",
      // of this computer
      "SCHED_FIFO %1, memory locked", "SCHED_FIFO %1, memory not locked (%2)",
      "ordinary scheduling (%1), memory locked", "ordinary scheduling (%1), memory not locked (%2)",
      "not permitted", "the limit memlock is not unlimited",
      "The clock of this computer is behind the newest session of this file (%1).",
      // of people and what is stored of them
      "right", "left", "thumb", "index", "middle", "therapist", "researcher", "administrator",
      "maximum force", "comfortable force", "primary measure", "stable time", "treatment mark",
      "clinical score", "'%1' is the name of another file", "No tasks in %1/tasks.",
      // of the families of sensors
      "use " + family_names()};
  // Of the system, in the words of the C library.
  for (const int failure :
       {EACCES,       EADDRINUSE,   EADDRNOTAVAIL, EBUSY,  ECONNREFUSED, ECONNRESET, EDQUOT,
        EEXIST,       EHOSTUNREACH, EINVAL,        EIO,    EISDIR,       ELOOP,      EMFILE,
        ENAMETOOLONG, ENETDOWN,     ENETUNREACH,   ENODEV, ENOENT,       ENOMEM,     ENOSPC,
        ENOTDIR,      ENOTEMPTY,    ENXIO,         EPERM,  EROFS,        ETIMEDOUT,  ETXTBSY})
    texts.insert(std::strerror(failure));
  // Of the parser of TOML, as version 3.3 has it.
  for (const char* text :
       {"Error while parsing %1: %2",
        "expected %1, saw %2",
        "comma",
        "key",
        "value",
        "comment",
        "array",
        "boolean",
        "date",
        "time",
        "date-time",
        "date-time offset",
        "floating-point",
        "inline table",
        "key-value pair",
        "literal string",
        "root table",
        "string",
        "table header",
        "a comment or whitespace",
        "keys, tables, whitespace or comments",
        "value-terminator",
        "bare key starting character or string delimiter",
        "decimal digit",
        "digit",
        "comma or closing ']'",
        "comma or closing '}'",
        "value or closing ']'",
        "key or closing '}'",
        "key-value pair or closing '}'",
        "hex digit",
        "exponent digit",
        "exponent digit or sign",
        "fractional digits",
        "encountered end-of-file",
        "cannot redefine existing %1 '%2'",
        "cannot redefine existing %1 '%2' as %3",
        "unknown escape sequence '%1'",
        "could not determine value type",
        "underscores may only follow digits",
        "underscores must be followed by digits",
        "leading zeroes are prohibited",
        "unexpected control character",
        "missing exponent",
        "tables with blank bare keys are explicitly prohibited",
        "values may not begin with underscores",
        "unescaped control characters other than TAB (U+0009) are explicitly prohibited",
        "control characters other than TAB (U+0009) are explicitly prohibited",
        "control characters other than TAB (U+0009) are explicitly prohibited in comments",
        "exceeded maximum nested value depth of %1"})
    texts.insert(text);
  return texts;
}

/// What a device or a recording is called where it is not one of the library.
Texts descriptions() {
  Texts texts{"Recorded forces, %1", "Simulated sensors, %1 patient"};
  for (const FamilyFacts* family : all_families()) {
    const std::string title(family->title);
    texts.insert(title + " on %1");
    texts.insert("Recorded frames of " + title + ", %1");
  }
  return texts;
}

}  // namespace

std::set<std::string> texts_of_messages(const std::string& source_folder) {
  Texts texts = messages_below(source_folder);
  texts.merge(named_in_messages());
  texts.merge(descriptions());
  return texts;
}

std::set<std::string> patterns_of_messages(const std::string& source_folder) {
  Texts texts = texts_of_messages(source_folder);
  // "3 values" is found by its number (gui/words/texts.hpp).
  std::erase_if(texts, [](const auto& text) {
    return text.find("%1") == std::string::npos || text == "%1 to %2" || text == "%1 values";
  });
  return texts;
}

}  // namespace isograsp::gui
