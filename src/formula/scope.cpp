#include "formula/scope.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

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

bool is_coordinate(std::string_view name) {
  return name == "x" || name == "y" || name == "z";
}

/// The surface's own definitions and its coordinates are formulas of the surface.
bool is_of_surface(const Definition& definition) {
  return definition.own || is_coordinate(definition.name);
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
  View view;
  std::vector<Entry> entries;  // none is moved once its name is known
  std::map<std::pair<std::string_view, bool>, std::size_t> known_entries;  // by name, own or not
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

  Impl(Graph& g, View how) : graph(g), view(std::move(how)) {}

  std::optional<Symbol> independent_variable(std::string_view name) const {
    if (name == view.parameters[0]) return kSymbolU;
    if (name == view.parameters[1]) return kSymbolV;
    if (name == "t") return kSymbolT;
    return std::nullopt;
  }

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

  Entry* find(std::string_view name, bool own) {
    const auto found = known_entries.find({name, own});
    return found == known_entries.end() ? nullptr : &entries[found->second];
  }

  /// The entries have room for it. Throws Error (Input).
  void add(Definition definition) {
    check_name(definition);
    entries.push_back({std::move(definition), Progress::Untouched, 0, {}});
    const Definition& added = entries.back().definition;
    known_entries.emplace(std::pair(std::string_view(added.name), added.own), entries.size() - 1);
  }

  /// The definition that a name means in a formula of the surface, or in a shared one; nullptr: it
  /// means no definition.
  Entry* meant(std::string_view name, bool of_surface) {
    Entry* const own = of_surface ? find(name, true) : nullptr;
    if (own != nullptr) return own;
    Entry* const shared = find(name, false);
    const bool is_hidden = of_surface && shared != nullptr && !is_coordinate(name) &&
                           independent_variable(name).has_value();
    return is_hidden ? nullptr : shared;
  }

  void check_name(const Definition& definition) {
    const std::string& name = definition.name;
    const bool is_own_parameter = definition.own && independent_variable(name).has_value();
    if (name == "u" || name == "v" || name == "t" || is_own_parameter) {
      throw name_error(definition, "'" + name + "' cannot be defined",
                       is_own_parameter ? name + " is a parameter of the surface"
                                        : "u, v and t are what formulas depend on; choose another "
                                          "name");
    }
    if (find_built_in(name) != nullptr) {
      throw name_error(definition, "'" + name + "' is a function of the language",
                       "choose another name");
    }
    if (find(name, definition.own) != nullptr) {
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
    entry.node = parse_formula(graph, formula_of(entry.definition),
                               names({}, {}, is_of_surface(entry.definition)));
    // A parameter stays a variable until bind(), so that diff() can differentiate by it.
    if (!graph.is_constant(entry.node) || is_coordinate(entry.definition.name)) return;
    const Symbol symbol = graph.new_symbol();
    parameter_values[symbol] = entry.node;
    entry.node = graph.variable(symbol);
  }

  void resolve_function(Entry& entry) {
    HelperFunction& function = entry.function;
    function.name = entry.definition.name;
    for (std::size_t i = 0; i < entry.definition.arguments.size(); ++i) {
      function.arguments.push_back(graph.new_symbol());
    }
    function.body =
        parse_formula(graph, formula_of(entry.definition),
                      names(entry.definition.arguments, function.arguments, entry.definition.own));
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

  std::optional<NodeId> variable(std::string_view name, bool of_surface) {
    if (Entry* entry = meant(name, of_surface);
        entry != nullptr && !entry->definition.is_function) {
      resolve(*entry);
      return entry->node;
    }
    if (const auto symbol = independent_variable(name)) return graph.variable(*symbol);
    if (const auto value = find_constant(name)) return graph.constant(*value);
    return std::nullopt;
  }

  const HelperFunction* function(std::string_view name, bool of_surface) {
    Entry* entry = meant(name, of_surface);
    if (entry == nullptr || !entry->definition.is_function) return nullptr;
    resolve(*entry);
    return &entry->function;
  }

  /// The meaning of names inside a function with these arguments, which shadow everything else.
  Names names(const std::vector<std::string>& arguments, const std::vector<Symbol>& symbols,
              bool of_surface) {
    const auto argument = [arguments, symbols](std::string_view name) -> std::optional<Symbol> {
      const auto found = std::find(arguments.begin(), arguments.end(), name);
      if (found == arguments.end()) return std::nullopt;
      return symbols[static_cast<std::size_t>(found - arguments.begin())];
    };
    Names result;
    result.variable = [=, this](std::string_view name) -> std::optional<NodeId> {
      if (const auto symbol = argument(name)) return graph.variable(*symbol);
      return variable(name, of_surface);
    };
    result.function = [=, this](std::string_view name) -> const HelperFunction* {
      return argument(name) ? nullptr : function(name, of_surface);
    };
    result.known_variables = [this, arguments] {
      std::vector<std::string> known = arguments;
      known.insert(known.end(), view.parameters.begin(), view.parameters.end());
      known.emplace_back("t");
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

Scope::Scope(Graph& graph, std::vector<Definition> definitions, View view)
    : impl_(std::make_unique<Impl>(graph, std::move(view))) {
  impl_->entries.reserve(definitions.size());
  for (Definition& definition : definitions) impl_->add(std::move(definition));
  for (Impl::Entry& entry : impl_->entries) {
    if (!impl_->view.lazy || is_of_surface(entry.definition)) impl_->resolve(entry);
  }
}

Scope::~Scope() = default;

NodeId Scope::node(const std::string& name) const {
  return *impl_->variable(name, true);
}

NodeId Scope::parse(const std::string& name, const std::string& text, std::optional<Span> part) {
  const FormulaText formula = {name, text, part.value_or(Span{0, text.size()})};
  return parse_formula(impl_->graph, formula, impl_->names({}, {}, impl_->view.of_surface));
}

NodeId Scope::parse_with(const LocalNames& locals, const std::string& name,
                         const std::string& text) {
  Names names = impl_->names({}, {}, true);
  names.variable = [this, &locals](std::string_view word) -> std::optional<NodeId> {
    const auto local = locals.find(std::string(word));
    const bool is_local = local != locals.end() && impl_->meant(word, true) == nullptr;
    return is_local ? local->second() : impl_->variable(word, true);
  };
  names.known_variables = [known = names.known_variables, &locals] {
    std::vector<std::string> all = known();
    for (const auto& [local, node] : locals) all.push_back(local);
    return all;
  };
  return parse_formula(impl_->graph, {name, text, {0, text.size()}}, names);
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

std::unordered_map<Symbol, double> Scope::constants() const {
  std::unordered_map<Symbol, double> values;
  for (const auto& [symbol, node] : impl_->parameter_values) {
    values[symbol] = impl_->graph[node].value;
  }
  return values;
}

}  // namespace saddle
