#!/usr/bin/env python3
"""Opens roomgraph-view on a virtual screen, presses keys, clicks, and looks at what it draws.

usage: view_window_test.py ROOMGRAPH_VIEW MAPS_DIR VIEWERS_TEST OUT_DIR

Leaves OUT_DIR/roomgraph-view-*.ppm, the last screenshots. Exit code 77 where a program is missing.
"""

import importlib.util
import pathlib
import shutil
import sys
import tempfile
import time

SKIPPED = 77
COLORS = {"scan": (200, 30, 30), "untorn": (0, 130, 90), "before": (0, 82, 155),
          "text": (30, 34, 40)}


def desk_module(path):
    spec = importlib.util.spec_from_file_location("viewers", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Viewer:
    """The program on its screen."""

    def __init__(self, viewers, home, command, picture):
        self.viewers, self.picture = viewers, picture
        self.desk = viewers.Desk(home)
        self.desk.start(command)

    def counts(self):
        ppm = self.desk.screenshot()
        self.picture.write_bytes(ppm)
        return self.viewers.count_colors(ppm, COLORS)

    def wait(self, what, is_right):
        """Looks until it is right; fails where that takes too long."""
        end = time.monotonic() + 40
        counts = {}
        while time.monotonic() < end:
            self.desk.check_alive()
            counts = self.counts()
            if is_right(counts):
                print(f"{what}: {counts}")
                return counts
            time.sleep(0.1)
        raise RuntimeError(f"{what}: not seen, but {counts}")

    def press(self, *keys):
        window = self.desk.windows("roomgraph-view")[0]
        self.desk.xdotool("windowfocus", window, "key", *keys)

    def click(self, x, y):
        self.desk.xdotool("mousemove", x, y, "click", 1)

    def ends_well(self):
        self.press("Escape")
        return self.desk.processes[-1].wait(20) == 0


def walk_one_run(viewer):
    first = viewer.wait("the scan of the first key frame", lambda c: c["scan"] > 100)
    viewer.press("Up", "Up")
    viewer.press("g")
    viewer.wait("all that was seen so far", lambda c: c["scan"] > 1.5 * first["scan"])
    before = viewer.wait("before the click", lambda c: c["text"] > 100)
    viewer.click(700, 300)
    viewer.wait("what is there", lambda c: c["text"] > before["text"] + 40)


def find_break(viewer):
    viewer.wait("the runs", lambda c: c["text"] > 100 and c["untorn"] < 50)
    viewer.press("b")
    viewer.wait("the torn piece", lambda c: c["untorn"] > 500 and c["before"] > 500)


def main():
    program, maps, viewers_test, out = sys.argv[1:]
    for tool in ["Xvfb", "xdotool", "import"]:
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed (Debian: xvfb, xdotool, imagemagick)")
            return SKIPPED
    viewers = desk_module(viewers_test)
    runs = [f"{maps}/office_run{i}.simplemap.gz" for i in (1, 2, 4)]
    for name, files, look in [("run", runs[2:], walk_one_run), ("runs", runs, find_break)]:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
            viewer = Viewer(viewers, home, [program, *files],
                            pathlib.Path(out) / f"roomgraph-view-{name}.ppm")
            try:
                look(viewer)
                if not viewer.ends_well():
                    raise RuntimeError("Escape does not end it well")
            finally:
                viewer.desk.close()
    return 0


sys.exit(main())
