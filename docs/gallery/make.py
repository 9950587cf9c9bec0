#!/usr/bin/python3 -B
"""The gallery as one static page: a picture of each surface, and on a click the live surface in its
place. Nothing is loaded before it is seen. Usage: make.py PROGRAM FOLDER [--write] [NAME...]; --write
puts a table of the pages' sizes into README.md beside this file."""
import html
import pathlib
import re
import subprocess
import sys

SIZE = "640x480"
SIZES = pathlib.Path(__file__).with_name("README.md")
BEGIN = "<!-- begin: made by ./dev gallery --write -->\n"
END = "<!-- end -->"

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Surfaces that saddle knows</title>
<style>
body { font: 15px/1.4 system-ui, sans-serif; margin: 1em; background: #fff; color: #222; }
div { display: grid; grid-template-columns: repeat(auto-fill, minmax(280px, 1fr)); gap: 1em; }
figure { margin: 0; }
img, iframe { width: 100%; aspect-ratio: 4 / 3; border: 0; background: #000; display: block; }
button { padding: 0; border: 0; width: 100%; background: none; cursor: pointer; }
@media (prefers-color-scheme: dark) { body { background: #111; color: #ddd; } a { color: #9cf; } }
</style>
</head>
<body>
<main>
<h1>Surfaces that saddle knows</h1>
<p>A click on a picture makes it live: turn it, and move its parameters.</p>
<div>
FIGURES</div>
</main>
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


def meshes_in(page):
    """Bytes of a page that are its meshes."""
    return len(re.search(r'saddle-meshes">([^<]*)<', page.read_text(encoding="utf-8"))[1])


def table(rows):
    lines = ["| surface | page, kB | of it meshes, kB |\n| --- | ---: | ---: |\n"]
    lines += [f"| `{name}` | {size / 1000:.0f} | {meshes / 1000:.0f} |\n"
              for name, size, meshes in rows]
    sizes = sorted(size for _, size, _ in rows)
    lines += [f"| median | {sizes[len(sizes) // 2] / 1000:.0f} | |\n", f"| all | {sum(sizes) / 1000:.0f} | |\n"]
    return "".join(lines)


def write_table(rows):
    text = SIZES.read_text(encoding="utf-8")
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    SIZES.write_text(text[:begin] + "\n" + table(rows) + "\n" + text[end:], encoding="utf-8")


def main(program, folder, *wanted):
    writes, wanted = "--write" in wanted, [word for word in wanted if word != "--write"]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    listed = subprocess.run([program, "list", "-v"], capture_output=True, text=True, check=True).stdout
    figures, rows = "", []
    for line in listed.splitlines():
        name, _, description = line.strip().partition(" ")
        if not name or (wanted and name not in wanted):
            continue
        page = folder / f"{name}.html"
        subprocess.run([program, name, "-q", "--size", SIZE, "-o", page, "-o", page.with_suffix(".png")], check=True)
        rows.append((name, page.stat().st_size, meshes_in(page)))
        print(f"{name:24} {rows[-1][1] / 1000:7.1f} kB", flush=True)
        figures += FIGURE.format(name=name, description=html.escape(description.strip()))
    (folder / "index.html").write_text(PAGE.replace("FIGURES", figures), encoding="utf-8")
    print(f"{folder / 'index.html'}: {sum(size for _, size, _ in rows) / 1e6:.1f} MB of pages")
    if writes:
        write_table(rows)


main(*sys.argv[1:])
