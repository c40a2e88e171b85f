// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toml_reader.hpp"

#include <cmath>
#include <cstdint>
#include <set>

#define TOML_EXCEPTIONS 0  // the packaged library is built with exceptions: use the headers alone
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

namespace isograsp {

struct TomlReader::Document {
  toml::table root;
  std::string file;
  std::optional<Error> first_error;
  std::set<const toml::node*> asked;

  void report(int line, std::string field, std::string what, std::string remedy) {
    if (first_error) return;
    first_error = Error{Error::Code::bad_input, std::move(what), std::move(remedy), file, line,
                        std::move(field)};
  }
};

struct TomlReader::Node {
  toml::table* table = nullptr;  ///< null: an absent optional table
  std::string path;              ///< "dynamics." or "contact[2]."
};

namespace {

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "text";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
  }
}

std::optional<double> finite_number(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  if (const auto* number = node.as_floating_point())
    if (std::isfinite(number->get())) return number->get();
  return std::nullopt;
}

std::string joined(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const auto name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// The first key of the tree that is not in `asked`, with its path.
const toml::node* first_unasked(const toml::table& table, const std::set<const toml::node*>& asked,
                                const std::string& path, std::string& field) {
  for (const auto& [key, node] : table) {
    const std::string here = path + std::string(key.str());
    if (asked.count(&node) == 0) {
      field = here;
      return &node;
    }
    if (const auto* inner = node.as_table()) {
      if (const auto* found = first_unasked(*inner, asked, here + ".", field)) return found;
    } else if (const auto* array = node.as_array()) {
      for (std::size_t i = 0; i < array->size(); ++i) {
        const auto* item = array->get(i)->as_table();
        if (item == nullptr) continue;
        if (const auto* found =
                first_unasked(*item, asked, here + "[" + std::to_string(i + 1) + "].", field))
          return found;
      }
    }
  }
  return nullptr;
}

}  // namespace

TomlReader::TomlReader(std::shared_ptr<Document> document, std::shared_ptr<Node> node)
    : document_(std::move(document)), node_(std::move(node)) {}

Result<TomlReader> TomlReader::parse(std::string_view text, std::string file,
                                     std::string_view format) {
  toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const auto& error = parsed.error();
    return Error{Error::Code::bad_input,
                 "not valid TOML: " + std::string(error.description()),
                 "correct the syntax",
                 std::move(file),
                 static_cast<int>(error.source().begin.line),
                 ""};
  }
  auto document = std::make_shared<Document>();
  document->root = std::move(parsed).table();
  document->file = std::move(file);
  auto node = std::make_shared<Node>(Node{&document->root, ""});
  TomlReader reader(document, node);
  const std::string found = reader.text("format");
  if (!document->first_error && found != format)
    reader.fail("format", "'" + found + "' is not the expected format",
                "give a file whose first line is: format = \"" + std::string(format) + "\"");
  if (document->first_error) return *document->first_error;
  return reader;
}

bool TomlReader::has(std::string_view key) const {
  return node_->table != nullptr && node_->table->contains(key);
}

namespace {
/// Marks the key as asked for and returns its node; reports a required key that is absent.
template <class Document, class Node>
toml::node* take(Document& document, Node& node, std::string_view key, bool required) {
  toml::node* found = node.table == nullptr ? nullptr : node.table->get(key);
  if (found != nullptr) {
    document.asked.insert(found);
  } else if (required) {
    document.report(node.table == nullptr ? 0 : line_of(*node.table), node.path + std::string(key),
                    "is missing", "add it");
  }
  return found;
}
}  // namespace

double TomlReader::number(std::string_view key, std::optional<double> fallback) {
  const toml::node* node = take(*document_, *node_, key, !fallback);
  if (node == nullptr) return fallback.value_or(0.0);
  if (const auto value = finite_number(*node)) return *value;
  fail(key, "is " + kind_of(*node) + ", not a finite number", "write a number");
  return fallback.value_or(0.0);
}

std::int64_t TomlReader::integer(std::string_view key, std::optional<std::int64_t> fallback) {
  const toml::node* node = take(*document_, *node_, key, !fallback);
  if (node == nullptr) return fallback.value_or(0);
  if (const auto* value = node->as_integer()) return value->get();
  fail(key, "is " + kind_of(*node) + ", not an integer", "write a whole number");
  return fallback.value_or(0);
}

bool TomlReader::boolean(std::string_view key, std::optional<bool> fallback) {
  const toml::node* node = take(*document_, *node_, key, !fallback);
  if (node == nullptr) return fallback.value_or(false);
  if (const auto* value = node->as_boolean()) return value->get();
  fail(key, "is " + kind_of(*node) + ", not true or false", "write true or false");
  return fallback.value_or(false);
}

