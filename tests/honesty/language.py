"""Formulas of saddle, evaluated with numpy: a parser of its own, by docs/LANGUAGE.md."""
import re

import numpy as np
import scipy.special

TOKEN = re.compile(r"\s*(?:((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|([A-Za-z_]\w*)|"
                   r"(\*\*|<=|>=|==|!=|&&|\|\||[-+*/^<>?:(),]))")
CONSTANTS = {"pi": np.pi, "e": np.e, "tau": 2 * np.pi, "phi": (1 + 5 ** 0.5) / 2, "inf": np.inf,
             "nan": np.nan}
# Operators of two operands, from the loosest to the tightest, all grouped from the left.
LEVELS = [("||",), ("&&",), ("<", "<=", ">", ">=", "==", "!="), ("+", "-"), ("*", "/")]
# Functions whose value may be infinite near finite arguments.
POLES = {"ln", "log", "log2", "log10", "tan", "sec", "csc", "cot", "atanh", "gamma", "lgamma", "/",
         "exp", "sinh", "cosh", "inf"}
# Functions that may be undefined.
UNDEFINED = POLES | {"sqrt", "asin", "acos", "acosh", "nan", "mod"}


def _round(a):
    return np.sign(a) * np.floor(np.abs(a) + 0.5)


def _true(a):
    return np.asarray(a) != 0


def _smoothstep(a, b, c):
    s = np.minimum(np.maximum((c - a) / (b - a), 0), 1)
    return s * s * (3 - 2 * s)


def _sinc(a):
    return np.where(a == 0, 1.0, np.sin(a) / np.where(a == 0, 1.0, a))


def _power(a, b):
    """0^0 is 1; a negative base needs a whole exponent, which is numpy's rule, too."""
    if np.ndim(b) == 0 and b == 2:
        return a * a
    return np.power(np.asarray(a) * 1.0, b)


def _fold(function):
    def folded(*arguments):
        result = arguments[0]
        for argument in arguments[1:]:
            result = function(result, argument)
        return result
    return folded


def _in_doubles(function):
    """scipy has its functions in no more than doubles."""
    return lambda a: function(np.asarray(a, dtype=float))


FUNCTIONS = {
    "if": lambda a, b, c: np.where(_true(a), b, c), "pow": _power, "sqrt": np.sqrt, "cbrt": np.cbrt,
    "hypot": np.hypot, "exp": np.exp, "ln": np.log, "log": np.log, "log2": np.log2,
    "log10": np.log10, "sin": np.sin, "cos": np.cos, "tan": np.tan, "asin": np.arcsin,
    "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "sec": lambda a: 1 / np.cos(a),
    "csc": lambda a: 1 / np.sin(a), "cot": lambda a: np.cos(a) / np.sin(a), "sinh": np.sinh,
    "cosh": np.cosh, "tanh": np.tanh, "asinh": np.arcsinh, "acosh": np.arccosh,
    "atanh": np.arctanh, "abs": np.abs, "sign": np.sign, "floor": np.floor, "ceil": np.ceil,
    "round": _round, "rint": lambda a: np.floor(a + 0.5), "trunc": np.trunc,
    "mod": lambda a, b: a - b * np.floor(a / b),
    "clamp": lambda a, b, c: np.minimum(np.maximum(a, b), c),
    "step": lambda a, b: 1.0 * (b >= a), "smoothstep": _smoothstep,
    "mix": lambda a, b, c: a + (b - a) * c, "min": _fold(np.minimum), "max": _fold(np.maximum),
    "sum": _fold(np.add), "avg": lambda *a: _fold(np.add)(*a) / len(a), "sinc": _sinc,
    **{name: _in_doubles(function) for name, function in {
        "erf": scipy.special.erf, "gamma": scipy.special.gamma, "lgamma": scipy.special.gammaln,
        "besselj0": scipy.special.j0, "besselj1": scipy.special.j1}.items()},
    "_and": lambda a, b: 1.0 * (_true(a) & _true(b)),
    "_or": lambda a, b: 1.0 * (_true(a) | _true(b)),
    "_power": _power,
}


def _tokens(text):
    at, found = 0, []
    text = text.strip()
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"cannot read {text[at:]!r}")
        at = match.end()
        number, name, sign = match.groups()
        found.append(("number", number) if number else ("name", name) if name else ("sign", sign))
    return found + [("end", "")]


