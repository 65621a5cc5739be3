#include "glsl/cpp_text.h"

#include <cctype>

namespace gg::glsl {
namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c));
}

class Translator {
public:
  Translator(const std::string& text, Literals literals) : text_(text), literals_(literals) {}

  std::string run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (starts("//") || (c == '#' && line_is_blank_))
        copy_until("\n", 0);
      else if (starts("/*"))
        copy_until("*/", 2);
      else if (is_digit(c))
        number();
      else if (is_word(c))
        word();
      else
        punctuation(c);
    }
    return std::move(out_);
  }

private:
  bool starts(const char* token) const { return text_.compare(at_, 2, token) == 0; }

  void copy_until(const char* end, std::size_t keep) {
    std::size_t stop = text_.find(end, at_);
    stop = stop == std::string::npos ? text_.size() : stop + keep;
    out_.append(text_, at_, stop - at_);
    at_ = stop;
  }

  void number() {
    const std::size_t start = at_;
    bool floating = false;
    while (at_ < text_.size() && (is_word(text_[at_]) || text_[at_] == '.')) {
      const char c = text_[at_++];
      const bool exponent = c == 'e' || c == 'E';
      floating = floating || c == '.' || exponent;
      if (exponent && at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) ++at_;
    }
    const std::string digits = text_.substr(start, at_ - start);
    if (floating && literals_ == Literals::suffixed)
      out_ += digits + "f";
    else if (floating && literals_ == Literals::wrapped)
      out_ += "Real(" + digits + ")";
    else
      out_ += digits;
    line_is_blank_ = false;
  }

  void word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_word(text_[at_]))
      ++at_;
    const std::string name = text_.substr(start, at_ - start);
    // At the outermost level a declaration is a struct, a constant or a function.
    if (declaration_starts_ && name != "struct" && name != "const" && has_body()) out_ += "inline ";
    declaration_starts_ = false;
    line_is_blank_ = false;
    out_ += name == "float" ? "Real" : name;
  }

  // A function that is only declared is somebody else's to define.
  bool has_body() const { return text_.find('{', at_) < text_.find(';', at_); }

  void punctuation(char c) {
    if (c == '{' || c == '(') ++depth_;
    if (c == '}' || c == ')') --depth_;
    if (depth_ == 0 && (c == ';' || c == '}')) declaration_starts_ = true;
    if (c == '\n')
      line_is_blank_ = true;
    else if (c != ' ' && c != '\t')
      line_is_blank_ = false;
    out_ += c;
    ++at_;
  }

  const std::string& text_;
  Literals literals_;
  std::string out_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool declaration_starts_ = true;
  bool line_is_blank_ = true;
};

} // namespace

std::string cpp_text(const std::string& flattened, Literals literals) {
  return Translator(flattened, literals).run();
}

} // namespace gg::glsl
