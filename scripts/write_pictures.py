#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of docs/images with the commands that README.md and the guide print.

  scripts/write_pictures.py [--check] [--all] [NAME ...]

Each picture is a file that the commands of one page write. The commands run in a folder of their
own, from which `datasets` is seen. Without --all the script leaves out the pictures that need more
than the program: that of an experiment, that of a program with a new trimming method, and the
pictures of pages in a browser, which need chromium, playwright-core (both of scripts/setup.sh page,
and a build) and Pillow (which matplotlib needs).

  --check   writes nothing; exits with 1 if a picture differs from what the commands make. Those of
            a browser may differ in a few points, since letters depend on the fonts of the machine.
  --all     every picture
  NAME      only these pictures, such as plan.svg

The environment variable ENDMILL names the program (default: build/release/src/cli/endmill).
"""
import argparse
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs/images"
MODULES = ROOT / "build/release/tests/page_modules/node_modules"
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.DOTALL | re.MULTILINE)


@dataclass
class Picture:
    """A picture: the page whose commands make it, and the file among their results."""

    page: str
    file: str


PICTURES = {
    "plan.svg": Picture("README.md", "saddle/toolpath.svg"),
    "cad.svg": Picture("README.md", "mould/toolpath.svg"),
    "verify.svg": Picture("README.md", "checked/deviation.svg"),
    "trim.svg": Picture("README.md", "valley/methods-85.svg"),
    "feed.svg": Picture("README.md", "wavy-feed/feed.svg"),
    "setup.svg": Picture("README.md", "teapot/setup.svg"),
    "five-axes.svg": Picture("docs/guide/five-axes.md", "bump-plan/toolpath.svg"),
    "five-axes-setup.svg": Picture("docs/guide/five-axes.md", "bump-setup/setup.svg"),
    "post.svg": Picture("docs/guide/post.md", "post-path/toolpath.svg"),
}

@dataclass
class PagePicture:
    """A picture of what a browser shows: the page whose commands make the file, the file, and its tab.
    The tool stands at a share of the path, and a box is unchecked."""

    page: str
    file: str
    tab: str
    point: str = ""
    hidden: str = ""


VIEW = "docs/guide/view.md"
PAGE_PICTURES = {
    "page-plan.png": PagePicture(VIEW, "view-saddle/page.html", "cut"),
    "page-verify.png": PagePicture(VIEW, "view-checked/page.html", "cut", "0.05", "path"),
    "page-view.png": PagePicture(VIEW, "view-saddle.html", "cut", "0.6"),
    "page-trim.png": PagePicture(VIEW, "view-valley/page.html", "sections"),
    "page-feed.png": PagePicture(VIEW, "view-wavy-feed/page.html", "cut", "0.3"),
    "page-setup.png": PagePicture(VIEW, "view-teapot/page.html", "sphere"),
    "page-run.png": PagePicture(VIEW, "view-job/page.html", "cut", "0.5"),
}
COLOURS = 256  # of a picture of a page, so that its file stays small
MOST_DIFFERENT = 0.01  # share of the points of such a picture
CLEARLY = 48  # of 255: a difference of one colour

# Pictures that need more than the program: the command that makes one, and its file.
COSTLY = {
    "reproduce.svg": (["scripts/reproduce.sh", "--no-install", "economic-cl-data/figure-12"],
                      "results/economic-cl-data/figure-12/toolpath.svg"),
    "extend.svg": (["/usr/bin/python3", "tests/recipe/recipe_test.py", "--picture", "build/extend.svg"],
                   "build/extend.svg"),
}


def commands(page):
    """The commands of a page that run the program, lines that end in a backslash or && joined."""
    for block in BLOCK.findall((ROOT / page).read_text(encoding="utf-8")):
        for command in re.sub(r"\\\n|(?<=&&)\n", " ", block).splitlines():
            if command.startswith("endmill "):
                yield command


def folder_of(command):
    """The folders that a command writes to."""
    return re.findall(r"(?:-o|--output) (\S+)", command)


def needed_commands(page, folder):
    """The commands that make `folder`, in the order of the page: the first that writes to it, and those
    that write what it reads."""
    needed, wanted = [], {folder}
    for command in reversed(list(commands(page))):
        written = set(folder_of(command)) & wanted
        if written:
            needed.insert(0, command)
            wanted |= {word.split("/")[0] for word in command.split()}
    return needed


def run(command, folder, program):
    path = f"{program.parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(["bash", "-c", command], cwd=folder, capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL, env={**os.environ, "PATH": path})
    if done.returncode not in (0, 1):
        sys.exit(f"write_pictures.py: {command}\n{done.stdout}{done.stderr}")


def drawn_page(picture, folder):
    """The picture of a page in a browser, as a PNG file of few colours."""
    from PIL import Image  # only these pictures need it

    chromium, node = shutil.which("chromium"), shutil.which("node")
    if not chromium or not node or not MODULES.is_dir():
        sys.exit("write_pictures.py: pictures of pages need chromium, node and a build with the tests of the page")
    raw = folder / "page.png"
    done = subprocess.run([node, str(ROOT / "scripts/page_picture.mjs"), str(folder / picture.file), str(raw), picture.tab,
                           picture.point, picture.hidden], capture_output=True, text=True, check=False,
                          env={**os.environ, "CHROMIUM": chromium, "NODE_PATH": str(MODULES)})
    if done.returncode != 0:
        sys.exit(f"write_pictures.py: {picture.file}\n{done.stderr}")
    file = io.BytesIO()
    # of this method, so that colours of small areas remain
    few = Image.open(raw).convert("RGB").quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    few.save(file, "PNG", optimize=True)
    return file.getvalue()


def is_alike(kept, made, name):
    """Whether a picture is the kept one. Few points of a page may differ."""
    if kept == made or name not in PAGE_PICTURES:
        return kept == made
    from PIL import Image, ImageChops

    one, two = (Image.open(io.BytesIO(data)).convert("RGB") for data in (kept, made))
    if one.size != two.size:
        return False
    red, green, blue = ImageChops.difference(one, two).split()
    most = ImageChops.lighter(ImageChops.lighter(red, green), blue)
    return sum(most.histogram()[CLEARLY + 1:]) < MOST_DIFFERENT * one.width * one.height


def made_by_program(names, program):
    """Makes pictures by the program. Each command runs once for each page."""
    made = {}
    pictures = {**PICTURES, **PAGE_PICTURES}
    for page in sorted({pictures[name].page for name in names}):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "datasets").symlink_to(ROOT / "datasets")
            ran = set()
            for name in (name for name in names if pictures[name].page == page):
                file = pictures[name].file
                for command in needed_commands(page, file.split("/")[0]):
                    if command not in ran:
                        run(command, folder, program)
                        ran.add(command)
                made[name] = drawn_page(pictures[name], Path(folder)) if name in PAGE_PICTURES else \
                    (Path(folder) / file).read_bytes()
    return made


def made_at_cost(name):
    command, file = COSTLY[name]
    subprocess.run(command, cwd=ROOT, check=True, stdin=subprocess.DEVNULL)
    return (ROOT / file).read_bytes()


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args(arguments)
    every = {**PICTURES, **PAGE_PICTURES, **COSTLY}
    names = options.names or list(every if options.all else PICTURES)
    unknown = [name for name in names if name not in every]
    if unknown:
        parser.error(f"{unknown[0]}: expected one of {', '.join(every)}")

    program = Path(os.environ.get("ENDMILL", ROOT / "build/release/src/cli/endmill")).resolve()
    made = made_by_program([name for name in names if name not in COSTLY], program)
    made |= {name: made_at_cost(name) for name in names if name in COSTLY}
    is_same = is_alike if options.check else lambda kept, new, name: kept == new
    stale = [name for name in names
             if not (IMAGES / name).exists() or not is_same((IMAGES / name).read_bytes(), made[name], name)]
    bad = [f"docs/images/{path.name}: no command makes it" for path in sorted(IMAGES.glob("*.*g"))
           if path.name not in every]
    if options.check:
        bad += [f"docs/images/{name}: stale; run scripts/write_pictures.py {name}" for name in stale]
    else:
        for name in stale:
            (IMAGES / name).write_bytes(made[name])
            print(f"wrote docs/images/{name}")
    print("\n".join(bad) or f"{len(names)} pictures are those of the commands")
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
