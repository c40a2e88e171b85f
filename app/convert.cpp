// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp convert: CSV logs of any origin to a finger-forces file.
#include <cstdio>
#include <filesystem>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/paths.hpp"
#include "core/csv.hpp"
#include "device/recording/csv_mapping.hpp"

namespace isograsp::app {

namespace {

struct ConvertOptions {
  std::string mapping;
  std::string input;
  std::string out;
  bool json = false;
};

/// A path, or the bare name of a mapping that comes with the program.
std::string mapping_path(const std::string& name) {
  const auto shipped =
      std::filesystem::path(library_folder()) / "devices" / "mappings" / (name + ".toml");
  std::error_code ignored;
  if (!std::filesystem::exists(name, ignored) && std::filesystem::exists(shipped, ignored))
    return shipped;
  return name;
}

Result<void> run_convert(const ConvertOptions& options) {
  const std::string path = mapping_path(options.mapping);
  const auto text = read_text(path);
  if (!text) return text.error();
  const auto mapping = parse_csv_mapping(*text, path);
  if (!mapping) return mapping.error();
  const auto converted = convert_csv(*mapping, options.input, options.out);
  if (!converted) return converted.error();
  if (options.json) {
    const nlohmann::ordered_json document{{"out", options.out},
                                          {"rows", converted->rows},
                                          {"first_s", converted->first_s},
                                          {"last_s", converted->last_s},
                                          {"provenance", converted->comments}};
    print_json(document);
    return {};
  }
  print_line("%1: %2 rows, %3 s to %4 s"_text(
      options.out, converted->rows, shortest(converted->first_s), shortest(converted->last_s)));
  for (const auto& comment : converted->comments) print("  %s\n", printable(comment).c_str());
  return {};
}

}  // namespace

void add_convert(CommandLine& line) {
  auto options = std::make_shared<ConvertOptions>();
  Subcommand command = line.subcommand("convert", "Finger forces from CSV logs of any origin");
  command
      .option("--mapping", options->mapping,
              "Mapping file (TOML), or the name of one in library/devices/mappings")
      .required();
  command.option("--input", options->input,
                 "Folder of the logs; without it the folder of the mapping file");
  command.option("--out", options->out, "Finger-forces file to write (CSV)").required();
  command.flag("--json", options->json, "Print one JSON document");
  command.footer(
      "Example:\n  isograsp convert --mapping kth_handover --input recordings --out forces.csv");
  command.runs([options] { return run_convert(*options); });
}

}  // namespace isograsp::app
