"""Surfaces of many kinds, made by a seeded generator. Each is a line as one would type it, with hints:
places and curves, with widths, at which the oracle looks more closely."""
import dataclasses
import math
import random
import shlex

SEED = 1
COUNT = 500
# Kinds and their shares of a corpus.
WEIGHTS = {
    "textbook": 40, "student": 70, "jumps": 50, "crossings": 40, "patches": 60, "slots": 40,
    "spikes": 35, "ridges": 35, "boundaries": 35, "walls": 35, "poles": 25, "scales": 15,
    "anisotropic": 15, "sums": 25, "parametric": 45,
}
GRID_OFF, SAMPLES, FINE = 0.18, 0.03, 0.08  # shares of surfaces with these options


@dataclasses.dataclass
class Case:
    number: int
    kind: str
    formulas: list
    options: list
    hints: list = dataclasses.field(default_factory=list)


def from_line(number, line, options=()):
    words = shlex.split(line)
    first = next((i for i, word in enumerate(words) if word.startswith("--")), len(words))
    return Case(number, "given", words[:first], words[first:] + list(options))


def cases(seed, count):
    total = sum(WEIGHTS.values())
    made = []
    for kind, weight in WEIGHTS.items():
        for index in range(round(count * weight / total)):
            rng = random.Random(f"{seed}/{kind}/{index}")
            maker = Maker(rng)
            formulas = getattr(maker, kind)()
            formulas = [formulas] if isinstance(formulas, str) else list(formulas)
            options = []
            if rng.random() < GRID_OFF:
                options += ["--grid", "off"]
            if rng.random() < SAMPLES:
                options += ["--samples", "64x64"]
            elif rng.random() < FINE:
                options += ["--tolerance", "1e-4"]
            hints = [hint for hint in maker.hints
                     if hint[0] == "point" or any(hint[1] in formula for formula in formulas)]
            made.append(Case(len(made), kind, formulas, options, hints))
    return made


def num(value, digits=4):
    """A number as text; what is read back is the truth."""
    text = f"{value:.{digits}g}"
    return f"({text})" if text.startswith("-") else text


