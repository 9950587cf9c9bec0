#include "formula/scope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "formula/instance.h"
#include "formula/language.h"
#include "formula/parameters.h"
#include "formula/parser.h"

namespace saddle {
namespace {

/// Deepest chain of definitions that use each other, the same as of brackets: some kilobytes of
/// stack each, of the eight megabytes that there are, and a sanitizer's frames are several times as
/// large.
constexpr std::size_t kMaxChain = 256;

/// How often helper functions may be called with ever other constants. Each is parsed anew.
constexpr std::size_t kMaxInstances = 2000;

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
    Value value;               // what the name stands for
    HelperFunction function;   // of a function
    bool needs_types = false;  // of a function: its formula has a fault with real arguments
    std::map<Pattern, FunctionForTypes> instances = {};
  };

  Graph& graph;
  View view;
  std::vector<Entry> entries;  // none is moved once its name is known
  std::map<std::pair<std::string_view, bool>, std::size_t> known_entries;  // by name, own or not
  std::vector<std::size_t> running;  // entries being parsed, outermost first
  Parameters parameters;
  /// A result of constant(): many numbers of a scene have the same text.
  struct KnownConstant {
    NodeId node = 0;
    double value = 0;
    std::optional<double> t;  // that it is the value at
  };
  std::unordered_map<std::string, KnownConstant> known_constants;  // by their texts
  bool has_used_time = false;
  Unrolled unrolled;
  std::size_t instance_count = 0;

  Impl(Graph& g, View how) : graph(g), view(std::move(how)), parameters(g) {}

  std::optional<Symbol> independent_variable(std::string_view name) const {
    if (name == view.parameters[0]) return kSymbolU;
    if (name == view.parameters[1]) return kSymbolV;
    if (name == "t") return kSymbolT;
    return std::nullopt;
  }

  bool depends_on_time(NodeId node) const { return (graph[node].depends & kDependsT) != 0; }