class Parser:
    """One formula to a tuple tree: ("number", x), ("name", s), ("call", f, arguments)."""

    def __init__(self, text):
        self.tokens = _tokens(text)
        self.at = 0

    def take(self, *signs):
        kind, text = self.tokens[self.at]
        if kind == "sign" and text in signs:
            self.at += 1
            return text
        return None

    def need(self, sign):
        if not self.take(sign):
            raise ValueError(f"{sign!r} expected, not {self.tokens[self.at][1]!r}")

    def whole(self):
        tree = self.choice()
        if self.tokens[self.at][0] != "end":
            raise ValueError(f"cannot read {self.tokens[self.at][1]!r}")
        return tree

    def choice(self):
        condition = self.binary(0)
        if not self.take("?"):
            return condition
        first = self.choice()
        self.need(":")
        return ("call", "if", [condition, first, self.choice()])

    def binary(self, level):
        if level == len(LEVELS):
            return self.signed()
        left = self.binary(level + 1)
        while sign := self.take(*LEVELS[level]) or self.product_without_sign(level):
            left = ("call", sign, [left, self.binary(level + 1)])
        return left

    def product_without_sign(self, level):
        """A number right before a name or a bracket is its factor."""
        before, (kind, text) = self.tokens[self.at - 1][0], self.tokens[self.at]
        follows = kind == "name" or (kind, text) == ("sign", "(")
        return "*" if level == len(LEVELS) - 1 and before == "number" and follows else None

    def signed(self):
        if self.take("-"):
            return ("call", "negative", [self.power()])
        self.take("+")
        return self.power()

    def power(self):
        base = self.primary()
        if not self.take("^", "**"):
            return base
        sign = self.take("-", "+")
        exponent = self.power()
        return ("call", "^", [base, ("call", "negative", [exponent]) if sign == "-" else exponent])

    def primary(self):
        kind, text = self.tokens[self.at]
        if self.take("("):
            tree = self.choice()
            self.need(")")
            return tree
        self.at += 1
        if kind == "number":
            return ("number", float(text))
        if kind != "name":
            raise ValueError(f"cannot read {text!r}")
        if not self.take("("):
            return ("name", text)
        arguments = [self.choice()]
        while self.take(","):
            arguments.append(self.choice())
        self.need(")")
        return ("call", text, arguments)


def words_of(tree):
    """Names of all functions, operators and constants."""
    if tree[0] == "name":
        return {tree[1]}
    if tree[0] == "call":
        found = {tree[1]}
        for argument in tree[2]:
            found |= words_of(argument)
        if tree[1] == "^" and not _is_whole_power(tree[2][1]):
            found |= {"sqrt"}
        if tree[1] == "^" and not (tree[2][1][0] == "number"):
            found |= {"/"}
        if tree[1] == "/" and tree[2][1][0] == "number" and tree[2][1][1] != 0:
            found -= {"/"} if not any("/" in words_of(a) for a in tree[2]) else set()
        return found
    return set()


def _is_whole_power(tree):
    return tree[0] == "number" and tree[1] == int(tree[1])


def _call(name, *arguments):
    return ("call", name, list(arguments))


def _critical(tree, found):
    """Collects expressions at whose zeros a formula may jump, end, bend or peak."""
    if tree[0] != "call":
        return
    name, a = tree[1], tree[2]
    if name in ("<", "<=", ">", ">=", "==", "!=", "min", "max", "hypot", "step") and len(a) == 2:
        found.append(_call("-", *a))
    if name in ("sqrt", "ln", "log", "log2", "log10", "sign", "abs", "tanh", "erf", "atan", "exp",
                "gamma", "lgamma", "cbrt", "^", "pow"):
        found.append(a[0])
    if name in ("floor", "ceil", "trunc", "step"):
        found.append(_call("sin", _call("*", ("name", "pi"), a[0])))
    if name in ("round", "rint", "tan", "sec"):
        factor = _call("*", ("name", "pi"), a[0]) if name in ("round", "rint") else a[0]
        found.append(_call("cos", factor))
    if name == "mod":
        found.append(_call("sin", _call("*", ("name", "pi"), _call("/", *a))))
    if name == "/":
        found.append(a[1])
    if name in ("csc", "cot"):
        found.append(_call("sin", a[0]))
    if name in ("asin", "acos", "atanh", "acosh"):
        found.extend([_call("-", a[0], ("number", 1.0)), _call("+", a[0], ("number", 1.0))])
    if name == "atan2":
        found.append(a[0])
    if name in ("clamp", "smoothstep"):
        at = a[0] if name == "clamp" else a[2]
        others = a[1:] if name == "clamp" else a[:2]
        found.extend(_call("-", at, other) for other in others)
    for argument in a:
        _critical(argument, found)


