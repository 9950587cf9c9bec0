"""Surfaces with jumps inside of differences: thickened by hand, in the ways that people write it.
The normal is a quotient of differences of the formula itself, so that the surface turns beside each
of its jumps within a band as wide as the step of the differences."""
import corpus

SEED = 1
COUNT = 200
GRID_OFF = 0.2  # share of surfaces with that option
# Steps of differences, as people choose them.
STEPS = ("0.01", "1e-3", "1e-3", "1e-4", "1e-4", "1e-5", "1e-6")


def cases(seed, count):
    """The ways in turn."""
    made = []
    for number in range(count):
        way = WAYS[number % len(WAYS)]
        rng = corpus.random.Random(f"{seed}/thickened/{way}/{number // len(WAYS)}")
        maker = Maker(rng)
        formulas = getattr(maker, way)()
        options = ["--grid", "off"] if rng.random() < GRID_OFF else []
        made.append(corpus.Case(number, way, formulas, options, maker.hints))
    return made


class Maker(corpus.Maker):
    """One surface: a method for each way to thicken."""

    def __init__(self, rng):
        super().__init__(rng)
        self.step = self.pick(*STEPS)
        self.thickness = self.real(0.02, 0.25, 2)

    # --- parts ----------------------------------------------------------------------------------

    def place_of(self, low, high):
        return round(self.rng.uniform(low, high), self.pick(1, 2, 4))

    def curve(self, scale=1.0):
        """An expression of u and v, its zeros a line along a parameter, aslant or curved."""
        a, b = self.place_of(-0.6, 0.6), self.real(0.2, 0.8, 2)
        u, v = ("u", "v") if scale == 1.0 else (f"{scale:g}*u", f"{scale:g}*v")
        text = self.pick(self.shifted("u", a), self.shifted("v", a), "u", "v", f"u-{b}*v", f"v-{b}*sin(3*{u})",
                         f"u^2+v^2-{b}", f"sin(3*{u})*sin(2*{v})", f"u*v-{b}/4", f"sin({self.real(2, 6, 2)}*{v})",
                         f"cos({self.real(2, 6, 2)}*{u})")
        self.hints.append(("curve", text, float(self.step)))
        return text

    def factor(self):
        """About 1 to 1.5, with jumps or creases."""
        a, k = self.real(0.05, 0.4, 2), self.pick("2", "3", "4", self.real(1, 5, 2))
        g, f = self.curve(), self.smooth()
        return self.pick(
            f"1+{a}*floor({k}*u)/{k}", f"1+{a}*floor({k}*v)/{k}", f"1+{a}*sign({g})", f"1+{a}*({g}>0)",
            f"if({g}>0,1,1+{a})", f"({g}>0?1+{a}:1)", f"1+{a}*step(0,{g})", f"1+{a}*mod({k}*u,1)",
            f"1+{a}*mod({k}*u+v,1)", f"1+{a}*mod(floor({k}*u)+floor({k}*v),2)", f"1+{a}*abs({g})",
            f"1+max({a}*sin({k}*u),0)", f"1+{a}*min(1,abs({g}))", f"1+{a}*max(sin({k}*u),cos({k}*v))",
            f"1+{a}*round({k}*sin({k}*v))/{k}", f"1+{a}*abs(mod({k}*u,2)-1)",
            f"({g}>0?1+{a}*(0.3+{f}):1)", f"1+{a}*(sin({k}*u)*sin({k}*v)>0)", f"1+{a}*clamp({k}*({g}),0,1)")

    def height(self):
        a, k = self.real(0.1, 0.6, 2), self.pick("2", "3", self.real(1, 5, 2))
        g, f = self.curve(), self.smooth()
        return self.pick(
            f"floor({k}*u)/{k}", f"floor({k}*v)/{k}+{f}", f"{a}*sign({g})+{f}", f"{a}*sign({g})",
            f"({g}>0?{a}:{f})", f"if({g}>0,{f},{a}+{f})", f"{a}*step(0,{g})+0.1*u", f"{a}*mod({k}*u,1)",
            f"{a}*mod({k}*u+v,1)+{f}", f"{a}*mod(floor({k}*u)+floor({k}*v),2)", f"{a}*abs({g})",
            f"max({f},{a}*({g}))", f"min({a}*u,{f})", f"{a}*abs(u)-{a}*abs(v)", f"{a}*round({k}*hypot(u,v))",
            f"{a}*floor({k}*(u+v))/{k}", f"{a}*(sin({k}*u)*sin({k}*v)>0)+{f}", f"{a}*trunc({k}*u)*v",
            f"{a}*clamp({k}*({g}),0,1)+{f}", f"max(0,{a}*sign({g}))")

    def difference(self, name, along, arguments="u,v"):
        """A quotient of differences of a function, by u or v."""
        step = self.step_name
        plus = arguments.replace(along, f"{along}+{step}")
        minus = arguments.replace(along, f"{along}-{step}")
        return {"forward": f"({name}({plus})-{name}({arguments}))/{step}",
                "backward": f"({name}({arguments})-{name}({minus}))/{step}",
                "central": f"({name}({plus})-{name}({minus}))/(2*{step})"}[self.kind_of_difference]

    def begin(self):
        """Chooses how differences are taken; the definitions of step and thickness."""
        self.kind_of_difference = self.pick("forward", "forward", "backward", "central")
        self.step_name = self.pick("eps", "du", self.step)
        named = [] if self.step_name == self.step else [f"{self.step_name}={self.step}"]
        return [*named, f"T={self.thickness}"]

    def base(self, radius="r(u,v)"):
        """Definitions of X, Y and Z as functions of u and v, and their ranges."""
        turn = "u=0:2*pi"
        return self.pick(
            ([f"X(u,v)={radius}*cos(v)*cos(u)", f"Y(u,v)={radius}*cos(v)*sin(u)", f"Z(u,v)={radius}*sin(v)"], [turn, "v=-1.5:1.5"]),
            ([f"X(u,v)=(2+0.6*{radius}*cos(v))*cos(u)", f"Y(u,v)=(2+0.6*{radius}*cos(v))*sin(u)", f"Z(u,v)=0.6*{radius}*sin(v)"], [turn, "v=0:2*pi"]),
            ([f"X(u,v)={radius}*cos(u)", f"Y(u,v)={radius}*sin(u)", "Z(u,v)=v"], [turn, "v=-1:1"]),
            (["X(u,v)=v*cos(u)", "Y(u,v)=v*sin(u)", f"Z(u,v)=0.3*u*{radius}"], ["u=-3:3", "v=0.2:1.2"]),
            (["X(u,v)=u", f"Y(u,v)=v*{radius}", f"Z(u,v)={radius}"], []),
            ([f"X(u,v)={radius}*cosh(v)*cos(u)", f"Y(u,v)={radius}*cosh(v)*sin(u)", "Z(u,v)=v"], [turn, "v=-1:1"]),
            (["X(u,v)=(1+v*cos(u/2))*cos(u)", "Y(u,v)=(1+v*cos(u/2))*sin(u)", f"Z(u,v)=v*sin(u/2)+0.2*{radius}"], [turn, "v=-0.4:0.4"]))

    def normal(self, arguments="u,v"):
        """The normal's definitions n1, n2, n3 and its length R, by differences of X, Y and Z."""
        lines = [f"{c}{p}={self.difference(c, p)}" for c in "XYZ" for p in "uv"]
        if arguments == "functions":
            lines = [line.replace("=", "(u,v)=", 1) for line in lines]
            call = "(u,v)"
            lines += [f"n1(u,v)=Yu{call}*Zv{call}-Zu{call}*Yv{call}", f"n2(u,v)=Zu{call}*Xv{call}-Xu{call}*Zv{call}",
                      f"n3(u,v)=Xu{call}*Yv{call}-Yu{call}*Xv{call}",
                      "R(u,v)=sqrt(n1(u,v)^2+n2(u,v)^2+n3(u,v)^2)"]
            return lines
        return lines + ["n1=Yu*Zv-Zu*Yv", "n2=Zu*Xv-Xu*Zv", "n3=Xu*Yv-Yu*Xv", "R=sqrt(n1^2+n2^2+n3^2)"]

    # --- ways -----------------------------------------------------------------------------------

    def height_field(self):
        """A height field moved along its normal."""
        lines = self.begin()
        sign = self.pick("+", "+", "-")
        other = "-" if sign == "+" else "+"
        return [*lines, f"h(u,v)={self.height()}", f"hu={self.difference('h', 'u')}",
                f"hv={self.difference('h', 'v')}", "n=sqrt(1+hu^2+hv^2)", f"x=u{other}T*hu/n", f"y=v{other}T*hv/n",
                f"z=h(u,v){sign}T/n"]

    def shell(self):
        """A parametric surface moved along the product of two differences."""
        lines, (base, ranges) = self.begin(), self.base()
        sign = self.pick("+", "-")
        return [*lines, f"r(u,v)={self.factor()}", *base, *self.normal(),
                *(f"{c.lower()}={c}(u,v){sign}T*n{k}/R" for k, c in enumerate("XYZ", 1)), *ranges]

    def double_wall(self):
        """Front and back as one surface: the second half of v goes back on the other side."""
        lines, (base, ranges) = self.begin(), self.base()
        v = next((text for text in ranges if text.startswith("v=")), "v=-1:1")[2:].split(":")
        ranges = [text for text in ranges if not text.startswith("v=")]
        back = self.pick("w=v<1?v:2-v", "w=1-abs(v-1)", "w=min(v,2-v)")
        side = self.pick("side=v<1?1:-1", "side=sign(1-v)", "side=1-2*step(1,v)", "side=if(v<1,1,-1)")
        low, high = v
        return [*lines, f"r(u,v)={self.factor()}", *base, *self.normal("functions"), back, side,
                f"q={low}+({high}-({low}))*w",
                *(f"{c.lower()}={c}(u,q)+side*T/2*n{k}(u,q)/R(u,q)" for k, c in enumerate("XYZ", 1)), *ranges, "v=0:2"]

    def profile(self):
        """Front, rim, back and rim of a height field by the whole part of v."""
        lines = self.begin()
        along = self.pick("q=k==0?v:(k==1?1:(k==2?3-v:0))", "q=if(k<1,v,if(k<2,1,if(k<3,3-v,0)))",
                          "q=clamp(v<2?v:3-v,0,1)")
        offset = self.pick("s=k==0?1:(k==1?3-2*v:(k==2?-1:2*v-7))", "s=clamp(v<2.5?3-2*v:2*v-7,-1,1)")
        return [*lines, f"h(u,v)={self.height()}", "k=floor(v)", along, offset,
                f"hu={self.difference('h', 'u', 'u,q')}", f"hq={self.difference('h', 'q', 'u,q')}",
                "n=sqrt(1+hu^2+hq^2)", "x=u-s*T*hu/n", "y=q-s*T*hq/n", "z=h(u,q)+s*T/n", "v=0:4"]

    def windows(self):
        """A thickness that a pattern of conditions turns on and off."""
        lines, (base, ranges) = self.begin(), self.base("1")
        k, m = self.real(0.6, 3, 2), self.real(0.6, 3, 2)
        pattern = self.pick(f"mod({k}*u,1)<0.5&&mod({m}*v,1)<0.5", f"{k}*u-floor({k}*u)<0.4", f"sin({k}*2*u)*sin({m}*2*v)>0",
                            f"abs(mod({k}*u,1)-0.5)<0.2", f"mod(floor({k}*u)+floor({m}*v),2)==1", f"({self.curve()})>0")
        value = self.pick(f"W(u,v)=({pattern})?T:0", f"W(u,v)=if({pattern},T,-T/2)", f"W(u,v)=T*({pattern})")
        # The cut surface is differentiated a second time, as for its edges.
        again = self.rng.random() < 0.6
        offset = [f"{c}W(u,v)={c}(u,v)+W(u,v)*n{k}(u,v)/R(u,v)" for k, c in enumerate("XYZ", 1)]
        if not again:
            return [*lines, value, *base, *self.normal("functions"), *offset,
                    *(f"{c.lower()}={c}W(u,v)" for c in "XYZ"), *ranges]
        slopes = [f"{c}{p}W={self.difference(c + 'W', p)}" for c in "XYZ" for p in "uv"]
        return [*lines, value, *base, *self.normal("functions"), *offset, *slopes,
                "m1=YuW*ZvW-ZuW*YvW", "m2=ZuW*XvW-XuW*ZvW", "m3=XuW*YvW-YuW*XvW", "M=sqrt(m1^2+m2^2+m3^2)",
                *(f"{c.lower()}={c}W(u,v)+T/2*m{k}/M" for k, c in enumerate("XYZ", 1)), *ranges]

    def ribbon(self):
        """A plane curve with steps, thickened along its normal by v, and raised."""
        lines = self.begin()
        a, k = self.real(0.1, 0.5, 2), self.pick("2", "3", "5")
        g = self.pick(f"1+{a}*floor({k}*u)/{k}", f"1+{a}*sign(sin({k}*u))", f"1+{a}*(mod(u,1)<0.5)", f"1+{a}*mod({k}*u/3,1)",
                      f"1+{a}*abs(sin({k}*u))", f"1+{a}*max(0,cos({k}*u))", f"1+{a}*step(0,cos({k}*u))",
                      f"(cos({k}*u)>0.3?1+{a}:1)")
        cx, cy, ends = self.pick(("c(u)*cos(u)", "c(u)*sin(u)", "u=0:2*pi"), ("u", "c(u)", "u=-2:2"))
        step = self.step_name
        ahead, behind, width = {"forward": (f"u+{step}", "u", step), "backward": ("u", f"u-{step}", step),
                                "central": (f"u+{step}", f"u-{step}", f"(2*{step})")}[self.kind_of_difference]
        return [*lines, f"c(u)={g}", f"A(u)={cx}", f"B(u)={cy}", f"p=(A({ahead})-A({behind}))/{width}",
                f"q=(B({ahead})-B({behind}))/{width}", "L=hypot(p,q)", "x=A(u)-T*v*q/L", "y=B(u)+T*v*p/L",
                f"z={self.pick('0.2*u', '0.3*sin(2*u)', 'v/2', '0.1*u+0.3*v*v')}", ends]

    def edges(self):
        """Edges of a condition, found where it differs from its neighbours, are raised."""
        lines, (base, ranges) = self.begin(), self.base("r")
        g, step, f = self.curve(), self.step_name, self.smooth()
        condition = f"c(u,v)={self.pick(f'({g})>0', f'sign({g})', f'({g}<0?0:1)', f'step(0,{g})')}"
        edge = self.pick(f"edge=abs(c(u+{step},v)-c(u,v))+abs(c(u,v+{step})-c(u,v))>0",
                         f"edge=c(u+{step},v)!=c(u-{step},v)||c(u,v+{step})!=c(u,v-{step})",
                         f"edge=min(1,abs(c(u+{step},v+{step})-c(u-{step},v-{step})))",
                         f"edge=c(u+{step},v)!=c(u,v)?1:0")
        if self.rng.random() < 0.5:
            return [*lines, condition, edge, f"z={f}+{self.pick('T*edge', '(edge>0?T:0)', 'T*edge+0.1*c(u,v)')}"]
        lines += [condition, edge, f"r=1+{self.pick('T*edge', '(edge>0?T:0)', 'T*edge+0.2*c(u,v)')}"]
        return [*lines, *(text.replace("(u,v)=", "=", 1).lower() for text in base), *ranges]

    def one_sided(self):
        """Height fields whose slope along one parameter alone is taken, or is not made a unit."""
        lines = self.begin()
        slope = self.difference("h", self.pick("u", "v"))
        return self.pick(
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "z=h(u,v)+T/sqrt(1+s^2)"],
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "z=h(u,v)+T*s/sqrt(1+s*s)"],
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "x=u-T*s/sqrt(1+s^2)", "z=h(u,v)+T/sqrt(1+s^2)"],
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "z=h(u,v)+T*atan(s)"],
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "z=h(u,v)+T*sign(s)"],
            [*lines, f"h(u,v)={self.height()}", f"s={slope}", "z=abs(s)>1?h(u,v)-T:h(u,v)+T"])


WAYS = ("height_field", "shell", "double_wall", "profile", "windows", "ribbon", "edges", "one_sided")
