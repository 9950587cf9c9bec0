#!/usr/bin/python3 -B
"""Faults on purpose: system calls that fail, signals, full disks, too little memory and too few
threads, a display that goes, random command lines, and input that would take for ever. Nothing may
be lost, left behind, silent or without a bound. ./dev faults runs it whole; `--short` is the part
that ./dev test has.

usage: faults.py SADDLE [--short] [--seed N] [--count N] [--only PART]..."""
import argparse
import concurrent.futures
import contextlib
import itertools
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.dom.minidom
import zipfile

import hostile

WORKERS = 2
HANG = 60  # seconds without any work of the processor, however busy the machine is
ENDLESS = 300  # seconds of the processor: the end of a run that takes 60 at the most
SMALL = ["torus", "-s", "64x64"]
LEFTOVER = re.compile(r"\.saddle-[a-z0-9]{8}$")
# What reaches a terminal has no others.
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")

# The calls that a run makes itself, and errors that the system may give for them.
CALLS = {"openat": "EMFILE", "write": "ENOSPC", "fsync": "EIO", "rename": "EACCES",
         "close": "EIO", "clone3": "EAGAIN", "flock": "ENOLCK", "unlink": "EPERM", "read": "EIO",
         "mmap": "ENOMEM", "newfstatat": "EIO", "getdents64": "EIO", "fchmod": "EPERM",
         "lseek": "EIO", "getrandom": "EAGAIN", "sched_getaffinity": "EPERM"}
# LLVM's code for pictures and Mesa's threads do not survive that mprotect fails alone. Nor does
# glibc that brk does, or the first mmap, of the dynamic linker.
MESH_CALLS = {**CALLS, "mprotect": "ENOMEM"}
FIRST = {"mmap": 2}
# Those that a film makes besides: with another program at the end of a pipe.
FILM_CALLS = {"pipe2": "EMFILE", "vfork": "EAGAIN", "waitid": "EINTR", "wait4": "EINTR",
              "dup2": "EBUSY", "ftruncate": "EIO", "pwrite64": "EIO", "write": "ENOSPC",
              "unlink": "EPERM", "execve": "ENOENT", "fcntl": "EINVAL"}
SIGNALS = ["TERM", "INT", "HUP", "QUIT", "KILL"]
FILMS = ["a.gif", "a.mp4"]
KILLED = ["a.png", "a.ply", "a.glb", "a.html", "a.svg", *FILMS]
# A chart has measured times in it, so that no two are the same: how each begins and ends.
CHARTS = {"chart.svg": (b"<?xml", b"</svg>\n\n"), "chart.csv": (b"panel,", b"\n")}
PAGE = 4096  # bytes: what a file in memory takes at a time
LOADER_STATUS = 127  # of the dynamic linker, before there is a program


def seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def shows_window(display):
    """Whether saddle's window is on a display."""
    search = ["xdotool", "search", "--onlyvisible", "--class", "saddle"]
    return subprocess.run(search, env={**os.environ, "DISPLAY": display}, check=False,
                          capture_output=True).returncode == 0


def ticks(pid):
    """Processor time of a process and of the children that it has waited for."""
    try:
        with open(f"/proc/{pid}/stat") as stat:
            return sum(int(number) for number in stat.read().rpartition(")")[2].split()[11:15])
    except OSError:  # it has just ended
        return 0


