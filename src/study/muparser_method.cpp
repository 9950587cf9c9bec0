#include "study/muparser_method.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/format.h"

namespace saddle {
namespace {

/// Past this many bytes muparser refuses, whose limit is 20000.
constexpr double kLongest = 19000;

template <Op op>
double call_one(double a) {
  return apply(op, a);
}
template <Op op>
double call_two(double a, double b) {
  return apply(op, a, b);
}

/// How a formula of muparser spells an operation: an operator, a function that muparser has, or one
/// of ours that is handed to it.
struct Spelling {
  const char* name = nullptr;
  bool infix = false;
  double (*one)(double) = nullptr;
  double (*two)(double, double) = nullptr;
};

Spelling spelling(Op op) {
  switch (op) {
    // clang-format off
    case Op::Add: return {"+", true};
    case Op::Sub: return {"-", true};
    case Op::Mul: return {"*", true};
    case Op::Div: return {"/", true};
    case Op::Pow: return {"^", true};
    case Op::Less: return {"<", true};
    case Op::LessEqual: return {"<=", true};
    case Op::Greater: return {">", true};
    case Op::GreaterEqual: return {">=", true};
    case Op::Equal: return {"==", true};
    case Op::NotEqual: return {"!=", true};
    case Op::And: return {"&&", true};
    case Op::Or: return {"||", true};
    case Op::Neg: return {"-"};
    case Op::Sqrt: return {"sqrt"};
    case Op::Exp: return {"exp"};
    case Op::Log: return {"ln"};
    case Op::Log2: return {"log2"};
    case Op::Log10: return {"log10"};
    case Op::Sin: return {"sin"};
    case Op::Cos: return {"cos"};
    case Op::Tan: return {"tan"};
    case Op::Asin: return {"asin"};
    case Op::Acos: return {"acos"};
    case Op::Atan: return {"atan"};
    case Op::Atan2: return {"atan2"};
    case Op::Sinh: return {"sinh"};
    case Op::Cosh: return {"cosh"};
    case Op::Tanh: return {"tanh"};
    case Op::Asinh: return {"asinh"};
    case Op::Acosh: return {"acosh"};
    case Op::Atanh: return {"atanh"};
    case Op::Abs: return {"abs"};
    case Op::Min: return {"min"};
    case Op::Max: return {"max"};
    case Op::Sign: return {"our_sign", false, call_one<Op::Sign>};
    case Op::Cbrt: return {"our_cbrt", false, call_one<Op::Cbrt>};
    case Op::Floor: return {"our_floor", false, call_one<Op::Floor>};
    case Op::Ceil: return {"our_ceil", false, call_one<Op::Ceil>};
    case Op::Round: return {"our_round", false, call_one<Op::Round>};
    case Op::Rint: return {"our_rint", false, call_one<Op::Rint>};
    case Op::Trunc: return {"our_trunc", false, call_one<Op::Trunc>};
    case Op::Erf: return {"our_erf", false, call_one<Op::Erf>};
    case Op::Gamma: return {"our_gamma", false, call_one<Op::Gamma>};
    case Op::Lgamma: return {"our_lgamma", false, call_one<Op::Lgamma>};
    case Op::Hypot: return {"our_hypot", false, nullptr, call_two<Op::Hypot>};
    case Op::Mod: return {"our_mod", false, nullptr, call_two<Op::Mod>};
    case Op::Polygamma: return {"our_polygamma", false, nullptr, call_two<Op::Polygamma>};
    case Op::BesselJ: return {"our_besselj", false, nullptr, call_two<Op::BesselJ>};
    case Op::SincN: return {"our_sinc", false, nullptr, call_two<Op::SincN>};
    case Op::Select: case Op::Constant: case Op::Variable: break;
      // clang-format on
  }
  return {};
}

std::string leaf(const Node& node) {
  if (node.op == Op::Variable) return node.symbol == kSymbolU ? "u" : "v";
  if (std::isnan(node.value)) return "our_nan";
  if (std::isinf(node.value)) return node.value > 0 ? "our_inf" : "(-our_inf)";
  const std::string text = formatted("%.17g", node.value);
  return node.value < 0 ? "(" + text + ")" : text;
}

std::string call(const Node& node, const std::vector<std::string>& of) {
  const auto [a, b, c] = node.args;
  if (node.op == Op::Select) return "(" + of[a] + "?" + of[b] + ":" + of[c] + ")";
  const Spelling s = spelling(node.op);
  if (s.infix) return "(" + of[a] + s.name + of[b] + ")";
  if (node.op == Op::Neg) return "(-" + of[a] + ")";
  return std::string(s.name) + "(" + of[a] + (arity(node.op) > 1 ? "," + of[b] : "") + ")";
}

/// About how long the text of each node is, without making it.
std::vector<double> text_lengths(const Graph& graph, const std::vector<bool>& needed) {
  constexpr double kLeaf = 26;  // the longest number, in brackets
  constexpr double kCall = 15;
  std::vector<double> lengths(needed.size(), kLeaf);
  for (NodeId id = 0; id < needed.size(); ++id) {
    const Node& node = graph[id];
    if (arity(node.op) > 0) lengths[id] = kCall;
    for (int k = 0; k < arity(node.op); ++k) {
      lengths[id] += lengths[node.args[static_cast<std::size_t>(k)]];
    }
  }
  return lengths;
}

/// The formulas as muparser reads them; nothing if one would be too long.
std::optional<std::array<std::string, 3>> formulas(const Graph& graph,
                                                   const std::array<NodeId, 3>& r) {
  const std::vector<bool> needed = reachable(graph, r);
  const std::vector<double> lengths = text_lengths(graph, needed);
  if (std::ranges::any_of(r, [&](NodeId root) { return lengths[root] > kLongest; })) return {};
  std::vector<std::string> texts(needed.size());
  for (NodeId id = 0; id < needed.size(); ++id) {
    if (needed[id]) texts[id] = arity(graph[id].op) == 0 ? leaf(graph[id]) : call(graph[id], texts);
  }
  return std::array{texts[r[0]], texts[r[1]], texts[r[2]]};
}

void define_names(mu::Parser& parser) {
  parser.DefineConst("our_nan", std::numeric_limits<double>::quiet_NaN());
  parser.DefineConst("our_inf", std::numeric_limits<double>::infinity());
  for (int op = static_cast<int>(Op::Neg); op <= static_cast<int>(Op::SincN); ++op) {
    const Spelling s = spelling(static_cast<Op>(op));
    if (s.one != nullptr) parser.DefineFun(s.name, s.one);
    if (s.two != nullptr) parser.DefineFun(s.name, s.two);
  }
}

}  // namespace

struct MuparserMethod::Impl {
  std::array<mu::Parser, 3> parsers;
  double u = 0;
  double v = 0;

