"""Chromium for tests, driven through its DevTools protocol. Tests without it say so and are
skipped: exit status 77."""
import base64
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request

SKIPPED = 77
START_SECONDS = 60
FLAGS = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--hide-scrollbars", "--force-device-scale-factor=1", "--remote-debugging-port=0",
         "--remote-allow-origins=*", "--disable-background-networking", "--no-first-run",
         "--disable-component-update", "--disable-sync", "--disable-default-apps"]


def skip(what):
    print(f"SKIPPED: {what}", flush=True)
    sys.exit(SKIPPED)


class Browser:
    def __init__(self, *flags):
        program = shutil.which("chromium") or shutil.which("google-chrome")
        if not program:
            skip("no chromium; apt-get install chromium")
        try:
            import websocket
        except ImportError:
            skip("no Python module websocket; apt-get install python3-websocket")
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.process = subprocess.Popen(
            [program, *FLAGS, *flags, f"--user-data-dir={self.folder.name}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        port_file = pathlib.Path(self.folder.name) / "DevToolsActivePort"
        until = time.monotonic() + START_SECONDS
        while not (port_file.exists() and port_file.read_text().strip()):
            if time.monotonic() > until or self.process.poll() is not None:
                sys.exit("chromium does not start")
            time.sleep(0.05)
        port = port_file.read_text().split()[0]
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json") as answer:
            pages = [page for page in json.load(answer) if page["type"] == "page"]
        self.socket = websocket.create_connection(pages[0]["webSocketDebuggerUrl"], timeout=120)
        self.number = 0
        self.requests = []
        self.errors = []
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()  # processes of Chromium may outlive it, and write into the folder

    def take(self, message):
        method, details = message.get("method"), message.get("params", {})
        if method == "Network.requestWillBeSent":
            self.requests.append(details["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            self.errors.append(str(details["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and details["type"] in ("error", "assert"):
            self.errors.append(str(details["args"]))
        elif method == "Log.entryAdded" and details["entry"]["level"] == "error":
            self.errors.append(details["entry"]["text"])

    def call(self, method, **details):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": details}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("id") == self.number:
                if "error" in message:
                    sys.exit(f"{method}: {message['error']}")
                return message["result"]
            self.take(message)

    def value(self, expression):
        """What an expression of JavaScript gives, once its promise is kept."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            sys.exit(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def size(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def open(self, url):
        self.requests, self.errors = [], []
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=url)
        self.wait_for("document.readyState == 'complete'")

    def wait_for(self, condition, seconds=60):
        until = time.monotonic() + seconds
        while not self.value(condition):
            if time.monotonic() > until:
                sys.exit(f"not within {seconds} s: {condition}\n{self.errors}")
            time.sleep(0.05)

    def settle(self):
        """Until what was asked for is drawn, with all samples unless it plays."""
        self.value("""new Promise(done => {
            let looks = 0;
            const isFine = () => [...document.querySelectorAll('.saddle')].every(e => e.dataset.fine != 'false');
            const look = () => requestAnimationFrame(() => requestAnimationFrame(() =>
                isFine() || ++looks > 40 ? done() : setTimeout(look, 50)));
            setTimeout(look, 100);
        })""")

    def picture(self, clip=None):
        """A PNG of the page, or of a rectangle of it: x, y, width, height."""
        options = {"format": "png"}
        if clip:
            options["clip"] = dict(zip(("x", "y", "width", "height"), clip), scale=1)
        return base64.b64decode(self.call("Page.captureScreenshot", **options)["data"])

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def drag(self, start, end, steps=5, button="left"):
        buttons = {"left": 1, "right": 2}[button]
        self.mouse("mousePressed", *start, button=button, buttons=buttons, clickCount=1)
        for step in range(1, steps + 1):
            self.mouse("mouseMoved", *(a + (b - a) * step / steps for a, b in zip(start, end)),
                       button=button, buttons=buttons)
        self.mouse("mouseReleased", *end, button=button, clickCount=1)

    def key(self, key):
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=key if len(key) == 1 else "")
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)
