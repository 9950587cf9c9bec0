// Any text as a formula: it becomes a graph with derivatives and a tape, or an Error with a place
// inside the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "eval/tape.h"
#include "formula/derive.h"
#include "formula/scope.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace saddle;
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    Graph graph;
    Scope scope(graph, {{"a", "2"}, {"f", "s^2+u", {"s"}, true}});
    const NodeId formula = scope.parse("z", text);
    const std::vector<NodeId> roots = {formula, derive(graph, std::span(&formula, 1), kSymbolU)[0]};
    compile(graph, scope.bind(roots, 0));
  } catch (const Error& error) {
    const Span span = error.place().span;
    if (span.begin > span.end || span.end > error.place().text.size()) std::abort();
    format_error(error);
  }
  return 0;
}