def _factors(tree):
    """The parts of a product that are not constant: its zeros are theirs, each crossed once."""
    if tree[0] == "call" and tree[1] == "*":
        return [factor for argument in tree[2] for factor in _factors(argument)]
    if tree[0] == "call" and tree[1] in ("negative", "abs"):
        return _factors(tree[2][0])
    return [] if tree[0] == "number" or tree[0] == "name" and tree[1] in CONSTANTS else [tree]


def _code(tree, names):
    """Python's text of a tree. `names` are those that are defined: helper functions, parts."""
    if tree[0] == "number":
        return repr(tree[1])
    if tree[0] == "name":
        name = tree[1]
        if name in names:
            return name + "_"
        if name in CONSTANTS:
            return f"K['{name}']"
        raise ValueError(f"unknown name {name!r}")
    name, arguments = tree[1], [_code(argument, names) for argument in tree[2]]
    if name in ("+", "-", "*", "/"):
        return f"({arguments[0]}{name}{arguments[1]})"
    if name in ("<", "<=", ">", ">=", "==", "!="):
        return f"(1.0*({arguments[0]}{name}{arguments[1]}))"
    if name == "negative":
        return f"(-{arguments[0]})"
    if name in names:
        return f"{name}_({','.join(arguments)})"
    function = {"&&": "_and", "||": "_or", "^": "_power"}.get(name, name)
    if function not in FUNCTIONS:
        raise ValueError(f"unknown function {name!r}")
    return f"F['{function}']({','.join(arguments)})"


def split_range(text):
    """The two ends of A:B, at a colon that belongs to no choice and no bracket; None without one."""
    depth = choices = 0
    for at, letter in enumerate(text):
        depth += (letter == "(") - (letter == ")")
        if depth == 0:
            choices += letter == "?"
            if letter == ":" and choices == 0:
                return text[:at], text[at + 1:]
            choices -= letter == ":"
    return None


