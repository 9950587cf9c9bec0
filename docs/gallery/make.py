#!/usr/bin/python3 -B
"""The gallery as one static page: a picture of each surface, and on a click the live surface in its
place. Nothing is loaded before it is seen. Usage: make.py PROGRAM FOLDER [NAME...]"""
import html
import pathlib
import subprocess
import sys

SIZE = "320x240"
LIVE_SIZE = "640x480"

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Surfaces that saddle knows</title>
<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 1em; background: #fff; color: #222; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(280px, 1fr)); gap: 1em; }
figure { margin: 0; }
img, iframe { width: 100%; aspect-ratio: 4 / 3; border: 0; background: #000; display: block; }
button { padding: 0; border: 0; width: 100%; background: none; cursor: pointer; }
@media (prefers-color-scheme: dark) { body { background: #111; color: #ddd; } a { color: #9cf; } }
</style>
</head>
<body>
<h1>Surfaces that saddle knows</h1>
<p>A click on a picture makes it live: turn it, and move its parameters.</p>
<main>
FIGURES</main>
<script>
for (const button of document.querySelectorAll('button')) {
  button.onclick = () => {
    const frame = document.createElement('iframe');
    frame.src = button.dataset.page;
    frame.title = button.dataset.page;
    button.replaceWith(frame);
  };
}
</script>
</body>
</html>
"""

FIGURE = """<figure>
<button type="button" data-page="{name}.html"><img src="{name}.png" alt="{name}" loading="lazy" width="320" height="240"></button>
<figcaption><a href="{name}.html">{name}</a> {description}</figcaption>
</figure>
"""


def main(program, folder, *wanted):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    listed = subprocess.run([program, "list", "-v"], capture_output=True, text=True, check=True).stdout
    figures, total = "", 0
    for line in listed.splitlines():
        name, _, description = line.strip().partition(" ")
        if not name or (wanted and name not in wanted):
            continue
        subprocess.run([program, name, "-q", "--size", SIZE, "-o", folder / f"{name}.png"], check=True)
        page = folder / f"{name}.html"
        subprocess.run([program, name, "-q", "--size", LIVE_SIZE, "-o", page], check=True)
        total += page.stat().st_size
        print(f"{name:24} {page.stat().st_size / 1000:7.1f} kB")
        figures += FIGURE.format(name=name, description=html.escape(description.strip()))
    (folder / "index.html").write_text(PAGE.replace("FIGURES", figures), encoding="utf-8")
    print(f"{folder / 'index.html'}: {total / 1e6:.1f} MB of pages")


main(*sys.argv[1:])