class Maker:
    """One surface: a method for each kind, and the parts that they share."""

    def __init__(self, rng):
        self.rng, self.hints = rng, []

    # --- parts ----------------------------------------------------------------------------------

    def real(self, low, high, digits=4):
        return num(self.rng.uniform(low, high), digits)

    def log(self, low, high, digits=3):
        return math.exp(self.rng.uniform(math.log(low), math.log(high)))

    def pick(self, *choices):
        return self.rng.choice(choices)

    def place(self, reach=0.8):
        """A place in -1:1 x -1:1."""
        return round(self.rng.uniform(-reach, reach), self.pick(1, 4, 6)), \
            round(self.rng.uniform(-reach, reach), self.pick(1, 4, 6))

    def shifted(self, name, at):
        return name if at == 0 else f"({name}{'-' if at > 0 else '+'}{abs(at):.6g})"

    def smooth(self, mild=True):
        """A smooth height."""
        a = self.real(0.1, 0.8)
        f, g = self.real(0.5, 4 if mild else 9), self.real(0.5, 4 if mild else 9)
        return self.pick(f"{a}*sin({f}*u)*cos({g}*v)", f"{a}*u*v", f"{a}*(u^2-v^2)", f"{a}*u+0.2*v",
                         f"{a}*exp(-u^2-{g}*v^2)", f"{a}*sin({f}*u+{g}*v)", f"{a}*u^3-{a}*u*v^2",
                         f"{a}*cos({f}*hypot(u,v))", "0", f"{a}*u", f"{a}/(1+u^2+v^2)")

    def distance(self, at=None, power=False):
        """Distance from a place, or its square, as text, and the place."""
        u, v = at or self.place()
        du, dv = self.shifted("u", u), self.shifted("v", v)
        return (f"({du}^2+{dv}^2)" if power else f"hypot({du},{dv})"), (u, v)

    def line(self, width=1e-3):
        """An expression whose zeros are a curve: axis-parallel or aslant lines, circles, waves, cusps."""
        a = self.rng.uniform(-0.7, 0.7)
        d, _ = self.distance()
        text = self.pick(
            self.shifted("u", round(a, 5)), self.shifted("v", round(a, 5)), "u", "v",
            f"({self.real(0.2, 1)}*u+v-{self.real(0, 0.5)})", f"(u-{self.real(0.1, 2)}*v+{self.real(0, 0.4)})",
            f"({d}-{self.real(0.1, 0.7)})", f"(u^2+v^2-{self.real(0.05, 0.9)})",
            f"(v-{self.real(0.1, 0.6)}*sin({self.real(1, 9)}*u))", f"(u-{self.real(0.1, 0.4)}*cos({self.real(1, 7)}*v))",
            "(v-u^2)", "(u^3-v^2)", f"(u^2-v^2-{self.real(0, 0.3)})", f"(u*v-{self.real(0.01, 0.3)})",
            f"(abs(u)+abs(v)-{self.real(0.2, 0.9)})", "(u-v)", "(u+v)")
        self.hints.append(("curve", text, width))
        return text

    # --- kinds ----------------------------------------------------------------------------------

    def textbook(self):
        a, b = self.real(0.3, 2), self.real(0.3, 2)
        turn = "u=0:tau"
        return self.pick(
            [f"z={a}*u^2-{b}*v^2"], [f"z={a}*(u^3-3*u*v^2)"], [f"z=sin({a}*u)*sin({b}*v)", "u=-pi:pi", "v=-pi:pi"],
            [f"z=cos({a}*hypot(u,v))", "u=-5:5", "v=-5:5"], [f"z=exp(-{a}*(u^2+v^2))", "u=-3:3", "v=-3:3"],
            [f"x={a}*cos(v)*cos(u)", f"y={b}*cos(v)*sin(u)", "z=sin(v)", turn, "v=-pi/2:pi/2"],
            [f"x=(2+{self.real(0.2, 1)}*cos(v))*cos(u)", "y=(2+cos(v))*sin(u)", "z=sin(v)", turn, "v=0:tau"],
            [f"x=v*cos(u)", "y=v*sin(u)", f"z={a}*u", "u=-6:6", "v=-1:1"],
            ["x=cosh(v)*cos(u)", "y=cosh(v)*sin(u)", f"z={a}*v", turn, "v=-1.5:1.5"],
            ["x=u-u^3/3+u*v^2", "y=v-v^3/3+v*u^2", "z=u^2-v^2", "u=-1.5:1.5", "v=-1.5:1.5"],
            ["x=(1+v/2*cos(u/2))*cos(u)", "y=(1+v/2*cos(u/2))*sin(u)", "z=v/2*sin(u/2)", turn],
            [f"x={a}*cos(u)", f"y={b}*sin(u)", "z=v", turn], ["x=v*cos(u)", "y=v*sin(u)", "z=v", turn],
            [f"x=cos(u)*(1+0.3*sin({self.rng.randint(2, 7)}*v))", "y=sin(u)*(1+0.2*cos(v))", "z=v", turn, "v=-3:3"],
            [f"z=u^4-{a}*u^2+v^2"], [f"z={a}/(1+{b}*u^2+v^2)", "u=-4:4", "v=-4:4"],
            [f"x=cos(u)/cosh(v)", "y=sin(u)/cosh(v)", "z=v-tanh(v)", turn, "v=0:3"],
            [f"z=hypot(u,v)*{a}"], [f"z=sinc({a}*hypot(u,v))", "u=-9:9", "v=-9:9"], [f"z=abs(u)-{a}*abs(v)"])

    def term(self, depth):
        """A random expression as students write them."""
        if depth == 0:
            return self.pick("u", "v", "u", "v", "(u+v)", "(u-v)", "(u*v)", self.real(0.2, 3, 2),
                             f"{self.real(1, 5, 2)}*u", f"{self.real(1, 5, 2)}*v", "u^2", "v^2", "(u^2+v^2)")
        a, b = self.term(depth - 1), self.term(self.rng.randint(0, depth - 1))
        return self.pick(f"({a}+{b})", f"({a}-{b})", f"{_bracket(a)}*{_bracket(b)}", f"sin({a})", f"cos({a})",
                         f"sin({a})*cos({b})", f"exp(-({a})^2)", f"sqrt(abs({a}))", f"abs({a})",
                         f"floor({a})", f"sign({a})", f"exp({a})/9", f"max({a},{b})", f"min({a},{b})",
                         f"atan({a})", f"mod({a},1)", f"round({a})", f"hypot({a},{b})", f"tanh({a})",
                         f"(({a})>({b})?{self.term(0)}:{self.term(0)})", f"sqrt({a})", f"cbrt({a})")

    def student(self):
        while True:
            text = self.term(self.rng.randint(2, 3))
            if "u" in text and "v" in text:
                break
        reach = self.pick("1", "2", "3", "pi")
        return [f"z={text}"] + ([] if reach == "1" else [f"u=-{reach}:{reach}", f"v=-{reach}:{reach}"])

    def jumps(self):
        g, f, k = self.line(), self.smooth(), self.real(1, 5, 3)
        return self.pick(
            f"z=sign({g})", f"z={g}>0?{f}:{self.real(0.2, 1)}", f"z={g}<0?{self.smooth()}:1+{f}",
            f"z={f}+({g}>0)*{self.real(0.05, 1)}", f"z=floor({k}*u)", f"z=floor({k}*v+{self.real(0, 1)})*0.3+{f}",
            f"z=round({k}*{g})/3", f"z=mod({k}*u+v,1)", f"z=mod({k}*hypot(u,v),1)/2", f"z=trunc({k}*{g})*0.2+u*v",
            f"z=sign({g})*{self.real(0.02, 0.5)}+{f}", f"z=step(0,{g})*{f}+0.1*u", f"z=floor({k}*sin(3*u)*cos(2*v))/3",
            f"z=ceil({k}*(u^2+v^2))/{k}", f"z=atan2(v,u)/3", f"z=u*sign({g})", f"z={g}>0?u:-u",
            f"z=floor({k}*hypot(u,v))/{k}")

    def crossings(self):
        g, h, k = self.line(), self.line(), self.real(1, 3.5, 3)
        return self.pick(
            f"z=sign({g})*sign({h})", f"z=sign({g}*{h})", f"z=({g}>0)+({h}>0)", f"z=({g}>0&&{h}>0)?1:0",
            f"z=({g}>0||{h}>0)?1:0.2*u", f"z={g}>0?({h}>0?1:2):({h}>0?3:4)", f"z=floor({k}*u)*floor({k}*v)",
            f"z=(floor({k}*(u+v))+floor({k}*(u-v)))/3", f"z=floor({k}*(u+v))*floor({k}*(u-v))/4",
            f"z=floor({k}*u)+sign({g})", f"z=sign(sin({k}*3*u)*sin({k}*3*v))", f"z=mod(floor({k}*u)+floor({k}*v),2)",
            f"z=sign(sin({k}*u*v))", f"z=round({k}*sin(2*u)*sin(3*v))", f"z=({g}>0?1:2)*({h}>0?0.5:u)",
            f"z=max(sign({g}),sign({h}))+0.2*u*v", f"z=({g}>0?1:0)+({h}>0?1:0)+({self.line()}>0?1:0)")

    def region(self, size, at):
        """A condition that holds in a small region about a place."""
        u, v = at
        d, _ = self.distance(at)
        square, _ = self.distance(at, True)
        du, dv = self.shifted("u", u), self.shifted("v", v)
        r = num(size)
        self.hints.append(("point", u, v, size))
        return self.pick(f"{d}<{r}", f"{square}<{num(size * size)}", f"max(abs({du}),abs({dv}))<{r}",
                         f"abs({du})<{r}&&abs({dv})<{num(size * 0.6)}", f"abs({du})+abs({dv})<{r}",
                         f"{d}<{r}&&{du}>0", f"{d}<{r}&&{d}>{num(size * 0.6)}", f"({du}/{num(size)})^2+({dv}/{num(size / 2)})^2<1",
                         f"{d}<{r}&&abs({dv})<abs({du})")

    def patches(self):
        size = self.log(0.003, 0.3)
        inside, f = self.region(size, self.place()), self.smooth()
        values = [f"z=({inside})?{self.real(0.3, 1)}:{f}"] * 3 + [f"z=({inside})?nan:{f}"] * 2 + \
            [f"z=({inside})?{f}:nan", f"z={f}+0.5*({inside})", f"z=({inside})?{self.smooth()}:1+{f}"]
        return self.rng.choice(values)

    def slots(self):
        width = self.log(1e-5, 0.1)
        g, f = self.line(width), self.smooth()
        inside = f"abs({g})<{num(width)}"
        if self.rng.random() < 0.3:
            inside += f"&&{self.pick('u>0', 'v<0.3', 'u+v>0', 'hypot(u,v)<0.6')}"
        return self.pick(f"z=({inside})?{self.real(0.3, 1)}:{f}", f"z=({inside})?{self.real(0.3, 1)}:{f}",
                         f"z=({inside})?nan:{f}", f"z=({inside})?{f}:nan", f"z={f}-({inside})*0.4",
                         f"z=sqrt({num(width)}-abs({g}))+{f}")

    def spikes(self):
        width = self.log(1e-6, 0.1)
        d, at = self.distance(power=True)
        r, _ = self.distance(at)
        self.hints.append(("point", *at, width))
        w, f, k = num(width), self.smooth(), self.real(0.3, 1)
        return self.pick(f"z={f}+{k}*exp(-{d}/{w}^2)", f"z={f}+{k}*max(0,1-{r}/{w})", f"z={f}+{k}/(1+{d}/{w}^2)",
                         f"z={f}+{k}*exp(-{r}/{w})", f"z={f}-{k}*exp(-{d}/{w}^2)", f"z={k}*min(1,{r}/{w})+{f}",
                         f"z={k}*exp(-({d}/{w}^2)^2)+{f}")

    def ridges(self):
        width = self.log(1e-6, 0.1)
        g, w, f, k = self.line(width), num(width), self.smooth(), self.real(0.3, 1)
        return self.pick(f"z={f}+{k}*exp(-({g}/{w})^2)", f"z={f}-{k}*exp(-({g}/{w})^2)", f"z=min(1,abs({g})/{w})",
                         f"z={f}+{k}*max(0,1-abs({g})/{w})", f"z={k}/(1+({g}/{w})^2)",
                         f"z={f}+{k}*(tanh(({g}+{w})/{w})-tanh(({g}-{w})/{w}))", f"z={k}*exp(-abs({g})/{w})+{f}",
                         f"z={f}+{k}*{g}/{w}*exp(-({g}/{w})^2)")

    def boundaries(self):
        g, h, f = self.line(), self.line(), self.smooth()
        p = self.pick("0.5", "1.5", "(1/3)", "(2/3)", "0.25", "0.1", "2.5")
        return self.pick(f"z=sqrt({g})", f"z=sqrt({g})+sqrt({h})", f"z=sqrt({g})*sqrt({h})+{f}", "z=sqrt(u)+sqrt(v)",
                         f"z=sqrt(1-u^2)+sqrt(1-v^2)", f"z=acos({self.real(1, 2)}*u)+asin({self.real(1, 3)}*v)",
                         f"z=acos({g})", f"z=asin({g})*v", f"z={g}^{p}", f"z=(1-u^{p}-v^{p})^{p}",
                         f"z=ln({g})/4", f"z=sqrt({g})+ln({h}+1)", f"z=sqrt(sin({self.real(1, 5)}*u)+sin({self.real(1, 5)}*v))",
                         f"z=sqrt(1-u^2-{self.real(0.5, 3)}*v^2)", f"z=acosh(1+{g})", f"z=sqrt({g}-{self.real(0, 0.5)}*v^2)+{f}",
                         f"z=sqrt(abs({g})-0.1)", f"z=({g})^0.5*({h})^0.5", f"z=u/sqrt({g}+0.05)")

    def walls(self):
        slope = self.log(10, 1e6)
        g, s, f = self.line(1 / slope), num(slope), self.smooth()
        return self.pick(f"z=tanh({s}*{g})", f"z=erf({s}*{g})", f"z=clamp({s}*{g},-1,1)", f"z=atan({s}*{g})/2",
                         f"z=smoothstep(0,{num(1 / slope)},{g})", f"z=1/(1+exp(-{s}*{g}))", f"z={f}+0.4*tanh({s}*{g})",
                         f"z={g}/(abs({g})+{num(1 / slope)})", f"z=tanh({s}*{g})*tanh({s}*{self.line(1 / slope)})",
                         f"z=erf({s}*{g})*{f}+u", f"z=0.5*sin(3*u)+max(0,min(1,{s}*{g}))", f"z=u*tanh({s}*{g})")

    def poles(self):
        g, f, k = self.line(1e-2), self.smooth(), num(self.log(1e-4, 1))
        d, at = self.distance(power=True)
        return self.pick(f"z={k}/{g}", f"z={k}/{g}+{f}", f"z=tan({self.real(1, 4)}*u)*{self.pick('v', '0.2', 'v^2')}",
                         f"z={k}/{d}", f"z={self.line(1e-2)}/{g}", "z=u/v", f"z=(u+{self.real(0.2, 1)}*v)/(u-v)",
                         f"z={k}*ln(abs({g}))", f"z={k}/{g}^2", f"z={k}/abs({g})^0.5+{f}", f"z=1/(u*v)",
                         f"z={k}/sin({self.real(1, 5)}*u+v)", f"z=gamma({self.real(2, 4)}*u)*v", f"z={k}*tan(hypot(u,v)*3)",
                         f"z={k}/{g}*exp(v)")

    def scales(self):
        small = num(10.0 ** self.rng.randint(-9, 9), 1)
        f = self.smooth()
        offset = num(10.0 ** self.rng.randint(1, 6), 1)
        return self.pick([f"z={offset}+{f}"], [f"x={small}*u", f"y={small}*v", f"z={small}*({f})"],
                         [f"x={offset}+cos(u)*(2+cos(v))", "y=sin(u)*(2+cos(v))", f"z=sin(v)-{offset}", "u=0:tau", "v=0:tau"],
                         [f"x={small}*cos(v)*cos(u)", f"y={small}*cos(v)*sin(u)", f"z={small}*sin(v)", "u=0:tau", "v=-pi/2:pi/2"],
                         [f"x={small}*u", f"y={small}*v", f"z={small}*(u>{self.real(0, 0.5)}?1:v)"],
                         [f"z={small}*sin(u/{small})*cos(v/{small})", f"x=u", f"u=-3*{small}:3*{small}", f"v=-3*{small}:3*{small}"],
                         [f"z=({f})+u", f"u={offset}:{offset}+2"])

    def anisotropic(self):
        small, large = num(10.0 ** -self.rng.randint(1, 3), 1), num(10.0 ** self.rng.randint(1, 3), 1)
        f = self.smooth()
        return self.pick([f"z=sin(u/{small})+cos(v/{large})*0.3", f"u=-{small}:{small}", f"v=-{large}:{large}", f"x=u/{small}", f"y=v/{large}"],
                         [f"x={large}*u", f"z={f}"], [f"z={small}*sin(9*u)*v", f"y={large}*v"],
                         [f"z=sin(u)", f"u=0:{large}", f"v=0:{small}"], [f"z=exp(-u^2)*{large}", f"u=-{large}:{large}"],
                         [f"x=cos(u)*{small}", f"y=sin(u)*{small}", f"z=v", "u=0:tau", f"v=0:{large}"],
                         [f"z=sign(u-{self.real(0, 0.5)}*v)*{small}", f"x={large}*u"], [f"z=sqrt(u*v)", f"u=-{small}:{small}", f"v=0:{large}", f"x=u*{large}"],
                         [f"x={small}*u", f"z={f}", f"u=-{large}:{large}"], [f"z=tanh({large}*u)*{small}"])

    def sums(self):
        f = self.smooth(mild=False)
        waves = f"{self.real(0.02, 0.2)}*sin({self.real(6, 40, 3)}*u)*sin({self.real(6, 40, 3)}*v)"
        other = self.rng.choice(("jumps", "patches", "spikes", "ridges", "walls", "slots", "boundaries"))
        text = getattr(self, other)()
        return f"{text}" if "?" in text and "nan" in text else f"z=({text[2:]})+{self.pick(waves, f)}"

    def parametric(self):
        """A curved surface that carries a jump, a hole or a spike in its radius or a coordinate."""
        at = (round(self.rng.uniform(0.2, 0.8), 4), round(self.rng.uniform(0.2, 0.8), 4))
        base = self.pick(
            (["x={r}*cos(v)*cos(u)", "y={r}*cos(v)*sin(u)", "z={r}*sin(v)"], ("0", "2*pi"), ("-pi/2", "pi/2")),
            (["x=(2+{r}*cos(v))*cos(u)", "y=(2+{r}*cos(v))*sin(u)", "z={r}*sin(v)"], ("0", "2*pi"), ("0", "2*pi")),
            (["x={r}*cos(u)", "y={r}*sin(u)", "z=v"], ("0", "2*pi"), ("-1", "1")),
            (["x=v*cos(u)", "y=v*sin(u)", "z=0.3*u*{r}"], ("-4", "4"), ("0.2", "1.2")),
            (["x=u*{r}", "y=v", "z=u*v*{r}"], ("-1", "1"), ("-1", "1")),
            (["x=u", "y=v", "z={r}"], ("-2", "2"), ("-1", "3")))
        formulas, (u0, u1), (v0, v1) = base
        scope = {"pi": math.pi}
        a, b, c, d = (eval(end, scope) for end in (u0, u1, v0, v1))  # pylint: disable=eval-used
        u, v = round(a + at[0] * (b - a), 4), round(c + at[1] * (d - c), 4)
        size = self.log(0.003, 0.5)
        du, dv = self.shifted("u", u), self.shifted("v", v)
        self.hints.append(("point", u, v, size / max(b - a, d - c)))
        r, k = num(size), self.real(0.1, 0.5)
        inside = self.pick(f"hypot({du},{dv})<{r}", f"abs({du})<{r}", f"abs({dv})<{r}", f"max(abs({du}),abs({dv}))<{r}",
                           f"{du}>0", f"{dv}>{du}", f"hypot({du},{dv})<{r}&&{du}>0", f"{dv}>0.3*sin(3*{du})",
                           f"{du}^3>{dv}^2", f"sin(4*u)*sin(4*v)>0", f"abs({du}-0.4*{dv})<{r}")
        radius = self.pick(f"(1+{k}*({inside}))", f"(1+{k}*({inside}))", f"(({inside})?{k}:1)", f"(({inside})?nan:1)",
                           f"(1+{k}*exp(-({du}^2+{dv}^2)/{num(size)}^2))", f"(({inside})?1:nan)", "1",
                           f"(1+{k}*tanh({num(1 / size)}*{du}))")
        return [text.replace("{r}", radius) for text in formulas] + [f"u={u0}:{u1}", f"v={v0}:{v1}"]


def _bracket(text):
    return text if text.replace(".", "").isalnum() or text.startswith("(") and text.endswith(")") else f"({text})"