  /// muparser reads variables where they are; it wants them writable, and does not write.
  void bind(const double* at_u, const double* at_v) {
    for (mu::Parser& parser : parsers) {
      parser.DefineVar("u", const_cast<double*>(at_u));
      parser.DefineVar("v", const_cast<double*>(at_v));
    }
  }
};

MuparserMethod::MuparserMethod(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MuparserMethod::~MuparserMethod() = default;
MuparserMethod::MuparserMethod(MuparserMethod&&) noexcept = default;
MuparserMethod& MuparserMethod::operator=(MuparserMethod&&) noexcept = default;

std::optional<MuparserMethod> MuparserMethod::make(const Graph& graph,
                                                   const std::array<NodeId, 3>& r) {
  const auto texts = formulas(graph, r);
  if (!texts) return std::nullopt;
  auto impl = std::make_unique<Impl>();
  try {
    for (std::size_t k = 0; k < 3; ++k) {
      define_names(impl->parsers[k]);
      impl->parsers[k].SetExpr((*texts)[k]);
    }
    impl->bind(&impl->u, &impl->v);
    for (mu::Parser& parser : impl->parsers) parser.Eval();  // this is where it reads the text
  } catch (const mu::ParserError&) {
    return std::nullopt;
  }
  return MuparserMethod(std::move(impl));
}

void MuparserMethod::scalar(std::span<const double> u, std::span<const double> v,
                            const std::array<double*, 3>& outputs) {
  impl_->bind(&impl_->u, &impl_->v);
  for (std::size_t i = 0; i < u.size(); ++i) {
    impl_->u = u[i];
    impl_->v = v[i];
    for (std::size_t k = 0; k < 3; ++k) outputs[k][i] = impl_->parsers[k].Eval();
  }
}

void MuparserMethod::bulk(std::span<const double> u, std::span<const double> v,
                          const std::array<double*, 3>& outputs) {
  impl_->bind(u.data(), v.data());
  for (std::size_t k = 0; k < 3; ++k) {
    impl_->parsers[k].Eval(outputs[k], static_cast<int>(u.size()));
  }
}

}  // namespace saddle
