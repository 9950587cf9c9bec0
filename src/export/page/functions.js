// Functions that formulas need and Math lacks, in double precision. A page has those that its
// formulas call. Each returns what C++ returns: NaN where it is undefined.

// As C's pow has it: 1 to any power is 1, and -1 to an infinite one.
function power(a, b) {
  return a == 1 || (a == -1 && Math.abs(b) == 1 / 0) ? 1 : Math.pow(a, b);
}

// The value at z of the polynomial with these coefficients, the constant one first.
function polynomial(coefficients, z) {
  return coefficients.reduceRight((sum, c) => sum * z + c);
}

// e^(-x^2): the square in two parts, as its rounding would be a factor of the result.
function gauss(x) {
  const head = Math.fround(x);
  return Math.exp(-head * head) * Math.exp((head - x) * (head + x));
}

// Near 0 a series of positive terms, farther out the continued fraction of 1 - erf(x).
// Source: M. Abramowitz, I. Stegun, "Handbook of mathematical functions", 1964, 7.1.6, 7.1.14.
function erf(x) {
  const a = Math.abs(x);
  if (!(a < 6)) return Math.sign(x);
  if (a < 2) {
    const terms = [x];
    for (let k = 1; k < 60; ++k) terms.push(terms[k - 1] * 2 * x * x / (2 * k + 1));
    return 1.1283791670955126 * terms.reduceRight((sum, term) => sum + term) * gauss(x);
  }
  let f = a;
  for (let k = 60; k > 0; --k) f = a + k / 2 / f;
  return Math.sign(x) * (1 - 0.5641895835477563 * gauss(a) / f);
}

// From 1 to 2 a polynomial; elsewhere that times the factors between. Their product carries its
// rounding errors with it, by T. Dekker, "A floating-point technique", 1971.
function gamma(x) {
  if (Math.abs(x) < 1e-17) return 1 / x;
  if (x < 0 && x == Math.floor(x)) return NaN;
  if (x > 172) return 1 / 0;
  if (x < -190) return 0;
  const steps = Math.floor(x) - 1;
  let p = 2 ** -60;
  let error = 0;
  const times = f => {
    const split = y => { const c = 134217729 * y; return c - (c - y); };
    const q = p * f;
    const p1 = split(p), p2 = p - p1, f1 = split(f), f2 = f - f1;
    error = error * f + (p1 * f1 - q + p1 * f2 + p2 * f1 + p2 * f2);
    p = q;
  };
  for (let k = 1; k <= steps; ++k) times(x - k);
  for (let k = 0; k < -steps; ++k) times(x + k);
  const near = polynomial([0.886226925452758, 0.032338397448885, 0.4148134536882826, -0.10729480456475984, 0.1446453590475836, -0.07752305230182892, 0.058610303633145476, -0.03800193543217766, 0.02583761230507782, -0.017222447013020576, 0.011522407277990318, -0.007690139287816347, 0.005132883760616497, -0.003423629338262631, 0.002273514062024839, -0.0015159595901781905, 0.0010569633457018935, -0.0007046879722466143, 0.0003320885800907498, -0.00022139952612051456, 0.00037955491879486174, -0.00025303807808043895],
                          x - steps - 1.5);
  return steps < 0 ? near / (p + error) * 2 ** -60 : near * (p + error) * 2 ** 60;
}

