#include "formula/scope.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "formula/language.h"
#include "formula/parser.h"

namespace saddle {

std::string display_name(const Definition& definition) {
  if (!definition.is_function) return definition.name;
  std::string text = definition.name + "(";
  for (const std::string& argument : definition.arguments) {
    if (text.back() != '(') text += ", ";
    text += argument;
  }
  return text + ")";
}

namespace {

/// Deepest chain of definitions that use each other, the same as of brackets: some kilobytes of
/// stack each, of the eight megabytes that there are, and a sanitizer's frames are several times as
/// large.
constexpr std::size_t kMaxChain = 256;

FormulaText formula_of(const Definition& definition) {
  return {display_name(definition), definition.text, {0, definition.text.size()}};
}

/// An error about the name of a definition, not about its formula.
Error name_error(const Definition& definition, std::string message, std::string hint) {
  return formula_of(definition).error(std::move(message), {0, 0}, std::move(hint));
}

std::optional<Symbol> independent_variable(std::string_view name) {
  if (name == "u") return kSymbolU;
  if (name == "v") return kSymbolV;
  if (name == "t") return kSymbolT;
  return std::nullopt;
}

}  // namespace

struct Scope::Impl {
  enum class Progress { Untouched, Running, Done };
  struct Entry {
    Definition definition;
    Progress progress = Progress::Untouched;
    NodeId node = 0;          // what the name stands for
    HelperFunction function;  // of a function
  };

  Graph& graph;
  std::vector<Entry> entries;
  std::vector<std::size_t> running;  // entries being parsed, outermost first
  std::unordered_map<Symbol, NodeId> parameter_values;
  /// A result of constant(): many numbers of a scene have the same text.
  struct KnownConstant {
    NodeId node = 0;
    double value = 0;
    std::optional<double> t;  // that it is the value at
  };
  std::unordered_map<std::string, KnownConstant> known_constants;  // by their texts
  std::vector<double> values;  // of the graph's nodes, at values_t
  double values_t = 0;
  bool has_used_time = false;

  explicit Impl(Graph& g) : graph(g) {}

  bool depends_on_time(NodeId node) const { return (graph[node].depends & kDependsT) != 0; }

  double value_of_variable(Symbol symbol, double t) const {
    if (symbol == kSymbolT) return t;
    const auto parameter = parameter_values.find(symbol);
    return parameter == parameter_values.end() ? std::numeric_limits<double>::quiet_NaN()
                                               : graph[parameter->second].value;
  }

  /// The value of a root that depends on parameters and t alone. All nodes up to it are computed,
  /// once for each t: a scene's numbers share most of theirs.
  double evaluate(NodeId root, double t) {
    if (t != values_t) values.clear();
    values_t = t;
    for (NodeId id = static_cast<NodeId>(values.size()); id <= root; ++id) {
      const Node& node = graph[id];
      const auto& [a, b, c] = node.args;
      values.push_back(node.op == Op::Constant   ? node.value
                       : node.op == Op::Variable ? value_of_variable(node.symbol, t)
                                                 : apply(node.op, values[a], values[b], values[c]));
    }
    return values[root];
  }

  /// Throws Error (Input) if it is no constant.
  double value(NodeId root, const FormulaText& formula, std::optional<double> t) {
    const bool moves = depends_on_time(root);
    has_used_time = has_used_time || moves;
    const bool is_of_parameters = (graph[root].depends & (kDependsU | kDependsV)) == 0;
    if (is_of_parameters && (t || !moves)) return evaluate(root, t.value_or(values_t));
    std::unordered_map<Symbol, NodeId> known = parameter_values;
    if (t) known[kSymbolT] = graph.constant(*t);
    const NodeId bound = substitute(graph, std::array{root}, known)[0];
    if (graph.is_constant(bound)) return graph[bound].value;  // what was chosen has no u and v
    throw formula.error("this must be a constant", formula.part,
                        t ? "it may use numbers, constants, parameters and t, not u or v"
                          : "it may use numbers, constants and parameters, not u, v or t");
  }

  Entry* find(std::string_view name) {
    for (Entry& entry : entries) {
      if (entry.definition.name == name) return &entry;
    }
    return nullptr;
  }