class Run:
    """A command that has ended: status (negative: a signal), err, processor seconds, bytes. `end`:
    a call that ends it, of its process, and the seconds after which it is made. `output`: the file
    that standard output goes to."""

    def __init__(self, words, folder, limit=None, environment=None, end=None, output=None):
        def prepare():
            for stop in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT):
                signal.signal(stop, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_CPU, (ENDLESS, ENDLESS))
            if limit:
                limit()

        env = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        env.update(environment or {})
        self.words = [str(word) for word in words]
        with open(output, "wb") if output else tempfile.TemporaryFile() as out, \
                tempfile.TemporaryFile() as err:
            child = subprocess.Popen(self.words, cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                     stderr=err, preexec_fn=prepare, env=env, process_group=0)
            try:
                self.status, usage = self.wait(child, end)
            except BaseException:
                os.killpg(child.pid, signal.SIGKILL)
                raise
            err.seek(0)
            self.out = ""
            if not output:
                out.seek(0)
                self.out = out.read().decode(errors="replace")
            self.err = err.read().decode(errors="replace")
        self.seconds = usage.ru_utime + usage.ru_stime
        self.bytes = usage.ru_maxrss * 1024

    def wait(self, child, end):
        begin = time.monotonic()
        worked, last_work = 0, begin
        while time.monotonic() < last_work + HANG:
            if end and time.monotonic() >= begin + end[1]:
                end[0](child.pid)
                end = None
            pid, status, usage = os.wait4(child.pid, os.WNOHANG)
            if pid:
                child.returncode = os.waitstatus_to_exitcode(status)
                return child.returncode, usage
            if ticks(child.pid) > worked:
                worked, last_work = ticks(child.pid), time.monotonic()
            time.sleep(0.01 if not end else 0.001)
        os.killpg(child.pid, signal.SIGKILL)  # strace and what it runs
        _, _, usage = os.wait4(child.pid, 0)
        child.returncode = -9
        return "hangs", usage


