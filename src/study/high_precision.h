// Values of graphs with 50 digits, from Boost's functions: independent of the table's own values.
// Boost's headers are slow; only what computes with such numbers includes this.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <span>
#include <vector>

#include "formula/graph.h"

namespace saddle {

using Real = boost::multiprecision::cpp_bin_float_50;

/// An operation's value; arguments past its arity are ignored. NaN, or an exception of Boost's, for
/// arguments outside of its domain.
Real apply_exactly(Op op, const Real& a, const Real& b, const Real& c);

/// The n-th derivative of sin(x)/x.
Real sinc_series(int n, const Real& x);

/// The n-th derivative of digamma.
Real exact_polygamma(int n, const Real& x);

/// The values of all nodes that the roots need, by node, from the variables' values; where Boost
/// finds an argument outside of a domain, everything is NaN.
std::vector<Real> exact_values(const Graph& graph, std::span<const NodeId> roots,
                               const std::function<Real(Symbol)>& variable);

/// The value of `root` at (u, v), t = 0.
Real exact_value(const Graph& graph, NodeId root, const Real& u, const Real& v);

}  // namespace saddle