  void check_name(const Definition& definition) {
    const std::string& name = definition.name;
    if (name == "u" || name == "v" || name == "t") {
      throw name_error(definition, "'" + name + "' cannot be defined",
                       "u, v and t are what formulas depend on; choose another name");
    }
    if (find_built_in(name) != nullptr) {
      throw name_error(definition, "'" + name + "' is a function of the language",
                       "choose another name");
    }
    if (find(name) != nullptr) {
      throw name_error(definition, "'" + name + "' is defined twice", "choose another name");
    }
    for (std::size_t i = 0; i < definition.arguments.size(); ++i) {
      const auto rest = definition.arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      if (std::find(rest, definition.arguments.end(), definition.arguments[i]) !=
          definition.arguments.end()) {
        throw name_error(definition, "two arguments are called '" + definition.arguments[i] + "'",
                         "give each its own name");
      }
    }
  }

  /// Parses the entry unless that is done; an entry that is being parsed closes a circle.
  void resolve(Entry& entry) {
    if (entry.progress == Progress::Done) return;
    const auto index = static_cast<std::size_t>(&entry - entries.data());
    if (entry.progress == Progress::Running) throw circle(index);
    if (running.size() >= kMaxChain) {
      throw name_error(entry.definition, "definitions use each other more than 256 deep",
                       "use fewer levels");
    }
    entry.progress = Progress::Running;
    running.push_back(index);
    if (entry.definition.is_function) {
      resolve_function(entry);
    } else {
      resolve_value(entry);
    }
    running.pop_back();
    entry.progress = Progress::Done;
  }

  void resolve_value(Entry& entry) {
    entry.node = parse_formula(graph, formula_of(entry.definition), names({}, {}));
    // A parameter stays a variable until bind(), so that diff() can differentiate by it.
    if (!graph.is_constant(entry.node) || is_coordinate(entry.definition.name)) return;
    const Symbol symbol = graph.new_symbol();
    parameter_values[symbol] = entry.node;
    entry.node = graph.variable(symbol);
  }

  static bool is_coordinate(std::string_view name) {
    return name == "x" || name == "y" || name == "z";
  }

  void resolve_function(Entry& entry) {
    HelperFunction& function = entry.function;
    function.name = entry.definition.name;
    for (std::size_t i = 0; i < entry.definition.arguments.size(); ++i) {
      function.arguments.push_back(graph.new_symbol());
    }
    function.body = parse_formula(graph, formula_of(entry.definition),
                                  names(entry.definition.arguments, function.arguments));
  }

  Error circle(std::size_t index) {
    std::string path;
    const auto start = std::find(running.begin(), running.end(), index);
    for (auto step = start; step != running.end(); ++step) {
      path += entries[*step].definition.name + " -> ";
    }
    path += entries[index].definition.name;
    return name_error(entries[index].definition, "a definition that needs itself: " + path,
                      "break the circle");
  }

  std::optional<NodeId> variable(std::string_view name) {
    if (Entry* entry = find(name); entry != nullptr && !entry->definition.is_function) {
      resolve(*entry);
      return entry->node;
    }
    if (const auto symbol = independent_variable(name)) return graph.variable(*symbol);
    if (const auto value = find_constant(name)) return graph.constant(*value);
    return std::nullopt;
  }

  const HelperFunction* function(std::string_view name) {
    Entry* entry = find(name);
    if (entry == nullptr || !entry->definition.is_function) return nullptr;
    resolve(*entry);
    return &entry->function;
  }

  /// The meaning of names inside a function with these arguments, which shadow everything else.
  Names names(const std::vector<std::string>& arguments, const std::vector<Symbol>& symbols) {
    const auto argument = [arguments, symbols](std::string_view name) -> std::optional<Symbol> {
      const auto found = std::find(arguments.begin(), arguments.end(), name);
      if (found == arguments.end()) return std::nullopt;
      return symbols[static_cast<std::size_t>(found - arguments.begin())];
    };
    Names result;
    result.variable = [this, argument](std::string_view name) -> std::optional<NodeId> {
      if (const auto symbol = argument(name)) return graph.variable(*symbol);
      return variable(name);
    };
    result.function = [this, argument](std::string_view name) -> const HelperFunction* {
      return argument(name) ? nullptr : function(name);
    };
    result.known_variables = [this, arguments] {
      std::vector<std::string> known = arguments;
      known.insert(known.end(), {"u", "v", "t"});
      add_defined(known, false);
      const std::vector<std::string> constants = constant_names();
      known.insert(known.end(), constants.begin(), constants.end());
      return known;
    };
    result.known_functions = [this] {
      std::vector<std::string> known = function_names();
      add_defined(known, true);
      std::sort(known.begin(), known.end());
      return known;
    };
    return result;
  }