class Faults:
    def __init__(self, options):
        self.saddle = str(pathlib.Path(options.saddle).resolve())
        self.short = options.short
        self.seed = options.seed
        self.count = options.count
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="faults-"))
        self.failures = []
        self.counts = {}

    def folder(self):
        return pathlib.Path(tempfile.mkdtemp(dir=self.root))

    def all(self, part, check, cases):
        """Runs check(case), which returns what is wrong or None, for each of the cases."""
        cases = list(cases)
        with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
            for case, wrong in zip(cases, pool.map(check, cases)):
                if wrong:
                    self.failures.append((part, case, wrong))
        self.counts[part] = len(cases)

    # --- what a picture of SMALL must be, and its folder -----------------------------------------

    def reference(self):
        folder = self.folder()
        run = Run([self.saddle, *SMALL, "-o", "a.png"], folder)
        if run.status != 0:
            sys.exit(f"the program does not run: {run.err}")
        return (folder / "a.png").read_bytes()

    def wrong_picture(self, run, folder, whole, statuses, may_be_silent=False, name="a.png"):
        """What is wrong with a run that was to replace the file `name`, which was b"old". `whole`:
        the new file, or whether bytes are one."""
        if run.status not in statuses:
            return f"status {run.status}: {run.err[-300:]}"
        content = (folder / name).read_bytes() if (folder / name).exists() else b""
        is_new = whole(content) if callable(whole) else content == whole
        if content != b"old" and not is_new:
            return f"{name} is neither the old nor the new one"
        if run.status == 0 and not is_new:
            return "status 0, and the old file is there"
        if run.status == 1 and not run.err.strip() and not may_be_silent:
            return "status 1 without a word"
        names = {p.name for p in folder.iterdir()} - {name}
        return f"left behind: {names}" if names else None

    def small_picture(self):
        return [self.saddle, *SMALL, "-o", "a.png"]

    def replaced(self, prefix, limit=None, words=None):
        """A run whose last word is a file that is there, and the folder."""
        folder = self.folder()
        words = words or self.small_picture()
        (folder / words[-1]).write_bytes(b"old")
        return Run([*prefix, *words], folder, limit), folder

    def calls_of(self, names, words=None):
        """How often a thread of a run makes each call, at the most."""
        log = self.root / "calls"
        Run(["strace", "-f", "-qq", "-o", log, "-e", "trace=" + ",".join(names),
             *(words or self.small_picture())], self.folder())
        most = {}
        per_thread = {}
        for line in log.read_text(errors="replace").splitlines():
            match = re.match(r"(\d+) +(\w+)\(", line)
            if match:
                per_thread[match.groups()] = per_thread.get(match.groups(), 0) + 1
        for (_, name), count in per_thread.items():
            most[name] = max(most.get(name, 0), count)
        return most

    def injections(self, names, step, words=None):
        # Mesa waits for ever for a thread of its own that does not start. saddle tries before it
        # whether threads do (render/gl/mesa_room.cpp), so that no limit is met in Mesa: a call that
        # fails alone, after that, comes from no limit.
        processors = len(os.sched_getaffinity(0))
        tried = 2 * min(processors, 32) + processors + 4
        for name, count in self.calls_of(names, words).items():
            last = min(count, tried) if name == "clone3" else count
            for n in range(FIRST.get(name, 1), last + 1, step):
                yield name, n

    @contextlib.contextmanager
    def small_disk(self, pages):
        """A folder with room for so many pages."""
        folder = self.folder()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={pages * PAGE},nr_inodes=100", "tmpfs",
                        folder], check=True)
        try:
            yield folder
        finally:
            subprocess.run(["umount", "--lazy", folder], check=True)

    def can_mount(self):
        try:
            with self.small_disk(1):
                return True
        except (OSError, subprocess.CalledProcessError):
            return False

    @contextlib.contextmanager
    def display(self):
        """An X server of its own, and its name."""
        numbers, number = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(number), "-screen", "0", "1000x700x24",
                                   "-nolisten", "tcp"], pass_fds=[number],
                                  stderr=subprocess.DEVNULL)
        os.close(number)
        try:
            with open(numbers, encoding="ascii") as lines:
                yield server, ":" + lines.readline().strip()
        finally:
            server.kill()
            server.wait()

    def small_outputs(self):
        """Words of a small run for each kind of output, and the files."""
        small = [self.saddle, "z=sin(3*u+t)", "-s", "64x64", "-q"]
        words = {name: [*small, *(["--frames", "8"] if name in FILMS else []), "-o", name]
                 for name in KILLED}
        wholes = {}
        for name in KILLED:
            folder = self.folder()
            run = Run(words[name], folder)
            if run.status != 0:
                sys.exit(f"the program does not run: {run.err}")
            wholes[name] = (folder / name).read_bytes()
        for name, (begin, end) in CHARTS.items():
            words[name] = [self.saddle, "chart", "z=u*v", "-s", "16x16", "-q", "-o", name]
            wholes[name] = lambda content, begin=begin, end=end: \
                content.startswith(begin) and content.endswith(end)
        return words, wholes

    # --- the eight parts ---------------------------------------------------------------------------

    def calls(self):
        """Each system call fails once."""
        whole = self.reference()
        words, wholes = self.small_outputs()
        if not self.calls_of(["fsync"]).get("fsync"):
            self.failures.append(("calls", "fsync", "no file is flushed to the disk"))

        def check(case):
            output, name, n, error = case
            run, folder = self.replaced(
                ["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={name}", "-e",
                 f"inject={name}:error={error}:when={n}"], words=words[output])
            if run.status == LOADER_STATUS:
                return None
            if name == "unlink":  # what cannot be removed is left
                for path in folder.iterdir():
                    if LEFTOVER.search(path.name):
                        path.unlink()
            # The message itself may be what could not be written.
            return self.wrong_picture(run, folder, wholes[output], (0, 1), name == "write", output)

        cases = [(output, name, n, calls[name])
                 for output, calls in (("a.png", CALLS), ("a.ply", MESH_CALLS),
                                       ("a.gif", FILM_CALLS))
                 for name, n in self.injections(list(calls), 27 if self.short else 1, words[output])]
        self.all("calls", check, cases)

    def signals(self):
        """A signal at each system call."""
        words, wholes = self.small_outputs()
        names = ["openat", "write", "rename", "fsync", "flock", "close"]
        of_films = ["write", "rename", "fsync", "flock", "unlink", "pipe2", "ftruncate"]

        def check(case):
            kind, output, name, n = case
            run, folder = self.replaced(
                ["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={name}", "-e",
                 f"inject={name}:signal={kind}:when={n}"], words=words[output])
            left = [path for path in folder.iterdir() if LEFTOVER.search(path.name)]
            if kind == "KILL" and left:  # the next run removes it
                again = Run(words[output], folder)
                if again.status != 0:
                    return again.err
            ended = -getattr(signal, "SIG" + kind)
            statuses = (0, 1, ended) if output in FILMS else (0, ended)  # 1: ffmpeg was hit
            return self.wrong_picture(run, folder, wholes[output], statuses, name=output) \
                if run.status != 0 else None

        places = [(output, *place) for output, calls in (("a.png", names), ("a.ply", names),
                                                         ("a.gif", of_films))
                  for place in self.injections(calls, 1, words[output])]
        step = 24 if self.short else 1
        cases = [(kind, *place) for i, kind in enumerate(SIGNALS) for place in places[i::step]]
        self.all("signals", check, cases)

    def kills(self):
        """Signals at random moments, for each kind of output."""
        source = random.Random(self.seed)
        words, wholes = self.small_outputs()
        seconds = {}
        for name in KILLED if self.short else [*KILLED, *CHARTS]:
            begin = time.monotonic()
            Run(words[name], self.folder())
            seconds[name] = time.monotonic() - begin

        def check(case):
            name, kind, share = case
            number = getattr(signal, "SIG" + kind)
            folder = self.folder()
            (folder / name).write_bytes(b"old")
            run = Run(words[name], folder,
                      end=(lambda pid: os.kill(pid, number), share * seconds[name]))
            left = [path for path in folder.iterdir() if LEFTOVER.search(path.name)]
            if kind == "KILL" and left:  # the next run removes it
                run_again = Run(words[name], folder)
                if run_again.status != 0:
                    return run_again.err
            return self.wrong_picture(run, folder, wholes[name], (0, -number), name=name)

        def cases(names, count):
            return [(source.choice(names), source.choice(SIGNALS), 1.2 * source.random())
                    for _ in range(count)]

        count = self.count or (14 if self.short else 140)
        self.all("kills", check, cases(KILLED, count))
        if not self.short:
            self.all("killed charts", check, cases(list(CHARTS), (count + 9) // 10))

    def disk(self):
        """Disks with too little room, and a standard output that takes nothing."""
        words, wholes = self.small_outputs()
        tried = (0.5,) if self.short else (0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.5)

        def told(run):
            words_of_it = ("No space left", "is full")
            said = run.status == 0 or any(word in run.err for word in words_of_it)
            return None if said else run.err[-300:]

        def output(case):
            name, share = case
            # The old file has a page; a new one stands beside it until it is whole.
            with self.small_disk(2 + int(share * len(wholes[name]) / PAGE)) as folder:
                (folder / name).write_bytes(b"old")
                run = Run(words[name], folder)
                return self.wrong_picture(run, folder, wholes[name], (0, 1), name=name) or told(run)

        def temporary(case):
            name, pages = case
            folder = self.folder()
            (folder / name).write_bytes(b"old")
            with self.small_disk(pages) as small:
                run = Run(words[name], folder, environment={"TMPDIR": str(small)})
                left = [path.name for path in small.iterdir()]
                return self.wrong_picture(run, folder, wholes[name], (0, 1), name=name) or \
                    told(run) or left or None

        def stream(name):
            folder = self.folder()
            run = Run([*words[name][:-1], "-", "--format", name.partition(".")[2]], folder,
                      output="/dev/full")
            return f"status {run.status}" if run.status != 1 else told(run)

        if self.can_mount():
            self.all("full disks", output, itertools.product(KILLED, tried))
            cases = [(name, 1 + int(share * len(wholes[name]) / PAGE))
                     for name in FILMS for share in tried]
            self.all("full folders of temporaries", temporary,
                     cases + ([] if self.short else [("chart.svg", 1), ("chart.svg", 11)]))
        self.all("full streams", stream, KILLED)

    def window(self):
        """The display goes, or a signal comes, at random moments of a window."""
        source = random.Random(self.seed)
        if not (shutil.which("Xvfb") and shutil.which("xdotool")):
            print("window: left out, there is no Xvfb or xdotool")
            return

        def check(case):
            kind, seconds = case
            number = None if kind == "display" else getattr(signal, "SIG" + kind)
            folder = self.folder()
            statuses, words = [1], ["display"]

            def end(pid):
                if number:
                    os.kill(pid, number)
                    return
                # Before the window shows, X ends the program in its own words, or Mesa does without
                # any: it reads the number of an extension that a display which has gone never gave.
                if not shows_window(name):
                    words.extend(["X server", "X connection"])
                    statuses.append(-signal.SIGSEGV)
                server.kill()

            with self.display() as (server, name):
                run = Run([self.saddle, "torus"], folder,
                          environment={"DISPLAY": name, "XDG_STATE_HOME": str(folder),
                                       "LIBGL_ALWAYS_SOFTWARE": "1"},
                          end=(end, seconds))
            is_told = run.status == -number if number else run.status in statuses and (
                run.status != 1 or any(word in run.err for word in words))
            if not is_told:
                return f"status {run.status}: {run.err[-300:]}"
            left = [path.name for path in folder.iterdir()]
            return f"left behind: {left}" if left else None

        count = self.count or (2 if self.short else 20)
        kinds = ["display", *SIGNALS]
        self.all("windows", check, [(kinds[i % len(kinds)], 3 * source.random())
                                    for i in range(count)])

    def limits(self):
        """Too little memory, too few threads."""
        words, wholes = self.small_outputs()

        def memory(case):
            output, mebibytes = case

            def limit():
                resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20, mebibytes << 20))

            run, folder = self.replaced([], limit, words[output])
            if run.status == LOADER_STATUS:
                return None
            return self.wrong_picture(run, folder, wholes[output], (0, 1), name=output)

        def data(case):
            output, mebibytes = case
            command, *rest = words[output]
            # A mesh that was refined less is another one: with a warning, and so not written.
            limits = ["--max-memory", f"{mebibytes}MiB", "--strict"]
            run, folder = self.replaced([], None, [command, *limits, *rest])
            return self.wrong_picture(run, folder, wholes[output], (0, 1, 2), name=output)

        def threads(case):
            output, count = case
            user = 1_000_000 + os.getpid() * 1000 + 100 * KILLED.index(output) + count

            def limit():
                resource.setrlimit(resource.RLIMIT_NPROC, (count, count))
                os.setgid(user)
                os.setuid(user)

            folder = self.folder()
            os.chmod(self.root, 0o755)
            (folder / output).write_bytes(b"old")
            os.chown(folder, user, user)
            os.chown(folder / output, user, user)
            run = Run(words[output], folder, limit)
            return self.wrong_picture(run, folder, wholes[output], (0, 1), name=output)

        step = 40 if self.short else 4
        both = ["a.png", "a.ply"]
        spaces = [*itertools.product(both, range(40, 560, step)),
                  *itertools.product(["a.gif"], range(200, 700, 5 * step))]
        self.all("address space", memory, spaces)
        self.all("--max-memory", data, itertools.product(both, range(64, 400, step + 2)))
        if os.geteuid() == 0:
            outputs = ["a.png"] if self.short else ["a.png", "a.ply", *FILMS]
            self.all("threads", threads,
                     itertools.product(outputs, range(2, 17, 6 if self.short else 1)))

    def words(self):
        """Random command lines."""
        source = random.Random(self.seed)

        def check(words):
            folder = self.folder()
            (folder / "s.toml").write_text('[params]\na=1\n[[surface]]\nz="a*u*v"\n')
            run = Run([self.saddle, *words], folder)
            if run.status not in (0, 1, 2, 3):
                return f"status {run.status}: {run.err[-300:]}"
            if run.status != 0 and not run.err.strip():
                return "fails without a word"
            if CONTROL.search(run.err):
                return f"control characters: {run.err!r}"
            left = [p.name for p in folder.iterdir() if LEFTOVER.search(p.name)]
            if left:
                return f"left behind: {left}"
            outputs = [w for option, w in zip(words, words[1:]) if option == "-o"]
            missing = [w for w in outputs if "%" not in w and not (folder / w).exists()]
            if run.status == 0 and missing:
                return f"missing: {missing}"
            written = [w for w in outputs if (folder / w).exists()]
            return f"status {run.status}, with {written}" if run.status != 0 and written else None

        count = self.count or (40 if self.short else 500)
        self.all("words", check, hostile.command_lines(source, count))

    def corpus(self):
        """Input that would take for ever, or fool somebody; within seconds and bytes."""

        def check(case):
            folder = self.folder()
            for name, content in case.files().items():
                (folder / name).write_bytes(content)
            run = Run([self.saddle, *case.words], folder)
            if run.status not in case.statuses:
                return f"status {run.status}: {run.err[-300:]}"
            if run.seconds > case.seconds:
                return f"{run.seconds:.0f} s of a processor"
            if run.bytes > case.bytes:
                return f"{run.bytes / 1e6:.0f} MB"
            if case.says not in run.err:
                return f"does not say '{case.says}': {run.err[-300:]}"
            if CONTROL.search(run.err) or CONTROL.search(run.out):
                return "control characters reach the terminal"
            materials = {re.sub(r"obj$", "mtl", word) for word in case.words}  # of an OBJ file
            strangers = {p.name for p in folder.iterdir()} - set(case.files()) - set(case.words) \
                - materials
            if not self.short:
                print(f"  {run.seconds:6.1f} s {run.bytes / 1e6:6.0f} MB  {case.name}", flush=True)
            return f"wrote {strangers}" if strangers else None

        self.all("corpus", check, hostile.corpus(self.short))
        self.all("claims", lambda claim: claim(), [self.claim_of_calls, self.claim_of_names])
        if not self.short:
            self.all("films", self.film, ["a.gif", "a.mp4", "a.webm"])

    def claim_of_names(self):
        """Names of a scene are text in pages, figures and meshes, never a part of their code."""
        folder = self.folder()
        evil = "</script><script>alert(1)</script>]]>&\\nmap_Kd /etc/shells"
        (folder / "s.toml").write_text(f'title="{evil}"\n[[surface]]\nname="{evil}"\nz="u*v"\n')
        for name in ("a.html", "a.svg", "a.3mf", "a.obj"):
            run = Run([self.saddle, "s.toml", "-q", "-o", name], folder)
            if run.status != 0:
                return run.err
        model = zipfile.ZipFile(folder / "a.3mf").read("3D/3dmodel.model").decode()
        figure = (folder / "a.svg").read_text()
        for text in (model, figure):
            xml.dom.minidom.parseString(text)
        for text in (model, figure, (folder / "a.html").read_text()):
            if "<script>alert" in text:
                return "a script of a name"
        material = (folder / "a.mtl").read_text()
        return "a line of a name" if re.search("^ *map_Kd", material, re.MULTILINE) else None

    def claim_of_calls(self):
        """A picture takes no connection and no other program, and reads nothing that a scene names."""
        if not shutil.which("strace"):
            return None
        folder = self.folder()
        (folder / "s.toml").write_text('title="/etc/shells"\n[[surface]]\nname="/etc/shells"\nz="u"\n')
        log = folder / "log"
        Run(["strace", "-f", "-qq", "-o", log, "-e", "trace=%network,execve,openat", self.saddle,
             "s.toml", "-s", "32x32", "-o", "a.png"], folder)
        lines = log.read_text(errors="replace").splitlines()
        # The system's library asks its own daemon on this machine for the user's home.
        wrong = [line for line in lines if "/etc/shells" in line or "AF_UNIX" not in line and
                 re.search(r" (connect|socket|bind|sendto)\(", line)]
        programs = [line for line in lines if " execve(" in line]
        return str(wrong + programs[1:]) if wrong or len(programs) != 1 else None

    def film(self, name):
        folder = self.folder()
        contents = set()
        for threads in ("1", "2", "3", "4", "8"):
            run = Run([self.saddle, "z=sin(3*u+t)", "-s", "96x96", "--frames", "8", "--threads",
                       threads, "-o", name], folder)
            if run.status != 0:
                return run.err
            contents.add((folder / name).read_bytes())
        return None if len(contents) == 1 else f"{len(contents)} different files"


PARTS = ["calls", "signals", "kills", "disk", "limits", "window", "words", "corpus"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("saddle")
    parser.add_argument("--short", action="store_true", help="the part that ./dev test has")
    parser.add_argument("--seed", type=int, default=1, help="of the random cases")
    parser.add_argument("--count", type=int, help="of the random cases: of kills, windows and words")
    parser.add_argument("--only", action="append", choices=PARTS)
    options = parser.parse_args()
    faults = Faults(options)
    begin = time.monotonic()
    try:
        for part in options.only or PARTS:
            if part in ("calls", "signals") and not shutil.which("strace"):
                print(f"{part}: left out, there is no strace")
                continue
            before = seconds_of_children()
            getattr(faults, part)()
            print(f"{part}: {seconds_of_children() - before:.0f} s of a processor", flush=True)
    finally:
        shutil.rmtree(faults.root)
    for part, case, wrong in faults.failures:
        print(f"FAILED {part}: {case}: {wrong}")
    counts = ", ".join(f"{count} {part}" for part, count in faults.counts.items())
    print(f"{counts}; {len(faults.failures)} failed; {time.monotonic() - begin:.0f} s")
    return 1 if faults.failures else 0


if __name__ == "__main__":
    sys.exit(main())