// ln |gamma(x)|: near its zeros a polynomial without them, far out Stirling's series.
function logGamma(x) {
  if (Math.abs(x) == 1 / 0 || (x <= 0 && x == Math.floor(x))) return 1 / 0;
  if (x < 0.5 && x > -0.5) return logGamma(x + 1) - Math.log(Math.abs(x));
  if (x < 0) {
    const rest = x - Math.round(x);
    return Math.log(Math.PI / Math.abs(x * Math.sin(Math.PI * rest))) - logGamma(-x);
  }
  let product = 1;
  for (; x > 2.5 && x < 12; --x) product *= x - 1;
  for (; x < 0.75; ++x) product /= x;
  if (x <= 2.5) {
    const near = polynomial([0.46913235706981576, -0.13425408899797125, 0.054439969616381464, -0.025433536502757415, 0.01280096293932072, -0.006737661429432325, 0.003651754671788264, -0.002020110437287569, 0.0011343928061739296, -0.0006443597339943636, 0.0003693377874571029, -0.00021326058671713725, 0.0001238948379989252, -7.234946230471988e-05, 4.2427869552069386e-05, -2.4982708527527717e-05, 1.4806811421059179e-05, -8.775765840582945e-06, 5.047965314755452e-06, -3.0047735988839934e-06, 2.2450438954597316e-06, -1.3479313671783392e-06, -1.0338076040295575e-07, 6.991802331714747e-08, 1.3271983563168612e-06, -8.08314266375406e-07, -1.0206978176951303e-06, 6.237369468683548e-07, 8.048944768713818e-07, -4.911742269114369e-07, -3.2629311845446285e-07, 1.9919941462702144e-07, 7.782891955448632e-08, -4.7475311249498885e-08],
                            x - 1.6);
    return Math.log(product) + (x - 1) * (x - 2) * near;
  }
  const s = 1 / (x * x);
  const series = ((((-691 / 360360 * s + 1 / 1188) * s - 1 / 1680) * s + 1 / 1260) * s - 1 / 360) * s + 1 / 12;
  return (x - 0.5) * (Math.log(x) - 1) + (0.4189385332046727 + series / x);
}

// The derivative of order n + 1 of ln gamma(x). In the middle between poles it is mirrored; far to
// the left the poles repeat those about 0. The sum carries its rounding errors with it, by A.
// Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen", 1974.
function polygamma(n, x) {
  if (x != x || (x <= 0 && x == Math.floor(x))) return NaN;
  if (x == 1 / 0) return n > 0 ? 0 : x;
  let sum = 0, error = 0;
  const add = y => {
    const all = sum + y;
    error += Math.abs(sum) < Math.abs(y) ? y - all + sum : sum - all + y;
    sum = all;
  };
  const sign = n % 2 ? -1 : 1, near = x - Math.round(x);
  const isMirrored = x < 0 && Math.abs(near) > 0.4;
  if (isMirrored) {
    addPolygamma(n, 1 - x, -1, add);
  } else if (x < -20) {
    addPolygamma(n, 1 - x, -1, add);
    addPolygamma(n, 1 - near, 1, add);
    addPolygamma(n, near, -sign, add);
  } else {
    addPolygamma(n, x, -sign, add);
  }
  let factorial = 1;
  for (let k = 2; k <= n; ++k) factorial *= k;
  const value = factorial * (sum + (error || 0));  // not a number where the sum is infinite
  return isMirrored ? value - cotangentDerivative(n, near) : value;
}

// Adds the terms of sum 1/(x + k)^(n+1) for k = 0, 1 ..., which is polygamma but for a sign and n!;
// for n = 0 without its infinite constant: one by one up to where the series for the rest is good.
// Source: M. Abramowitz, I. Stegun, "Handbook of mathematical functions", 1964, 6.4.
function addPolygamma(n, x, factor, add) {
  let far = x, off = 0;  // the place is off larger than its double
  for (let steps = 1; far < 20 + n; ++steps) {
    const term = factor * Math.pow(far, -n - 1);
    add(term);
    if (off) add(-(n + 1) * term * off / far);
    far = x + steps;
    off = x - (far - steps);
  }
  if (n) {
    add(factor * Math.pow(far, -n) / n);
  } else {  // the logarithm, as those of a power of 2 in two parts and of the rest
    const power = Math.min(Math.floor(Math.log2(far)), 1023);
    add(-factor * power * 0.6931471803691238);
    add(-factor * power * 1.9082149292705877e-10);
    add(-factor * Math.log(far / 2 ** power));
  }
  add(factor * (0.5 - off) * Math.pow(far, -n - 1));
  [1 / 6, -1 / 30, 1 / 42, -1 / 30, 5 / 66, -691 / 2730, 7 / 6, -3617 / 510, 43867 / 798, -174611 / 330].forEach((bernoulli, i) => {
    const k = 2 * i + 2;
    let ratio = 1 / k;  // (k + n - 1)! / (k! n!)
    for (let j = 1; j <= n; ++j) ratio *= (k + j - 1) / j;
    add(factor * bernoulli * ratio * Math.pow(far, -n - k));
  });
}