  void add_defined(std::vector<std::string>& known, bool functions) const {
    for (const Entry& entry : entries) {
      if (entry.definition.is_function == functions) known.push_back(entry.definition.name);
    }
  }
};

Scope::Scope(Graph& graph, std::vector<Definition> definitions)
    : impl_(std::make_unique<Impl>(graph)) {
  impl_->entries.reserve(definitions.size());
  for (Definition& definition : definitions) {
    impl_->check_name(definition);
    impl_->entries.push_back({std::move(definition), Impl::Progress::Untouched, 0, {}});
  }
  for (Impl::Entry& entry : impl_->entries) impl_->resolve(entry);
}

Scope::~Scope() = default;

NodeId Scope::node(const std::string& name) const {
  return impl_->find(name)->node;
}

NodeId Scope::parse(const std::string& name, const std::string& text, std::optional<Span> part) {
  const FormulaText formula = {name, text, part.value_or(Span{0, text.size()})};
  return parse_formula(impl_->graph, formula, impl_->names({}, {}));
}

NodeId Scope::parse_with(const LocalNames& locals, const std::string& name,
                         const std::string& text) {
  Names names = impl_->names({}, {});
  names.variable = [this, &locals](std::string_view word) -> std::optional<NodeId> {
    const auto local = locals.find(std::string(word));
    const bool is_local = local != locals.end() && impl_->find(word) == nullptr;
    return is_local ? local->second() : impl_->variable(word);
  };
  names.known_variables = [known = names.known_variables, &locals] {
    std::vector<std::string> all = known();
    for (const auto& [local, node] : locals) all.push_back(local);
    return all;
  };
  return parse_formula(impl_->graph, {name, text, {0, text.size()}}, names);
}

NodeId Scope::parse_of(const std::string& argument, Symbol symbol, const std::string& name,
                       const std::string& text) {
  return parse_formula(impl_->graph, {name, text, {0, text.size()}},
                       impl_->names({argument}, {symbol}));
}

double Scope::constant(const std::string& name, const std::string& text, std::optional<Span> part,
                       std::optional<double> t) {
  if (part) return impl_->value(parse(name, text, part), {name, text, *part}, t);
  const FormulaText formula = {name, text, {0, text.size()}};
  const auto known = impl_->known_constants.find(text);
  if (known == impl_->known_constants.end()) {
    const NodeId node = parse(name, text);
    const double value = impl_->value(node, formula, t);
    impl_->known_constants.emplace(text, Impl::KnownConstant{node, value, t});
    return value;
  }
  Impl::KnownConstant& constant = known->second;
  if (impl_->depends_on_time(constant.node) && constant.t != t) {
    constant.value = impl_->value(constant.node, formula, t);
    constant.t = t;
  }
  return constant.value;
}

bool Scope::has_used_time() const {
  return impl_->has_used_time;
}

std::vector<NodeId> Scope::bind(std::span<const NodeId> roots, double t) {
  std::unordered_map<Symbol, NodeId> values = impl_->parameter_values;
  values[kSymbolT] = impl_->graph.constant(t);
  return substitute(impl_->graph, roots, values);
}

std::map<std::string, double> Scope::parameters() const {
  std::map<std::string, double> values;
  for (const Impl::Entry& entry : impl_->entries) {
    if (entry.definition.is_function || Impl::is_coordinate(entry.definition.name)) continue;
    const NodeId bound =
        substitute(impl_->graph, std::array{entry.node}, impl_->parameter_values)[0];
    if (impl_->graph.is_constant(bound)) {
      values[entry.definition.name] = impl_->graph[bound].value;
    }
  }
  return values;
}

}  // namespace saddle