class Surface:
    """r(s, t) over the unit square, which is stretched to the ranges of u and v."""

    def __init__(self, assignments):
        formulas, helpers = {"x": "u", "y": "v"}, {}
        ranges = {"u": ("-1", "1"), "v": ("-1", "1")}
        for assignment in assignments:
            name, text = re.match(r"\s*([A-Za-z_]\w*(?:\([^)]*\))?)\s*=(.*)", assignment, re.S).groups()
            if name in ranges and split_range(text):
                ranges[name] = split_range(text)
            elif "(" in name:
                helpers[name.split("(")[0]] = (name.split("(")[1][:-1].split(","), text)
            else:
                formulas[name] = text
        self.words = set()
        self._compile(formulas, helpers, ranges)
        self._compile_critical()
        self.may_have_poles = bool(self.words & POLES)
        self.may_be_undefined = bool(self.words & UNDEFINED)

    def _tree(self, text):
        tree = Parser(text).whole()
        self.words |= words_of(tree)
        return tree

    def _compile(self, formulas, helpers, ranges):
        trees = {name: ([], self._tree(text)) for name, text in formulas.items()}
        for name, (arguments, text) in helpers.items():
            trees[name] = ([argument.strip() for argument in arguments], self._tree(text))
        names = {"u", "v"} | set(trees)
        needs = {name: words_of(tree) & names - set(arguments) - {name}
                 for name, (arguments, tree) in trees.items()}
        lines, parameters, known, variable = [], [], set(), {"u", "v"}
        while len(known) < len(trees):
            ready = [name for name in trees if name not in known and needs[name] <= known | {"u", "v"}]
            if not ready:
                raise ValueError("a circle of definitions")
            for name in ready:
                arguments, tree = trees[name]
                if arguments:
                    head = ",".join(argument + "_" for argument in arguments)
                    line = f"{name}_=lambda {head}: {_code(tree, names | set(arguments))}"
                else:
                    line = f"{name}_={_code(tree, names)}"
                lines.append(line)
                if needs[name] & variable:
                    variable.add(name)
                else:
                    parameters.append(line)
                known.add(name)
        body = "\n ".join(lines)
        ends = {}
        for name, (low, high) in ranges.items():
            parts = [_code(self._tree(end), names) for end in (low, high)]
            ends[name] = parts
        self._trees, self._names, self._body = trees, names, body
        scope = {"F": FUNCTIONS, "K": CONSTANTS, "np": np}
        text = ("def ends_u():\n " + "\n ".join(parameters or ["pass"]) +
                f"\n return {ends['u'][0]}, {ends['u'][1]}\n"
                "def ends_v(u_):\n " + "\n ".join(parameters or ["pass"]) +
                f"\n return {ends['v'][0]}, {ends['v'][1]}\n"
                f"def values(u_, v_):\n {body}\n return x_, y_, z_\n")
        exec(text, scope)  # pylint: disable=exec-used
        self._values, self._ends_v = scope["values"], scope["ends_v"]
        self.u0, self.u1 = (float(end) for end in scope["ends_u"]())

    def _expanded(self, tree, arguments):
        """A tree with calls of defined functions replaced by what they are; `arguments`: trees by names."""
        if tree[0] == "name":
            return arguments.get(tree[1], tree)
        if tree[0] != "call":
            return tree
        given = [self._expanded(argument, arguments) for argument in tree[2]]
        if tree[1] not in self._trees:
            return ("call", tree[1], given)
        names, body = self._trees[tree[1]]
        return self._expanded(body, dict(zip(names, given)))

    def _compile_critical(self):
        found = []
        for arguments, tree in self._trees.values():
            if not arguments:
                _critical(self._expanded(tree, {}), found)
        texts = []
        for tree in [factor for tree in found for factor in _factors(tree)]:
            text = _code(tree, self._names)
            if text not in texts:
                texts.append(text)
        self.critical_count = len(texts)
        scope = {"F": FUNCTIONS, "K": CONSTANTS, "np": np}
        exec(f"def critical(u_, v_):\n {self._body}\n return [{','.join(texts)}]\n", scope)
        self._critical = scope["critical"]

    def critical(self, st):
        """Values of the expressions at whose zeros the surface may change its nature."""
        with np.errstate(all="ignore"):
            u, v = self.uv(st)
            return [np.broadcast_to(g, np.shape(u)) for g in self._critical(u, v)]

    def uv(self, st):
        """Parameters of places in the unit square; the ends are exact."""
        s, t = st[..., 0], st[..., 1]
        u = np.where(s >= 1, self.u1, self.u0 + s * (self.u1 - self.u0))
        low, high = self._ends_v(u)
        return u, np.where(t >= 1, high, low + t * (high - low))

    def rounding(self):
        """The larger unit of rounding of the parameters, in lengths of their ranges."""
        _, ends_v = self.uv(np.array([[0.5, 0.0], [0.5, 1.0]]))
        return max(np.spacing(max(np.abs(ends))) / np.ptp(ends) if np.ptp(ends) else 0
                   for ends in ((self.u0, self.u1), ends_v))

    def st(self, uv):
        """Places in the unit square of parameters."""
        u, v = uv[..., 0], uv[..., 1]
        low, high = self._ends_v(u)
        width = np.where(high == low, 1, np.asarray(high, dtype=float) - low)
        return np.stack([(u - self.u0) / (self.u1 - self.u0), (v - low) / width], axis=-1)

    def at_uv(self, u, v):
        with np.errstate(all="ignore"):
            result = np.empty(np.shape(u) + (3,), dtype=np.asarray(u).dtype)
            for k, value in enumerate(self._values(u, v)):
                result[..., k] = value
        return np.where(np.isfinite(result).all(axis=-1)[..., None], result, np.nan)

    def __call__(self, st):
        """Points; NaN where the surface is undefined."""
        with np.errstate(all="ignore"):
            return self.at_uv(*self.uv(st))

    def precisely(self, st):
        """The same with 64 bits of mantissa where functions have them."""
        with np.errstate(all="ignore"):
            u, v = self.uv(st)
            return self.at_uv(u.astype(np.longdouble), v.astype(np.longdouble)).astype(float)

    def function(self, text):
        """One expression of u and v at places of the unit square."""
        scope = {"F": FUNCTIONS, "K": CONSTANTS, "np": np}
        code = eval(f"lambda u_, v_: {_code(Parser(text).whole(), {'u', 'v'})}", scope)  # pylint: disable=eval-used

        def values(st):
            with np.errstate(all="ignore"):
                return code(*self.uv(st)) + np.zeros(np.shape(st)[:-1])
        return values