// The n-th derivative of pi cot(pi x) near 1/2 and -1/2: pi^(n+1) P_n(cot), P_0 = c,
// P_(n+1) = -(1 + c^2) P_n'.
function cotangentDerivative(n, x) {
  let p = [0, 1];
  for (let k = 0; k < n; ++k) {
    const next = Array(p.length + 1).fill(0);
    for (let i = 1; i < p.length; ++i) {
      next[i - 1] -= i * p[i];
      next[i + 1] -= i * p[i];
    }
    p = next;
  }
  const c = Math.sign(x) * Math.tan(Math.PI * (0.5 - Math.abs(x)));
  const value = Math.pow(Math.PI, n + 1) * polynomial(p, c);
  return value + value * (n + 1) * 3.9e-17;  // the rest of pi
}

// J_n(x) for whole n: by recurrence from a high order down, or far out by its waves.
// Source: M. Abramowitz, I. Stegun, "Handbook of mathematical functions", 1964, 9.12, 9.2.5.
function besselJ(n, x) {
  const a = Math.abs(x);
  const sign = (n < 0) != (x < 0) && n % 2 ? -1 : 1;
  n = Math.abs(n);
  if (a == 1 / 0) return 0;
  if (!(a > 1e-9)) {  // the first term of the series
    let term = sign;
    for (let k = 1; k <= n; ++k) term *= a / 2 / k;
    return a == a ? term : a;
  }
  if (a > 22 + n * n / 2) {
    let term = 1, p = 1, q = 0;
    for (let k = 1; Math.abs(term) > 1e-17; ++k) {
      term *= (4 * n * n - (2 * k - 1) ** 2) / (8 * k * a);
      const part = k % 4 > 1 ? -term : term;
      k % 2 ? q += part : p += part;
    }
    const s = Math.sin(a), c = Math.cos(a);
    const quarter = [c + s, s - c, -c - s, c - s];  // cosines of a - (2 n + 1) pi/4, times sqrt(2)
    return sign * (p * quarter[n % 4] - q * quarter[(n + 1) % 4]) / Math.sqrt(Math.PI) / Math.sqrt(a);
  }
  const top = 2 * Math.ceil((Math.max(n, a) + 20 + 8 * Math.sqrt(Math.max(n, a))) / 2);
  let high = 0, low = 1e-300, sum = 0, value = 0;
  for (let k = top; k > 0; --k) {
    if (k == n) value = low;
    if (k % 2 == 0) sum += 2 * low;
    [high, low] = [low, 2 * k / a * low - high];
    if (Math.abs(low) > 1e200) {
      [high, low, sum, value] = [high, low, sum, value].map(y => y * 1e-200);
    }
  }
  return sign * (n ? value : low) / (sum + low);
}

// The derivative of order n of sin(x)/x: its series near 0, the recurrence of sines farther out.
function sincDerivative(n, x) {
  if (Math.abs(x) == 1 / 0) return 0;
  if (Math.abs(x) <= Math.max(1, n / 2)) {
    let sum = 0;
    let monomial = n % 2 ? x : 1;
    for (let m = n % 2;; m += 2) {
      const term = monomial / (m + n + 1);
      sum += (m + n) / 2 % 2 ? -term : term;
      if (term == 0 || (m > Math.abs(x) && Math.abs(term) <= 2 ** -60 * Math.abs(sum))) return sum;
      monomial *= x * x / ((m + 1) * (m + 2));
    }
  }
  const sines = [Math.sin(x), Math.cos(x), -Math.sin(x), -Math.cos(x)];
  let value = sines[0] / x;
  for (let k = 1; k <= n; ++k) value = (sines[k % 4] - k * value) / x;
  return value;
}
