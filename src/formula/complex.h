// Complex numbers as pairs of real expressions: the functions that the numbers column of ops.def
// calls COMPLEX, with the principal branches of C99, annex G. A branch cut belongs to the side that
// the sign of a zero part says.
//
// A part that is the constant 0 takes no part in products: i*v is (0, v), wherever v is infinite,
// as C99's imaginary type has it.
#pragma once

#include "formula/expression.h"

namespace saddle {

struct Complex {
  Expression re;
  Expression im;
};

Complex operator-(const Complex& a);
Complex operator+(const Complex& a, const Complex& b);
Complex operator-(const Complex& a, const Complex& b);
Complex operator*(const Complex& a, const Complex& b);
Complex operator/(const Complex& a, const Complex& b);
Complex operator/(double a, const Complex& b);

Complex conj(const Complex& a);
Expression arg(const Complex& a);  ///< -pi to pi
Expression abs(const Complex& a);

/// a^b. A whole constant exponent of up to 16 makes products, with u^3-3*u*v^2 for re((u+i*v)^3) as
/// one would write it; another real one the polar form; else it is exp(b*ln(a)).
Complex pow(const Complex& a, const Complex& b);
Complex sqrt(const Complex& a);
Complex exp(const Complex& a);
Complex log(const Complex& a);

Complex sin(const Complex& a);
Complex cos(const Complex& a);
Complex tan(const Complex& a);
Complex sinh(const Complex& a);
Complex cosh(const Complex& a);
Complex tanh(const Complex& a);

/// Source of asin, acos, acosh: W. Kahan, "Branch cuts for complex elementary functions", 1987.
Complex asin(const Complex& a);
Complex acos(const Complex& a);
Complex atan(const Complex& a);
Complex asinh(const Complex& a);
Complex acosh(const Complex& a);
Complex atanh(const Complex& a);

}  // namespace saddle
