#!/usr/bin/env python3
"""Opens a sample graph or comparison in MRPT's own viewers on a virtual screen and looks for its colours.

usage: viewers_test.py RawLogViewer|SceneViewer3D WRITE_SAMPLE PLUGIN OUT_DIR Graph|Comparison

Leaves OUT_DIR/<viewer><sample>.ppm, the last screenshot. Exit code 77 where a program is missing.
"""

import collections
import itertools
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
DEADLINE = time.monotonic() + 90  # for a busy machine; alone it takes a few seconds
SCREEN = (1280, 900)
LEAST_PIXELS = {"floor": 1500, "corridor": 30, "run": 200}  # by the first word of the name; for others:
LEAST_PIXELS_OF_A_VERTEX = 10


class Desk:
    """A virtual screen with one program on it."""

    def __init__(self, home):
        self.env = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_CACHE_HOME=home,
                        LIBGL_ALWAYS_SOFTWARE="1", NO_AT_BRIDGE="1", GDK_BACKEND="x11",
                        DBUS_SESSION_BUS_ADDRESS="disabled:")
        self.env.pop("WAYLAND_DISPLAY", None)
        read_end, write_end = os.pipe()
        width, height = SCREEN
        self.processes = [subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-nolisten", "tcp",
             "-screen", "0", f"{width}x{height}x24"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)]
        os.close(write_end)
        with os.fdopen(read_end) as answer:  # ends when the screen is ready, or when Xvfb ends
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb does not start")
        self.env["DISPLAY"] = ":" + number

    def start(self, command):
        self.processes.append(subprocess.Popen(command, env=self.env, stdin=subprocess.DEVNULL))

    def check_alive(self):
        if self.processes[-1].poll() is not None:
            raise RuntimeError(f"the viewer ended with code {self.processes[-1].returncode}")
        if time.monotonic() > DEADLINE:
            raise RuntimeError("out of time")

    def xdotool(self, *words):
        """What it prints, or "" where it fails, as it does for a window that has just closed."""
        done = subprocess.run(["xdotool", *map(str, words)], env=self.env, text=True, timeout=20,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return done.stdout if done.returncode == 0 else ""

    def windows(self, name):
        return self.xdotool("search", "--onlyvisible", "--name", name).split()

    def tidy(self):
        """Gives the main window all of the screen. The viewers change its size and greet with a tip
        some time after it is there, so this must be done again and again."""
        for tip in self.windows("Tip of the Day"):
            self.xdotool("windowfocus", tip, "key", "Escape")
        for window in self.windows("Part of the MRPT project")[:1]:
            place = self.xdotool("getwindowgeometry", window)
            if "Position: 0,0 " not in place or f"Geometry: {SCREEN[0]}x{SCREEN[1]}" not in place:
                self.xdotool("windowmove", window, 0, 0, "windowsize", window, *SCREEN)

    def screenshot(self):
        return subprocess.run(["import", "-silent", "-window", "root", "-depth", "8", "ppm:-"],
                              env=self.env, stdout=subprocess.PIPE, check=True, timeout=20).stdout

    def close(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(5)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def count_colors(ppm, colors):
    """How many pixels of a binary PPM have each colour."""
    body = ppm.split(b"\n", 3)[3]
    if not ppm.startswith(b"P6\n") or len(body) != 3 * SCREEN[0] * SCREEN[1]:
        raise RuntimeError("the screenshot is no PPM picture of the screen")
    counts = collections.Counter(struct.iter_unpack("3s", body))
    return {name: counts[(bytes(color),)] for name, color in colors.items()}


def is_enough(name, count):
    return count >= LEAST_PIXELS.get(name.split("_")[0], LEAST_PIXELS_OF_A_VERTEX)


def look(desk, colors, seconds, picture):
    """Counts until all colours are there or the time is over."""
    end = time.monotonic() + seconds
    while True:
        desk.check_alive()
        desk.tidy()
        ppm = desk.screenshot()
        picture.write_bytes(ppm)
        counts = count_colors(ppm, colors)
        if all(is_enough(*item) for item in counts.items()) or time.monotonic() > end:
            return counts
        time.sleep(0.2)


def show_in_rawlogviewer(desk, colors, picture):
    # Down the tree until the entry is hit: where it is depends on the fonts.
    for y in itertools.cycle(range(96, 180, 9)):  # look() ends it when the time is over
        counts = look(desk, colors, 0.5, picture)
        if any(counts.values()):
            return look(desk, colors, 20, picture)
        desk.xdotool("mousemove", 150, y, "click", 1)


def show_in_sceneviewer(desk, colors, picture):
    return look(desk, colors, 40, picture)


def run(viewer, write_sample, plugin, out_dir, sample, home):
    graph, scene = os.path.join(home, "sample.roomgraph"), os.path.join(home, "sample.3Dscene")
    lines = subprocess.run([write_sample, sample, graph, scene], check=True, text=True,
                           stdout=subprocess.PIPE).stdout.splitlines()
    colors = {line.split()[0]: tuple(map(int, line.split()[1:])) for line in lines}
    picture = pathlib.Path(out_dir) / f"{viewer}{sample}.ppm"
    desk = Desk(home)
    try:
        if viewer == "RawLogViewer":
            desk.start([viewer, "-l", plugin, graph])
            counts = show_in_rawlogviewer(desk, colors, picture)
        else:
            desk.start([viewer, scene])
            counts = show_in_sceneviewer(desk, colors, picture)
    finally:
        desk.close()
    missing = [name for name, count in counts.items() if not is_enough(name, count)]
    print(f"pixels of each colour in {picture}: {counts}")
    if missing:
        print("too few pixels of: " + ", ".join(missing))
    return 1 if missing else 0


def main():
    viewer = sys.argv[1]
    for program in ["Xvfb", "xdotool", "import", viewer]:
        if not shutil.which(program):
            print(f"skipped: {program} is not installed "
                  "(Debian: xvfb, xdotool, imagemagick, mrpt-apps)")
            return SKIPPED
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        return run(*sys.argv[1:], home)


if __name__ == "__main__":
    sys.exit(main())
