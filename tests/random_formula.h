// Seeded random formulas in the part of the language that muparser itself knows.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace saddle::testing {

class RandomFormula {
 public:
  explicit RandomFormula(std::uint64_t seed) : engine_(seed) {}

  /// A formula of u and v, at most `depth` operations deep, spelled with random spaces.
  std::string operator()(int depth) {
    if (depth == 0 || pick(6) == 0) return leaf();
    switch (pick(8)) {
      case 0:
        return "(" + (*this)(depth - 1) + space() + "?" + space() + (*this)(depth - 1) + ":" +
               (*this)(depth - 1) + ")";
      case 1:
        return "-" + (pick(2) == 0 ? leaf() : "(" + (*this)(depth - 1) + ")");
      case 2:
      case 3:
        return call(depth);
      default:
        return binary(depth);
    }
  }

  /// A number of the range [-3, 3], the same for every standard library.
  double number() { return 6 * (static_cast<double>(engine_() >> 11U) / 9007199254740992.0) - 3; }

 private:
  std::size_t pick(std::size_t count) { return engine_() % count; }
  std::string space() { return pick(4) == 0 ? " " : ""; }

  std::string leaf() {
    static constexpr std::array<const char*, 10> kLeaves = {"u",   "v", "u",  "v",   "2",
                                                            "0.5", "3", "pi", "1.7", "e"};
    return kLeaves[pick(kLeaves.size())];
  }

  std::string binary(int depth) {
    static constexpr std::array<const char*, 18> kOperators = {"+",  "-",  "*",  "/",  "+",  "-",
                                                               "*",  "/",  "*",  "^",  "^",  "<",
                                                               ">=", "==", "!=", "<=", "&&", "||"};
    const std::string left = (*this)(depth - 1);
    const std::string op = kOperators[pick(kOperators.size())];
    const std::string right = (*this)(depth - 1);
    const std::string text = left + space() + op + space() + right;
    // Without brackets the grammar's precedence decides.
    return pick(2) == 0 && right[0] != '-' ? text : "(" + left + op + "(" + right + "))";
  }

  std::string call(int depth) {
    // Not asinh, acosh, atanh and log2: muparser builds them from ln, a few ULP off.
    static constexpr std::array<const char*, 17> kUnary = {
        "sin", "cos", "tan", "asin",  "acos", "atan", "sinh", "cosh", "tanh",
        "exp", "ln",  "log", "log10", "sqrt", "abs",  "sign", "rint"};
    static constexpr std::array<const char*, 5> kMany = {"min", "max", "sum", "avg", "atan2"};
    if (pick(4) != 0)
      return std::string(kUnary[pick(kUnary.size())]) + "(" + (*this)(depth - 1) + ")";
    const std::string name = kMany[pick(kMany.size())];
    std::string arguments = (*this)(depth - 1) + "," + space() + (*this)(depth - 1);
    if (name != "atan2" && pick(2) == 0) arguments += "," + (*this)(depth - 1);
    return name + "(" + arguments + ")";
  }

  std::mt19937_64 engine_;
};

}  // namespace saddle::testing
