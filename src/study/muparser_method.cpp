#include "study/muparser_method.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/format.h"
#include "formula/operations.h"

namespace saddle {
namespace {

/// Past this many bytes muparser refuses, whose limit is 20000.
constexpr double kLongest = 19000;

/// Before the names of functions that are not muparser's own.
constexpr const char* kOurs = "our_";

template <Op op>
double call_one(double a) {
  return apply(op, a);
}
template <Op op>
double call_two(double a, double b) {
  return apply(op, a, b);
}

/// An operation as a function of ours that is handed to muparser.
struct Function {
  double (*one)(double);
  double (*two)(double, double);
};

constexpr std::array kFunctions = {
#define SADDLE_OP(id, ...) Function{call_one<Op::id>, call_two<Op::id>},
#include "formula/ops.def"
};

/// The name of an operation in formulas; its name in C++ if that is empty.
std::string name_of(const Operation& row) {
  return *row.name == '\0' ? row.function : row.name;
}

bool is_infix(const Operation& row) {
  return row.arity == 2 && std::ispunct(static_cast<unsigned char>(name_of(row)[0])) != 0;
}

/// Whether muparser has a function of the same name and the same values. Its sign is 0 of NaN, its
/// rint is one off just below a half.
bool is_known(const Operation& row) {
  static const mu::Parser parser;
  if (row.op == Op::Sign || row.op == Op::Rint) return false;
  return parser.GetFunDef().contains(name_of(row));
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
  if (node.op == Op::Neg) return "(-" + of[a] + ")";
  if (node.op == Op::Pow) return "(" + of[a] + "^" + of[b] + ")";
  const Operation& row = row_of(node.op);
  if (is_infix(row)) return "(" + of[a] + row.name + of[b] + ")";
  const std::string name = std::string(is_known(row) ? "" : kOurs) + name_of(row);
  return name + "(" + of[a] + (row.arity > 1 ? "," + of[b] : "") + ")";
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
  for (std::size_t k = 0; k < kOperations.size(); ++k) {
    const Operation& row = kOperations[k];
    const std::string name = kOurs + name_of(row);
    if (is_known(row) || std::isalpha(static_cast<unsigned char>(name_of(row)[0])) == 0) continue;
    if (row.arity == 1) parser.DefineFun(name, kFunctions[k].one);
    if (row.arity == 2) parser.DefineFun(name, kFunctions[k].two);
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
