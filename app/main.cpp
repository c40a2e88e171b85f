// SPDX-License-Identifier: GPL-3.0-or-later
// The one executable: parses the command line, runs the chosen subcommand, reports its error.
#include <vector>

#include <sys/stat.h>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/language.hpp"
#include "app/stop_signals.hpp"

int main(int argc, char** argv) {
  using isograsp::operator""_text;
  // Files and folders that the program makes hold people's records: for their owner only.
  umask(S_IRWXG | S_IRWXO);
  isograsp::app::let_writes_fail();
  isograsp::app::CommandLine line(
      "IsoGrasp: assessment and training of hand dexterity with isometric finger forces",
      "isograsp " ISOGRASP_VERSION,
      "isograsp COMMAND --language en|de|fr: messages in that language, else in the one set in the "
      "windows, else in the desktop's");
  isograsp::app::add_convert(line);
  isograsp::app::add_db(line);
  isograsp::app::add_decode(line);
  isograsp::app::add_demo(line);
  isograsp::app::add_devices(line);
  isograsp::app::add_emulate(line);
  isograsp::app::add_export(line);
  isograsp::app::add_grasp(line);
  isograsp::app::add_gui(line);
  isograsp::app::add_hand(line);
  isograsp::app::add_import(line);
  isograsp::app::add_markers(line);
  isograsp::app::add_monitor(line);
  isograsp::app::add_record(line);
  isograsp::app::add_report(line);
  isograsp::app::add_run(line);
  isograsp::app::add_score(line);
  isograsp::app::add_simulate(line);
  isograsp::app::add_study(line);
  isograsp::app::add_target(line);
  isograsp::app::add_patch(line);
  isograsp::app::add_pad_bench(line);
  isograsp::app::add_verify_export(line);

  std::vector<const char*> words(argv, argv + argc);
  if (const auto chosen = isograsp::app::choose_language(words); !chosen)
    return isograsp::app::print_error(chosen.error());
  const auto action = line.parse(static_cast<int>(words.size()), words.data());
  if (!action) return isograsp::app::print_error(action.error());
  try {
    const auto done = *action ? (*action)() : isograsp::app::run_gui("", "");
    return done ? 0 : isograsp::app::print_error(done.error());
  } catch (const std::exception& unforeseen) {  // such as no memory
    return isograsp::app::print_error(
        isograsp::failed("unexpected: %1"_text(unforeseen.what()),
                         "report it (SECURITY.md if a file caused it)"_text));
  }
}