std::string TomlReader::text(std::string_view key, std::optional<std::string> fallback) {
  const toml::node* node = take(*document_, *node_, key, !fallback);
  if (node == nullptr) return fallback.value_or("");
  if (const auto* value = node->as_string()) return value->get();
  fail(key, "is " + kind_of(*node) + ", not text", "write it in double quotes");
  return fallback.value_or("");
}

std::size_t TomlReader::choice(std::string_view key, std::initializer_list<std::string_view> names,
                               std::optional<std::size_t> fallback) {
  const bool present = has(key);
  if (!present && fallback) return *fallback;
  const std::string word = text(key);
  std::size_t index = 0;
  for (const auto name : names) {
    if (word == name) return index;
    ++index;
  }
  if (present) fail(key, "'" + word + "' is not known", "write one of: " + joined(names));
  return 0;
}

std::vector<double> TomlReader::numbers(std::string_view key, std::size_t least, std::size_t most,
                                        bool required) {
  const toml::node* node = take(*document_, *node_, key, required);
  std::vector<double> values;
  if (node == nullptr) {
    if (required) values.assign(least, 0.0);
    return values;
  }
  const toml::array* array = node->as_array();
  const std::string count =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  if (array == nullptr || array->size() < least || array->size() > most) {
    const std::string found =
        array == nullptr ? kind_of(*node) : std::to_string(array->size()) + " values";
    fail(key, "is " + found + ", not an array of " + count + " numbers",
         "write " + count + " numbers in brackets");
  } else {
    for (const auto& item : *array) {
      const auto value = finite_number(item);
      if (!value)
        fail(key, "holds " + kind_of(item) + " that is not a finite number", "write numbers");
      values.push_back(value.value_or(0.0));
    }
  }
  if (values.size() < least) values.resize(least, 0.0);
  return values;
}

Vec3 TomlReader::vec3(std::string_view key, std::optional<Vec3> fallback) {
  if (!has(key) && fallback) return *fallback;
  const auto values = numbers(key, 3, 3);
  return {values[0], values[1], values[2]};
}

std::vector<std::string> TomlReader::texts(std::string_view key, bool required) {
  const toml::node* node = take(*document_, *node_, key, required);
  std::vector<std::string> values;
  if (node == nullptr) return values;
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    fail(key, "is " + kind_of(*node) + ", not an array of texts", "write texts in brackets");
    return values;
  }
  for (const auto& item : *array) {
    if (const auto* value = item.as_string())
      values.push_back(value->get());
    else
      fail(key, "holds " + kind_of(item) + ", not text", "write each entry in double quotes");
  }
  return values;
}

TomlReader TomlReader::table(std::string_view key, bool required) {
  toml::node* node = take(*document_, *node_, key, required);
  toml::table* inner = node == nullptr ? nullptr : node->as_table();
  if (node != nullptr && inner == nullptr)
    fail(key, "is " + kind_of(*node) + ", not a table",
         "write it as [" + node_->path + std::string(key) + "]");
  return {document_, std::make_shared<Node>(Node{inner, node_->path + std::string(key) + "."})};
}

std::vector<TomlReader> TomlReader::tables(std::string_view key) {
  toml::node* node = take(*document_, *node_, key, false);
  std::vector<TomlReader> readers;
  if (node == nullptr) return readers;
  toml::array* array = node->as_array();
  if (array == nullptr) {
    fail(key, "is " + kind_of(*node) + ", not a list of tables",
         "write each as [[" + node_->path + std::string(key) + "]]");
    return readers;
  }
  for (std::size_t i = 0; i < array->size(); ++i) {
    toml::table* item = array->get(i)->as_table();
    if (item == nullptr) {
      fail(key, "holds " + kind_of(*array->get(i)) + ", not a table", "write a table");
      continue;
    }
    readers.push_back(TomlReader(
        document_, std::make_shared<Node>(Node{item, node_->path + std::string(key) + "[" +
                                                         std::to_string(i + 1) + "]."})));
  }
  return readers;
}

void TomlReader::fail(std::string_view key, std::string what, std::string remedy) {
  int line = 0;
  if (node_->table != nullptr) {
    const toml::node* node = node_->table->get(key);
    line = line_of(node == nullptr ? static_cast<const toml::node&>(*node_->table) : *node);
  }
  document_->report(line, node_->path + std::string(key), std::move(what), std::move(remedy));
}

Result<void> TomlReader::finish() const {
  if (document_->first_error) return *document_->first_error;
  std::string field;
  if (const auto* node = first_unasked(document_->root, document_->asked, "", field))
    return Error{Error::Code::bad_input, "unknown key",  "remove it or correct its spelling",
                 document_->file,        line_of(*node), field};
  return {};
}

}  // namespace isograsp
