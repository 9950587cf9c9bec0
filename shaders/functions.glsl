// Functions that formulas need and GLSL lacks, leaves undefined, or computes to a few digits only
// where drivers take it at its word (the specification asks 2^-11 of asin). Results are within some
// units in the last place; where a real function is undefined they are NaN. The sign of a zero is
// not kept.
// Polynomials: S. Moshier, "Cephes mathematical library", 1992, single precision.

#define NOT_A_NUMBER uintBitsToFloat(0x7fc00000u)
#define INFINITE uintBitsToFloat(0x7f800000u)

const float PI = 3.14159265;
const float LN_2 = 0.693147181;

float smaller(float a, float b) {
  return b < a || isnan(b) ? b : a;
}

float larger(float a, float b) {
  return a < b || isnan(b) ? b : a;
}

// Powers and roots.

float safe_sqrt(float a) {
  return a >= 0.0 ? sqrt(a) : NOT_A_NUMBER;
}

float safe_exp(float a) {
  return isnan(a) ? a : exp(a);
}

float safe_log2(float a) {
  if (a == INFINITE) return a;
  return a > 0.0 ? log2(a) : a == 0.0 ? -INFINITE : NOT_A_NUMBER;
}

float safe_log(float a) {
  return LN_2 * safe_log2(a);
}

// As C's pow has it: a negative base has powers of whole exponents, and x^0 = 1^x = 1 even of NaN.
float power(float a, float b) {
  if (b == 0.0 || a == 1.0) return 1.0;
  if (isnan(a) || isnan(b)) return NOT_A_NUMBER;
  float size = abs(a);
  if (size == 0.0) return b > 0.0 ? 0.0 : INFINITE;
  bool whole = b == floor(b);
  if (a < 0.0 && !whole && !isinf(a)) return NOT_A_NUMBER;
  float result = size == 1.0 ? 1.0 : exp2(b * safe_log2(size));
  bool odd = whole && abs(b - 2.0 * floor(0.5 * b)) == 1.0;
  return a < 0.0 && odd ? -result : result;
}

// One step of Newton's method makes up for exp2 and log2.
float cbrt(float a) {
  float size = abs(a);
  if (size == 0.0 || !(size < INFINITE)) return a;
  float root = exp2(log2(size) * 0.333333333);
  root -= (root - size / (root * root)) * 0.333333333;
  return a < 0.0 ? -root : root;
}

float hypot(float a, float b) {
  float large = max(abs(a), abs(b));
  float small = min(abs(a), abs(b));
  if (isinf(a) || isinf(b)) return INFINITE;
  if (isnan(a) || isnan(b)) return NOT_A_NUMBER;
  if (large == 0.0) return 0.0;
  float ratio = small / large;
  return large * sqrt(1.0 + ratio * ratio);
}

// Inverse trigonometry.

