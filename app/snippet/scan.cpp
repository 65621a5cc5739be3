#include "snippet/scan.h"

#include <cctype>
#include <string_view>

namespace gg::snippet {
namespace {

bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::string_view view(const std::string& text, const Token& token) {
  return std::string_view(text).substr(token.begin, token.end - token.begin);
}

bool opens(char c) {
  return c == '{' || c == '(' || c == '[';
}
bool closes(char c) {
  return c == '}' || c == ')' || c == ']';
}

// Past a preprocessor line, with the lines that it is continued on.
std::size_t past_line(const std::string& text, std::size_t at) {
  while (at < text.size() && (text[at] != '\n' || text[at - 1] == '\\'))
    ++at;
  return at;
}

std::size_t past(const std::string& text, std::size_t at, const char* end) {
  const std::size_t found = text.find(end, at);
  return found == std::string::npos ? text.size() : found + (*end == '*' ? 2 : 0);
}

// One declaration: the tokens from `first` up to `last`, which is its `;` or `}`.
class Declaration {
public:
  Declaration(const std::string& text, const std::vector<Token>& all, std::size_t first,
              std::size_t last)
      : text_(text), all_(all), first_(first), last_(last) {}

  Item item() const {
    Item item;
    item.begin = all_[first_].begin;
    item.end = all_[last_].end;
    std::size_t brace = first_, open = 0;
    while (brace < last_ && at(brace) != "{")
      ++brace;
    // The list of parameters is the last in parentheses before the body: attributes come before.
    for (std::size_t i = first_; i < brace; ++i)
      if (at(i) == "(" && all_[i].depth == 0 && i > first_ && is_word(text_, all_[i - 1])) open = i;
    if (word(first_) == "struct") {
      item.kind = Item::Kind::structure;
      item.name = word(first_ + 1);
    } else if (word(first_) == "const") {
      item.kind = Item::Kind::constant;
      const bool wgsl = first_ + 2 <= last_ && at(first_ + 2) == ":";
      item.type = word(first_ + 1);
      item.name = word(first_ + (wgsl ? 1 : 2));
    } else if (open > first_ + 1) {
      item.kind = at(last_) == "}" ? Item::Kind::function : Item::Kind::prototype;
      item.name = word(open - 1);
      item.type = word(open - 2);
      std::size_t close = open + 1;
      while (close < last_ && !(at(close) == ")" && all_[close].depth == 0))
        ++close;
      item.header_end = all_[close].end;
      item.parameters = parameters(open + 1, close);
    }
    return item;
  }

private:
  std::string_view at(std::size_t i) const { return view(text_, all_[i]); }
  std::string word(std::size_t i) const { return i <= last_ ? std::string(at(i)) : std::string(); }

  std::vector<Parameter> parameters(std::size_t begin, std::size_t close) const {
    std::vector<Parameter> list;
    for (std::size_t i = begin; i < close;) {
      std::size_t end = i;
      while (end < close && !(at(end) == "," && all_[end].depth == 1))
        ++end;
      if (end >= i + 2) list.push_back({all_[i].begin, word(end - 2), word(end - 1)});
      i = end + 1;
    }
    return list;
  }

  const std::string& text_;
  const std::vector<Token>& all_;
  std::size_t first_, last_;
};

} // namespace

bool is_word(const std::string& text, const Token& token) {
  return in_word(text[token.begin]) && !std::isdigit(static_cast<unsigned char>(text[token.begin]));
}

std::vector<Token> tokens(const std::string& text) {
  std::vector<Token> all;
  int depth = 0;
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '\n') line_begins = true;
    if (std::isspace(static_cast<unsigned char>(c))) {
      ++at;
    } else if (c == '#' && line_begins) {
      at = past_line(text, at);
    } else if (text.compare(at, 2, "//") == 0) {
      at = past(text, at, "\n");
    } else if (text.compare(at, 2, "/*") == 0) {
      at = past(text, at, "*/");
    } else {
      line_begins = false;
      std::size_t end = at + 1;
      if (in_word(c))
        while (end < text.size() && in_word(text[end]))
          ++end;
      if (closes(c)) --depth;
      all.push_back({at, end, depth});
      if (opens(c)) ++depth;
      at = end;
    }
  }
  return all;
}

std::vector<Item> items(const std::string& text) {
  const std::vector<Token> all = tokens(text);
  std::vector<Item> found;
  std::size_t first = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string_view token = view(text, all[i]);
    if (all[i].depth != 0 || (token != ";" && token != "}")) continue;
    // A struct in C has its semicolon after the brace.
    const bool semicolon = token == "}" && i + 1 < all.size() && view(text, all[i + 1]) == ";";
    if (i > first) {
      found.push_back(Declaration(text, all, first, i).item());
      if (semicolon) found.back().end = all[i + 1].end;
    }
    if (semicolon) ++i;
    first = i + 1;
  }
  return found;
}

} // namespace gg::snippet
