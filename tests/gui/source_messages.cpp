// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/source_messages.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <vector>

namespace isograsp::gui {

namespace {

struct Token {
  bool literal = false;
  std::string text;  ///< of a literal: without its quotes and escapes
};

/// Quoted text up to `at`, which stands at its first quote and then behind its last.
std::string quoted(std::string_view code, std::size_t& at) {
  std::string text;
  const char quote = code[at];
  for (++at; at < code.size() && code[at] != quote; ++at) {
    if (code[at] == '\\' && at + 1 < code.size()) {
      ++at;
      if (code[at] == 'n') {
        text += '\n';
        continue;
      }
    }
    text += code[at];
  }
  ++at;
  return text;
}

bool of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Comments left out. Literals side by side are one, as for the compiler.
std::vector<Token> tokens_of(std::string_view code) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  while (at < code.size()) {
    const auto rest = code.substr(at);
    if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
      ++at;
    } else if (rest.starts_with("//") || rest.starts_with("#include")) {
      at = std::min(code.find('\n', at), code.size());
    } else if (rest.starts_with("/*")) {
      at = std::min(code.find("*/", at), code.size() - 2) + 2;
    } else if (rest.starts_with("R\"(")) {
      const auto end = std::min(code.find(")\"", at), code.size() - 2);
      tokens.push_back({true, std::string(code.substr(at + 3, end - at - 3))});
      at = end + 2;
    } else if (rest[0] == '"') {
      const auto text = quoted(code, at);
      if (!tokens.empty() && tokens.back().literal)
        tokens.back().text += text;
      else
        tokens.push_back({true, text});
    } else if (of_word(rest[0])) {
      const auto end = std::find_if_not(rest.begin(), rest.end(), of_word);
      tokens.push_back({false, std::string(rest.begin(), end)});
      at += tokens.back().text.size();
      if (at < code.size() && code[at] == '\'' && std::isdigit(tokens.back().text[0]) != 0) ++at;
    } else if (rest[0] == '\'') {
      tokens.push_back({false, "'" + quoted(code, at)});
    } else {
      static constexpr std::array<std::string_view, 10> kLong{
          "::", "+=", "==", "!=", "<=", ">=", "&&", "||", "<<", "->"};
      const auto sign =
          std::find_if(kLong.begin(), kLong.end(), [&](auto s) { return rest.starts_with(s); });
      tokens.push_back({false, std::string(sign == kLong.end() ? rest.substr(0, 1) : *sign)});
      at += tokens.back().text.size();
    }
  }
  return tokens;
}

/// Goes through one source and remembers in which call, and in which statement, it is.
class Reader {
 public:
  explicit Reader(std::string_view code) : tokens_(tokens_of(code)) {}

  std::set<std::string> messages() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if ((i == 0 || begins_operand(tokens_[i - 1])) && is_message(i)) add(i);
      follow(i);
    }
    return std::move(found_);
  }

 private:
  struct Bracket {
    char sign;
    std::string before;  ///< the word before it: the name of a call
    std::size_t statement;
  };

  [[nodiscard]] bool mark(std::size_t i, std::string_view text) const {
    return i < tokens_.size() && !tokens_[i].literal && tokens_[i].text == text;
  }

  static bool begins_operand(const Token& before) {
    static const std::set<std::string> kSigns{"(", ",", "{", "=", "return", "?", ":", "+="};
    return !before.literal && kSigns.count(before.text) > 0;
  }

  void follow(std::size_t i) {
    const Token& token = tokens_[i];
    if (token.literal || token.text.size() != 1) return;
    const char sign = token.text[0];
    if (sign == ';') statement_ = i + 1;
    if (sign == '(' || sign == '[' || sign == '{') {
      const bool named = i > 0 && !tokens_[i - 1].literal && of_word(tokens_[i - 1].text[0]);
      open_.push_back({sign, named ? tokens_[i - 1].text : "", statement_});
      if (sign == '{') statement_ = i + 1;
    } else if ((sign == ')' || sign == ']' || sign == '}') && !open_.empty()) {
      // Behind a block a statement begins; an initializer is a part of its own.
      statement_ = sign == '}' && open_.back().before.empty() ? i + 1 : open_.back().statement;
      open_.pop_back();
    }
  }

  /// An argument of something that refuses, or what a variable of that meaning is set to.
  [[nodiscard]] bool is_message(std::size_t i) const {
    static const std::regex kCall(
        "(fail|failed|failure|refused?|refuse|bad|wrong|damaged|error|give_up|nothing_to_resume|"
        "guard|transact|audited|explain|empty_log|report|no_row)(_\\w+)?|Hdf5Error|"
        "\\w*_(error|failed)|not_\\w+");
    static const std::regex kName("\\w*what|\\w*remedy|why|doing|k\\w*(Remedy|Shape)");
    auto around = open_.rbegin();
    static const std::set<std::string> kTransparent{"", "string", "move"};
    while (around != open_.rend() && around->sign == '(' && kTransparent.count(around->before) > 0)
      ++around;
    if (around != open_.rend() && around->before == "tr") return false;
    if (around != open_.rend() && std::regex_match(around->before, kCall)) return true;
    const auto from = tokens_.begin() + static_cast<std::ptrdiff_t>(statement_);
    const auto is_one = [&](const Token& token) {
      return !token.literal && std::regex_match(token.text, kName);
    };
    const auto to = tokens_.begin() + static_cast<std::ptrdiff_t>(i);
    return std::any_of(from, to, is_one);
  }

  /// Behind the operand at `i`.
  [[nodiscard]] std::size_t behind_operand(std::size_t i) const {
    static const std::set<std::string> kEnds{",",  ";",  "+",  "?",  ":",  "=",
                                             "+=", "==", "!=", "&&", "||", "<<"};
    int depth = 0;
    for (; i < tokens_.size(); ++i) {
      if (tokens_[i].literal) continue;
      const auto& text = tokens_[i].text;
      if (text == "(" || text == "[" || text == "{") ++depth;
      if ((text == ")" || text == "]" || text == "}") && --depth < 0) break;
      if (depth == 0 && kEnds.count(text) > 0) break;
    }
    return i;
  }

  /// The sum that begins here, if it has fixed words.
  void add(std::size_t i) {
    std::string pattern;
    int places = 0;
    while (true) {
      const auto end = behind_operand(i);
      if (end == i) return;
      // "…" or std::string("…")
      const bool plain = end == i + 1 && tokens_[i].literal;
      const bool wrapped = end > i + 3 && mark(end - 1, ")") && tokens_[end - 2].literal &&
                           mark(end - 3, "(") && mark(end - 4, "string");
      if (plain || wrapped)
        pattern += tokens_[plain ? i : end - 2].text;
      else
        pattern += "%" + std::to_string(++places);
      if (!mark(end, "+")) break;
      i = end + 1;
    }
    static const std::regex kWords("(.*[^%\\w])?[A-Za-z]{2,}.* .*|.* .*[A-Za-z]{2,}.*");
    static const std::regex kNoWords(
        "(SELECT|INSERT|UPDATE|DELETE|PRAGMA|VACUUM|ATTACH) .*|[(<].*");
    if (pattern.find('\n') == std::string::npos && std::regex_match(pattern, kWords) &&
        !std::regex_match(pattern, kNoWords) && !pattern.ends_with(' '))
      found_.insert(pattern);
  }

  std::vector<Token> tokens_;
  std::vector<Bracket> open_;
  std::size_t statement_ = 0;
  std::set<std::string> found_;
};

}  // namespace

std::set<std::string> messages_in(std::string_view code) {
  return Reader(code).messages();
}

}  // namespace isograsp::gui
