#include "export/page/page_text.h"

#include <sstream>
#include <vector>

namespace saddle {
namespace {

bool separates_itself(char c) {
  return std::string_view(",;:{}()[]=<>!?&|*/%~^").find(c) != std::string_view::npos;
}

bool is_sign(char c) {
  return c == '+' || c == '-';
}

class Squeezer {
 public:
  explicit Squeezer(std::string_view text) : text_(text) {}

  std::string all() {
    for (; at_ < text_.size(); ++at_) take(text_[at_]);
    return std::move(result_);
  }

 private:
  char last() const { return result_.empty() ? '\n' : result_.back(); }
  char next() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : '\n'; }

  void take(char c) {
    const bool is_template = !quotes_.empty() && quotes_.back() == '`';
    if (c == '#' && last() == '\n') {
      for (; text_[at_] != '\n'; ++at_) result_ += text_[at_];
      result_ += '\n';
    } else if (!quotes_.empty() && quotes_.back() != '{') {
      take_quoted(c, is_template);
    } else if (c == ' ') {
      if (is_needed()) result_ += c;
    } else if (c == '\n') {
      const bool is_open = std::string_view(";{,(").find(last()) != std::string_view::npos;
      if (!is_open || next() == '#') result_ += c;
    } else {
      if (c == '\'' || c == '"' || c == '`') quotes_.push_back(c);
      if (c == '{' && !quotes_.empty()) quotes_.push_back('{');
      if (c == '}' && !quotes_.empty()) quotes_.pop_back();
      result_ += c;
    }
  }

  /// Code in braces inside of a template may have quotes of its own.
  void take_quoted(char c, bool is_template) {
    result_ += c;
    if (c == '\\') {
      result_ += text_[++at_];
    } else if (c == quotes_.back()) {
      quotes_.pop_back();
    } else if (is_template && c == '$' && next() == '{') {
      result_ += text_[++at_];
      quotes_.push_back('{');
    }
  }

  /// A space here: between words, and between signs that would be one.
  bool is_needed() const {
    const char before = last();
    const char after = next();
    if (separates_itself(before) || separates_itself(after) || before == '\n') return false;
    return is_sign(before) == is_sign(after);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string result_;
  std::vector<char> quotes_;  ///< that are open, and braces inside of them
};

}  // namespace

std::string without_comments(std::string_view text) {
  std::string result;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos) continue;
    line = line.substr(first, line.find("  //", first) - first);
    if (!line.starts_with("//") && !line.starts_with("/*")) result += line + "\n";
  }
  return result;
}

std::string squeezed(std::string_view text) {
  return Squeezer(text).all();
}

}  // namespace saddle
