// Mutants: small changes of the sources, all compiled in, of which SADDLE_MUTANT switches on one.
// mutate.py puts calls of these templates where the operators, constants, conditions and statements
// stand. A compiler that computes one ahead takes it as it was written.
#pragma once

#pragma GCC diagnostic ignored "-Wparentheses"  // a == at<Equal, 7> == b

#include <type_traits>
#include <utility>

namespace mutants {

extern int active;              // the number of the mutant that is on, or -1
extern unsigned char* reached;  // a byte for each mutant, or null: nothing is recorded

inline constexpr unsigned char kReached = 1;
inline constexpr unsigned char kImpossible = 2;  ///< types lack the operator that it would have

#define MUTANTS_INLINE [[gnu::always_inline]] constexpr

MUTANTS_INLINE bool is_on(int number) {
  if (std::is_constant_evaluated()) return false;
  if (reached != nullptr) [[unlikely]]
    reached[number] |= kReached;
  return number == active;
}

MUTANTS_INLINE void say_impossible(int number) {
  if (!std::is_constant_evaluated() && reached != nullptr) reached[number] |= kImpossible;
}

/// The original operator, and what it may become: up to two mutants with numbers that follow.
#define MUTANTS_OPERATOR(Name, written, first, second)                           \
  struct Name {                                                                  \
    template <class L, class R>                                                  \
    MUTANTS_INLINE static auto original(L&& l, R&& r) -> decltype(l written r) { \
      return static_cast<L&&>(l) written static_cast<R&&>(r);                    \
    }                                                                            \
    template <class L, class R>                                                  \
    MUTANTS_INLINE static auto mutant(L&& l, R&& r) -> decltype(l first r) {     \
      return l first r;                                                          \
    }                                                                            \
    template <class L, class R>                                                  \
    MUTANTS_INLINE static auto other(L&& l, R&& r) -> decltype(l second r) {     \
      return l second r;                                                         \
    }                                                                            \
  };
MUTANTS_OPERATOR(Less, <, <=, >=)
MUTANTS_OPERATOR(LessEqual, <=, <, >)
MUTANTS_OPERATOR(Greater, >, >=, <=)
MUTANTS_OPERATOR(GreaterEqual, >=, >, <)
MUTANTS_OPERATOR(Equal, ==, !=, !=)
MUTANTS_OPERATOR(Unequal, !=, ==, ==)
MUTANTS_OPERATOR(Plus, +, -, -)
MUTANTS_OPERATOR(Minus, -, +, +)
MUTANTS_OPERATOR(Times, *, /, /)
MUTANTS_OPERATOR(Over, /, *, *)

/// A mark between two operators of the same precedence: `a < b` is written `a < at<Less, 7> < b`,
/// which the compiler groups as the one operator.
template <class Operator, int number, int count>
struct Mark {};
template <class Operator, int number, int count = 1>
inline constexpr Mark<Operator, number, count> at;

template <class L, class Operator, int number, int count>
struct Left {
  L&& left;

  template <class R>
  MUTANTS_INLINE auto with(R&& right) const
      -> std::decay_t<decltype(Operator::original(std::declval<L>(), std::declval<R>()))> {
    using Result =
        std::decay_t<decltype(Operator::original(static_cast<L&&>(left), static_cast<R&&>(right)))>;
    if constexpr (requires { static_cast<Result>(Operator::mutant(left, right)); }) {
      if (is_on(number)) return static_cast<Result>(Operator::mutant(left, right));
    } else {
      say_impossible(number);
    }
    if constexpr (count == 2) {
      if constexpr (requires { static_cast<Result>(Operator::other(left, right)); }) {
        if (is_on(number + 1)) return static_cast<Result>(Operator::other(left, right));
      } else {
        say_impossible(number + 1);
      }
    }
    return Operator::original(static_cast<L&&>(left), static_cast<R&&>(right));
  }
};

#define MUTANTS_MARK(op)                                                                       \
  template <class L, class Operator, int number, int count>                                    \
  MUTANTS_INLINE Left<L, Operator, number, count> operator op(L&& l,                           \
                                                              Mark<Operator, number, count>) { \
    return {static_cast<L&&>(l)};                                                              \
  }                                                                                            \
  template <class L, class Operator, int number, int count, class R>                           \
  MUTANTS_INLINE auto operator op(const Left<L, Operator, number, count>& l, R&& r)            \
      ->decltype(l.with(static_cast<R&&>(r))) {                                                \
    return l.with(static_cast<R&&>(r));                                                        \
  }
MUTANTS_MARK(<)
MUTANTS_MARK(==)
MUTANTS_MARK(+)
MUTANTS_MARK(*)

/// A whole number k becomes k + 1 or 0; another one 2 k or 0; of 0, only 1.
template <int number, class T>
MUTANTS_INLINE T constant(T value) {
  if constexpr (std::is_integral_v<T> || std::is_floating_point_v<T>) {
    if (is_on(number)) {
      return std::is_integral_v<T> || value == 0 ? static_cast<T>(value + 1) : 2 * value;
    }
    if (value != 0 && is_on(number + 1)) return T(0);
  }
  return value;
}

template <int number, class T>
MUTANTS_INLINE bool condition(T&& value) {
  const bool holds = static_cast<bool>(static_cast<T&&>(value));
  return is_on(number) ? !holds : holds;
}

/// Whether a statement is executed.
template <int number>
MUTANTS_INLINE bool statement() {
  return !is_on(number);
}

}  // namespace mutants