float safe_atan(float a) {
  float x = abs(a);
  float offset = 0.0;
  if (x > 2.41421356) {  // tan(3 pi/8)
    offset = 0.5 * PI;
    x = -1.0 / x;
  } else if (x > 0.414213562) {  // tan(pi/8)
    offset = 0.25 * PI;
    x = (x - 1.0) / (x + 1.0);
  }
  float z = x * x;
  float p = ((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z;
  float result = offset + ((p - 3.33329491539e-1) * z * x + x);
  return a < 0.0 ? -result : result;
}

float safe_atan2(float a, float b) {
  if (isnan(a) || isnan(b)) return NOT_A_NUMBER;
  float angle;  // of the point in the first quadrant
  if (a == 0.0) {
    angle = 0.0;
  } else if (isinf(a)) {
    angle = isinf(b) ? 0.25 * PI : 0.5 * PI;
  } else {
    angle = safe_atan(abs(a / b));
  }
  if (b < 0.0) angle = PI - angle;
  return a < 0.0 ? -angle : angle;
}

// For 0 <= x <= 1/2.
float asin_near_zero(float x) {
  float z = x * x;
  float p = ((4.2163199048e-2 * z + 2.4181311049e-2) * z + 4.5470025998e-2) * z;
  return ((p + 7.4953002686e-2) * z + 1.6666752422e-1) * z * x + x;
}

float safe_asin(float a) {
  float x = abs(a);
  if (!(x <= 1.0)) return NOT_A_NUMBER;
  float result =
      x > 0.5 ? 0.5 * PI - 2.0 * asin_near_zero(sqrt(0.5 - 0.5 * x)) : asin_near_zero(x);
  return a < 0.0 ? -result : result;
}

float safe_acos(float a) {
  float x = abs(a);
  if (!(x <= 1.0)) return NOT_A_NUMBER;
  if (x <= 0.5) return 0.5 * PI - safe_asin(a);
  float result = 2.0 * asin_near_zero(sqrt(0.5 - 0.5 * x));
  return a < 0.0 ? PI - result : result;
}

// Hyperbolic functions: polynomials where the exponentials would cancel.

float safe_sinh(float a) {
  if (abs(a) > 1.0) return 0.5 * (exp(a) - exp(-a));
  float z = a * a;
  return ((2.03721912945e-4 * z + 8.33028376239e-3) * z + 1.66667160211e-1) * z * a + a;
}

float safe_cosh(float a) {
  return isnan(a) ? a : 0.5 * (exp(a) + exp(-a));
}

float safe_tanh(float a) {
  float x = abs(a);
  if (x >= 0.625) {
    float result = 1.0 - 2.0 / (exp(2.0 * x) + 1.0);
    return a < 0.0 ? -result : result;
  }
  float z = a * a;
  float p = ((-5.70498872745e-3 * z + 2.06390887954e-2) * z - 5.37397155531e-2) * z;
  return ((p + 1.33314422036e-1) * z - 3.33332819422e-1) * z * a + a;
}

float safe_asinh(float a) {
  float x = abs(a);
  if (x > 0.5) {
    float result = x > 1500.0 ? safe_log(x) + LN_2 : safe_log(x + sqrt(x * x + 1.0));
    return a < 0.0 ? -result : result;
  }
  float z = a * a;
  float p = ((2.0122003309e-2 * z - 4.2699340972e-2) * z + 7.4847586088e-2) * z;
  return (p - 1.6666288134e-1) * z * a + a;
}

float safe_acosh(float a) {
  if (!(a >= 1.0)) return NOT_A_NUMBER;
  if (a > 1500.0) return safe_log(a) + LN_2;
  float z = a - 1.0;
  if (z > 0.5) return safe_log(a + sqrt(z * (a + 1.0)));
  float p = ((1.7596881071e-3 * z - 7.5272886713e-3) * z + 2.6454905019e-2) * z;
  return ((p - 1.1784741703e-1) * z + 1.4142135263) * sqrt(z);
}

float safe_atanh(float a) {
  float x = abs(a);
  if (!(x <= 1.0)) return NOT_A_NUMBER;
  if (x > 0.5) {
    float result = 0.5 * safe_log((1.0 + x) / (1.0 - x));
    return a < 0.0 ? -result : result;
  }
  float z = a * a;
  float p = ((1.81740078349e-1 * z + 8.24370301058e-2) * z + 1.46691431730e-1) * z;
  return ((p + 1.99782164500e-1) * z + 3.33337300303e-1) * z * a + a;
}

// Special functions.

// The Taylor series up to 1; beyond, 1 - erfc by W. Press et al., "Numerical recipes", 1992, 6.2.
float erf(float a) {
  float x = abs(a);
  if (x < 1.0) {
    float z = a * a;
    float p = (-1.0 / 6894720.0 * z + 1.0 / 685440.0) * z - 1.0 / 75600.0;
    p = ((p * z + 1.0 / 9360.0) * z - 1.0 / 1320.0) * z + 1.0 / 216.0;
    p = ((p * z - 1.0 / 42.0) * z + 0.1) * z - 1.0 / 3.0;
    return 1.12837917 * (p * z * a + a);
  }
  float t = 1.0 / (1.0 + 0.5 * x);
  float p = ((0.17087277 * t - 0.82215223) * t + 1.48851587) * t - 1.13520398;
  p = ((p * t + 0.27886807) * t - 0.18628806) * t + 0.09678418;
  p = ((p * t + 0.37409196) * t + 1.00002368) * t - 1.26551223;
  float result = 1.0 - t * exp(p - x * x);
  return a < 0.0 ? -result : result;
}

// ln gamma(a) for a >= 1/2, by Lanczos' series: W. Press et al., "Numerical recipes", 1992, 6.1.
float log_gamma_right(float a) {
  float sum = 1.0 + 76.1800917 / a - 86.5053203 / (a + 1.0) + 24.0140982 / (a + 2.0);
  sum += -1.23173957 / (a + 3.0) + 1.20865097e-3 / (a + 4.0) - 5.39523938e-6 / (a + 5.0);
  float shifted = a + 4.5;
  return (a - 0.5) * log(shifted) - shifted + log(2.50662827 * sum);
}

// sin(pi a), to full accuracy near its zeros.
float sin_pi(float a) {
  float whole = floor(a + 0.5);
  float result = sin(PI * (a - whole));
  return abs(whole - 2.0 * floor(0.5 * whole)) == 1.0 ? -result : result;
}

float gamma(float a) {
  if (a == 0.0 || a == INFINITE) return INFINITE;
  if (a < 0.0 && a == floor(a)) return NOT_A_NUMBER;
  if (a < 0.5) return PI / (sin_pi(a) * exp(log_gamma_right(1.0 - a)));
  return exp(log_gamma_right(a));
}

float log_gamma(float a) {
  if (isinf(a) || (a <= 0.0 && a == floor(a))) return INFINITE;
  if (a < 0.5) return log(PI / abs(sin_pi(a))) - log_gamma_right(1.0 - a);
  return log_gamma_right(a);
}
