// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp verify-export: is a research export what the clinic has made?
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "exports/export_list.hpp"
#include "storage/crypto/signature.hpp"

namespace isograsp::app {

namespace {

struct VerifyOptions {
  std::string folder;
  std::string key;
  bool json = false;
};

Result<void> verify_export(const VerifyOptions& options) {
  const auto proof = exports::prove_export(options.folder, options.key);
  if (!proof) return proof.error();
  auto problems = nlohmann::ordered_json::array();
  Lines text;
  for (const Text& problem : proof->problems) {
    problems.push_back(english(problem));
    text.add(problem);
  }
  const bool is_signed = !proof->key.empty();
  if (proof->problems.empty())
    text.add(
        is_signed
            ? "%1: %2 files, as they were signed"_text(options.folder, proof->files)
            : "%1: %2 files, as its list says, which anybody can have made: it is not signed"_text(
                  options.folder, proof->files));
  if (is_signed) text.add(words_of_key(proof->key, !options.key.empty()));
  const nlohmann::ordered_json json{{"folder", options.folder},
                                    {"files", proof->files},
                                    {"key", proof->key},
                                    {"key_was_given", !options.key.empty()},
                                    {"problems", problems}};
  if (options.json)
    print_json(json);
  else
    print_lines(text);
  if (!proof->problems.empty())
    return failed(proof->problems.size() == 1
                      ? Text("1 file is not what was exported"_text)
                      : "%1 files are not what was exported"_text(proof->problems.size()),
                  "ask for a copy that is as it was made"_text)
        .at(options.folder);
  if (!is_signed)
    return failed("is not signed"_text, "ask the clinic for an export with SHA256SUMS.sig"_text)
        .at(options.folder);
  return {};
}

}  // namespace

Text words_of_key(const std::string& key, bool was_given) {
  if (was_given) return "signed with the key that was given"_text;
  return "signed with the key %1, which nobody vouches for here: compare it with the one on a report, or give it with --key"_text(
      key);
}

std::string objection_to_key(const std::string& key) {
  constexpr std::size_t kDigits = 64;
  return storage::is_hex(key, kDigits)
             ? ""
             : "is no public key: give its 64 digits, as isograsp db audit prints them";
}

void add_verify_export(CommandLine& line) {
  auto options = std::make_shared<VerifyOptions>();
  Subcommand command =
      line.subcommand("verify-export", "Is a research export what the clinic has made?");
  command.option("FOLDER", options->folder, "Folder of the export").required();
  command
      .option("--key", options->key,
              "Public key of the clinic (64 digits), as on its reports and in isograsp db audit")
      .check(objection_to_key);
  command.flag("--json", options->json, "Print one JSON document");
  command.footer("Example:\n  isograsp verify-export study --key KEY");
  command.runs([options] { return verify_export(*options); });
}

}  // namespace isograsp::app