  /// Throws Error (Input) if it is no constant.
  double value(NodeId root, const FormulaText& formula, std::optional<double> t) {
    const bool moves = depends_on_time(root);
    has_used_time = has_used_time || moves;
    const bool is_of_parameters = (graph[root].depends & (kDependsU | kDependsV)) == 0;
    if (is_of_parameters && (t || !moves)) return parameters.evaluate(root, t);
    std::unordered_map<Symbol, NodeId> known = parameters.constants();
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
    entries.emplace_back().definition = std::move(definition);
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
    if (definition.own && name != "t" && independent_variable(name).has_value()) {
      throw name_error(definition, "'" + name + "' cannot be defined",
                       name + " is a parameter of the surface; choose another name");
    }
    check_names(definition);
    if (find(name, definition.own) != nullptr) {
      throw name_error(definition, "'" + name + "' is defined twice", "choose another name");
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
    if (entry.definition.is_function) {
      resolve_function(entry);
    } else {
      const Run run(*this, entry);
      resolve_value(entry);
    }
    entry.progress = Progress::Done;
  }

  /// While an entry is being parsed.
  class Run {
   public:
    Run(Impl& scope, Entry& entry) : scope_(scope), entry_(entry), before_(entry.progress) {
      entry.progress = Progress::Running;
      scope.running.push_back(static_cast<std::size_t>(&entry - scope.entries.data()));
    }
    ~Run() {
      scope_.running.pop_back();
      entry_.progress = before_;
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

   private:
    Impl& scope_;
    Entry& entry_;
    Progress before_;
  };

  void resolve_value(Entry& entry) {
    const std::string& name = entry.definition.name;
    entry.value = parse_formula(graph, formula_of(entry.definition),
                                names({}, {}, is_of_surface(entry.definition)));
    if (is_coordinate(name)) check_type(entry.value, entry.definition);
    // A parameter stays a variable until bind(), so that diff() can differentiate by it.
    const bool is_parameter =
        entry.value.type == Type::Real && graph.is_constant(entry.value.real());
    if (!is_parameter || is_coordinate(name)) return;
    entry.value = Value(parameters.define(entry.value.real(), entry.definition.kept));
  }

  /// A function is checked with real arguments; one that needs others is checked when it is called.
  void resolve_function(Entry& entry) {
    HelperFunction& function = entry.function;
    function.name = entry.definition.name;
    function.argument_count = entry.definition.arguments.size();
    function.call = [this, &entry](std::span<const Value> values) { return call(entry, values); };
    const Pattern real(function.argument_count, {Type::Real, {}});
    try {
      instance(entry, real);
    } catch (const TypeError&) {
      entry.needs_types = true;
    }
  }

  Value call(Entry& entry, std::span<const Value> values) {
    const bool are_real =
        std::ranges::all_of(values, [](const Value& value) { return value.type == Type::Real; });
    const bool real_are_known = entry.needs_types || (!are_real && !has_diff(entry.definition));
    const Pattern pattern = pattern_of(parameters, values, real_are_known);
    return apply(graph, instance(entry, pattern), pattern, values);
  }

  const FunctionForTypes& instance(Entry& entry, const Pattern& pattern) {
    if (const auto found = entry.instances.find(pattern); found != entry.instances.end()) {
      return found->second;
    }
    if (entry.progress == Progress::Running) {
      throw circle(static_cast<std::size_t>(&entry - entries.data()));
    }
    if (++instance_count > kMaxInstances) {
      throw name_error(entry.definition,
                       "functions are called with more than 2000 different constants",
                       "a function with sum, prod or diff is made anew for each constant; use "
                       "fewer");
    }
    const Run run(*this, entry);
    FunctionForTypes made;
    const std::vector<Value> arguments = make_arguments(graph, pattern, made.symbols);
    made.body = parse_formula(graph, formula_of(entry.definition),
                              names(entry.definition.arguments, arguments, entry.definition.own));
    return entry.instances.emplace(pattern, std::move(made)).first->second;
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

  std::optional<Value> variable(std::string_view name, bool of_surface) {
    if (Entry* entry = meant(name, of_surface);
        entry != nullptr && !entry->definition.is_function) {
      resolve(*entry);
      return entry->value;
    }
    if (const auto symbol = independent_variable(name)) return Value(graph.variable(*symbol));
    const auto constant = find_constant(name);
    if (!constant || (name == "i" && function(name, of_surface) != nullptr)) return std::nullopt;
    const std::array parts = {graph.constant(constant->real()), graph.constant(constant->imag())};
    return constant->imag() == 0 ? Value(parts[0]) : Value(Type::Complex, parts);
  }

  const HelperFunction* function(std::string_view name, bool of_surface) {
    Entry* entry = meant(name, of_surface);
    if (entry == nullptr || !entry->definition.is_function) return nullptr;
    resolve(*entry);
    return &entry->function;
  }

  /// The meaning of names inside a function with these arguments, which shadow everything else.
  Names names(const std::vector<std::string>& arguments, const std::vector<Value>& values,
              bool of_surface) {
    const auto argument = [arguments, values](std::string_view name) -> std::optional<Value> {
      const auto found = std::find(arguments.begin(), arguments.end(), name);
      if (found == arguments.end()) return std::nullopt;
      return values[static_cast<std::size_t>(found - arguments.begin())];
    };
    Names result;
    result.variable = [=, this](std::string_view name) -> std::optional<Value> {
      if (const auto value = argument(name)) return value;
      return variable(name, of_surface);
    };
    result.function = [=, this](std::string_view name) -> const HelperFunction* {
      return argument(name) ? nullptr : function(name, of_surface);
    };
    result.parameter_value = [this](NodeId node) { return parameters.known_value(node); };
    result.sampler = [this](std::span<const NodeId> nodes) { return sample(nodes); };
    result.unrolled = &unrolled;
    result.known_variables = [this, arguments] {
      std::vector<std::string> known = arguments;
      known.insert(known.end(), view.parameters.begin(), view.parameters.end());
      std::erase(known, "");  // a curve has one parameter, a point none
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

  /// The meaning of names in a number of the scene. Suggestions leave out the names that depend on
  /// u or v, and t where the number has no moment.
  Names names_of_constant(bool has_moment) {
    Names result = names({}, {}, view.of_surface);
    result.known_variables = [this, has_moment, all = result.known_variables] {
      std::vector<std::string> known = all();
      std::erase_if(known, [&](const std::string& name) {
        return is_coordinate(name) || name == view.parameters[0] || name == view.parameters[1] ||
               (name == "t" && !has_moment);
      });
      return known;
    };
    return result;
  }

  /// The values of nodes all over the surface.
  std::vector<std::vector<double>> sample(std::span<const NodeId> roots) {
    // Without a range: once round, to either side.
    constexpr SampledRange kUsual = {-2 * std::numbers::pi, 2 * std::numbers::pi};
    std::array<SampledRange, 3> box = {kUsual, kUsual, kUsual};
    for (const std::size_t which : {0U, 1U}) {
      const auto& [min, max] = view.ranges[which];
      if (min.empty() || max.empty()) continue;
      const SampledRange range = {end_of_range(min), end_of_range(max)};
      if (std::isfinite(range.max - range.min)) box[which] = range;
    }
    return parameters.sample(roots, box);
  }

  /// NaN where it is no constant.
  double end_of_range(const std::string& text) {
    try {
      const Value end = parse_formula(graph, {"", text, {0, text.size()}}, names({}, {}, true));
      return parameters.known_value(end.real()).value_or(std::nan(""));
    } catch (const Error&) {
      return std::nan("");  // it is told where the range is read, or uses what is being parsed
    }
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
  return impl_->variable(name, true)->real();
}

NodeId Scope::parse(const std::string& name, const std::string& text, std::optional<Span> part) {
  const FormulaText formula = {name, text, part.value_or(Span{0, text.size()})};
  return require_real(
      parse_formula(impl_->graph, formula, impl_->names({}, {}, impl_->view.of_surface)), formula);
}

NodeId Scope::parse_with(const LocalNames& locals, const std::string& name,
                         const std::string& text) {
  Names names = impl_->names({}, {}, true);
  names.variable = [this, &locals](std::string_view word) -> std::optional<Value> {
    const auto local = locals.find(std::string(word));
    const bool is_local = local != locals.end() && impl_->meant(word, true) == nullptr;
    return is_local ? Value(local->second()) : impl_->variable(word, true);
  };
  names.known_variables = [known = names.known_variables, &locals] {
    std::vector<std::string> all = known();
    for (const auto& [local, node] : locals) all.push_back(local);
    return all;
  };
  const FormulaText formula = {name, text, {0, text.size()}};
  return require_real(parse_formula(impl_->graph, formula, names), formula);
}

double Scope::constant(const std::string& name, const std::string& text, std::optional<Span> part,
                       std::optional<double> t) {
  const FormulaText formula = {name, text, part.value_or(Span{0, text.size()})};
  const auto parsed = [&] {
    return require_real(
        parse_formula(impl_->graph, formula, impl_->names_of_constant(t.has_value())), formula);
  };
  if (part) return impl_->value(parsed(), formula, t);
  const auto known = impl_->known_constants.find(text);
  if (known == impl_->known_constants.end()) {
    const NodeId node = parsed();
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

double Scope::value(NodeId node, const Place& place, std::optional<double> t) {
  return impl_->value(node, {place.name, place.text, place.span}, t);
}

bool Scope::has_used_time() const {
  return impl_->has_used_time;
}

std::vector<NodeId> Scope::bind(std::span<const NodeId> roots, double t) {
  std::unordered_map<Symbol, NodeId> values = impl_->parameters.constants();
  std::erase_if(values, [](const auto& value) { return value.first >= kFirstKeptSymbol; });
  if (!impl_->view.keeps_time) values[kSymbolT] = impl_->graph.constant(t);
  return substitute(impl_->graph, roots, values);
}

std::unordered_map<Symbol, double> Scope::constants() const {
  std::unordered_map<Symbol, double> values;
  for (const auto& [symbol, node] : impl_->parameters.constants()) {
    values[symbol] = impl_->graph[node].value;
  }
  return values;
}

}  // namespace saddle
