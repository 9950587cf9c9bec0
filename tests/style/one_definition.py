#!/usr/bin/python3 -B
"""Each name has one definition: in namespace saddle, where compilers and linkers overlook a second
class or inline function in another file; and in the unnamed namespaces of a folder, whose files are
compiled together."""
import collections
import re

import tree

# Comments, literals and preprocessor lines define nothing.
NO_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'"""
    r"""|^[ \t]*\#(?:\\\n|[^\n])*""", re.DOTALL | re.MULTILINE)
TEMPLATE = re.compile(r"template <(?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*> ?")
NAMESPACE = re.compile(r"(?:inline )?(?:namespace ?|(?=extern$))([\w:]*)$")  # or extern "C"
TYPE = re.compile(r"(?:class|struct|union|enum class|enum) (?:alignas\(.*?\) )?(\w+)(?: final)?"
                  r"(?: : .*)?$")
ALIAS = re.compile(r"(?:using|namespace) (\w+) = ")
USING_DECLARATION = re.compile(r"^using (?!namespace)[\w:]+;", re.MULTILINE)
FUNCTION = re.compile(r"(?:.*[ *&])?((?:[\w<>, ]+::)*(?:operator ?\W+|operator ?\(\)|~?\w+))\((.*)\)"
                      r"[^()=]*$")
INITIALISERS = re.compile(r"\)(?: noexcept)? : .*")  # of a constructor
VALUE = re.compile(r"[^()]*[ *&](\w+)(?:\[.*\])?$")
VALUE_IN_PARENTHESES = re.compile(r".*[ *&](k[A-Z]\w*)\(")
PARAMETER = re.compile(r"(.*[\w>&*\]]) ?\b\w+(\[\w*\])?$")
DECLARED_FUNCTION = re.compile(r"^\w[^;{}()=]*[ *&](\w+)\(", re.MULTILINE)


def definitions(code):
    """The namespaces, the name and the head of each definition outside classes and functions. An
    unnamed namespace is ''; to a function's name belong the types of its parameters."""
    namespaces, head, depth, has_body = [], "", 0, False
    for token in re.findall(r"[{};]|[^{};]+", code):
        if token == "{":
            depth += 1
            if depth == 1 and (inner := NAMESPACE.match(one_line(head))):
                namespaces.append(inner[1])
                head, depth = "", 0
            has_body = has_body or depth == 1
        elif token == "}" and depth == 0:
            namespaces.pop()
        elif token == "}":
            depth -= 1
            if depth == 0 and (name := function(one_line(head))) is not None:  # no ';' follows
                yield tuple(namespaces), name, one_line(head)
                head, has_body = "", False
        elif token == ";" and depth == 0:
            if name := type_or_value(one_line(head), has_body):
                yield tuple(namespaces), name, one_line(head)
            head, has_body = "", False
        elif depth == 0:
            head += token
    assert not namespaces and not head.strip(), f"lost the thread at: {one_line(head)[:60]}"


def one_line(head):
    return TEMPLATE.sub("", " ".join(head.split()), count=1)


def function(head):
    match = FUNCTION.match(INITIALISERS.sub(")", head))
    if not match or TYPE.match(head) or ALIAS.match(head):
        return None
    name, parameters = match.groups()
    types = (PARAMETER.sub(r"\1\2", parameter.partition("=")[0].strip())
             for parameter in re.split(r",(?![^<]*>)", parameters))
    return f"{name}({', '.join(types)})"


def type_or_value(head, has_body):
    if alias := ALIAS.match(head):
        return alias[1]
    if value := VALUE_IN_PARENTHESES.match(head):
        return value[1]
    head, equals, _ = head.partition(" =")
    if head.startswith(("extern ", "using ")) or not (equals or has_body):
        return None  # a declaration
    match = (not equals and TYPE.match(head)) or VALUE.match(head)
    return match and match[1]


def complaints(sources):
    shared = collections.defaultdict(dict)  # (namespaces, name) -> file: head
    unnamed = collections.defaultdict(dict)  # (group, name) -> file: head
    functions = collections.defaultdict(set)  # (group, name) -> headers that declare it
    for source in sources:
        group = group_of(source)
        code = NO_CODE.sub(" ", (tree.ROOT / source).read_text(encoding="utf-8"))
        if "SADDLE_LEVEL" in code:
            continue  # compiled by itself, once for each CPU level
        for name in USING_DECLARATION.findall(code):
            if source.suffix == ".h" or group == source:
                continue
            yield f"{source}: '{name}' holds for all files that are compiled with this one"
        for namespaces, name, head in definitions(code):
            if "" in namespaces:
                unnamed[group, name][source] = head
            else:
                shared[namespaces, name][source] = head
        if source.suffix == ".h" and "namespace saddle {" in code:
            for name in DECLARED_FUNCTION.findall(code):
                functions[group, name].add(source)
    for (namespaces, name), heads in shared.items():
        if differ(heads):
            yield f"{listed(heads)}: {'::'.join([*namespaces, name])} is defined in each"
    for (group, name), heads in unnamed.items():
        if differ(heads):
            yield f"{listed(heads)}: {name} is defined in the unnamed namespace of each"
        named = shared.get((("saddle",), name), {})
        hidden = {header for header in named if group_of(header) == group and header.suffix == ".h"}
        hidden |= functions[group, name.partition("(")[0]]
        hidden -= {source.with_suffix(".h") for source in heads}  # overloads
        if hidden:
            yield f"{listed(heads)}: {name} hides that of {listed(hidden)}"


def group_of(source):
    """What a source may be compiled together with: its folder."""
    together = source.parts[0] == "src" or source.parts[1] in {"unit", "geometry"}
    return source.parent if together else source


def differ(heads):
    """Whether files define different things: the same alias is none."""
    return len(heads) > 1 and not (len(different := set(heads.values())) == 1 and
                                   ALIAS.match(different.pop()))


def listed(files):
    return ", ".join(sorted(map(str, files)))


sources = [name for name in tree.files("src", "tests")
           if name.suffix in {".h", ".cpp"} and name.parts[1] not in {"bench", "fuzz"}]
tree.finish(complaints(sources), len(sources), "sources")
