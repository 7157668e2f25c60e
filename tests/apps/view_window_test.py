#!/usr/bin/env python3
"""Opens roomgraph-view on a virtual screen, presses keys, clicks, and looks at what it draws.

usage: view_window_test.py ROOMGRAPH_VIEW MAPS_DIR VIEWERS_TEST OUT_DIR

Leaves OUT_DIR/roomgraph-view-*.ppm, the last screenshots. Exit code 77 where a program is missing.
"""

import collections
import importlib.util
import pathlib
import shutil
import struct
import sys
import tempfile
import time

SKIPPED = 77
SWATCH = 12 * 12  # pixels of the colour of a run behind its name
COLORS = {"scan": (200, 30, 30), "untorn": (0, 130, 90), "before": (0, 82, 155),
          "text": (30, 34, 40), "ruler": (110, 60, 150), "read": (230, 0, 120),
          "vertex": (0, 110, 82), "line": (20, 20, 20),
          "flag": (150, 20, 80), "best": (0, 114, 178), "torn": (0, 158, 115),
          "orange": (213, 94, 0), "heat": (217, 95, 14)}
LEFT_HALF = "left half"


def desk_module(path):
    spec = importlib.util.spec_from_file_location("viewers", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def count_left(ppm, screen, colors):
    """The same as count_colors, of what lies left of the middle."""
    body, width = ppm.split(b"\n", 3)[3], 3 * screen[0]
    rows = (body[y * width:y * width + width // 2] for y in range(screen[1]))
    counts = collections.Counter(struct.iter_unpack("3s", b"".join(rows)))
    return {name: counts[(bytes(color),)] for name, color in colors.items()}


class Viewer:
    """The program on its screen."""

    def __init__(self, viewers, home, command, picture):
        self.viewers, self.picture = viewers, picture
        self.desk = viewers.Desk(home)
        self.desk.start(command)

    def counts(self):
        ppm = self.desk.screenshot()
        self.picture.write_bytes(ppm)
        counts = self.viewers.count_colors(ppm, COLORS)
        counts[LEFT_HALF] = count_left(ppm, self.viewers.SCREEN, COLORS)
        return counts

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

    def drag(self, x, y, to_x, to_y):
        self.desk.xdotool("mousemove", x, y, "mousedown", 1)
        self.desk.xdotool("mousemove", (x + to_x) // 2, (y + to_y) // 2)
        self.desk.xdotool("mousemove", to_x, to_y, "mouseup", 1)

    def ends_well(self):
        """The first Escape ends what was begun, the second one the program."""
        self.press("Escape", "Escape")
        return self.desk.processes[-1].wait(20) == 0


def walk_one_run(viewer):
    first = viewer.wait("the scan of the first key frame", lambda c: c["scan"] > 100)
    viewer.press("Up", "Up")
    viewer.press("g")
    viewer.wait("all that was seen so far, and no map",
                lambda c: c["scan"] > 1.5 * first["scan"] and c["vertex"] == 0)
    viewer.click(1270, 835)  # the end of the time line
    viewer.wait("all that was seen at all", lambda c: c["scan"] > 3 * first["scan"])
    viewer.press("g")
    before = viewer.wait("the map again", lambda c: c["text"] > 100 and c["vertex"] > 100)
    viewer.click(640, 400)
    viewer.wait("the room that was clicked",
                lambda c: c["text"] > before["text"] + 40 and c["read"] > 50)


def step_through_stages(viewer):
    viewer.wait("the graph", lambda c: c["vertex"] > 100)
    viewer.press("x", "x")
    viewer.wait("the sites", lambda c: c["orange"] > 3000 and c["vertex"] == 0)
    viewer.press("Escape")
    viewer.wait("the graph again", lambda c: c["vertex"] > 100)


def measure(viewer):
    viewer.press("m")
    viewer.click(500, 700)
    viewer.click(900, 700)
    viewer.wait("the line that is measured", lambda c: c["ruler"] > 300)
    viewer.press("BackSpace")
    viewer.wait("its first corner", lambda c: 0 < c["ruler"] < 300)
    viewer.press("m")
    viewer.wait("nothing measured", lambda c: c["ruler"] == 0)


def move_a_slider(viewer):
    before = viewer.wait("the rooms", lambda c: c["vertex"] > 100)
    viewer.drag(27, 411, 190, 411)  # alpha, from 0 up
    viewer.wait("other ways into the rooms", lambda c: abs(c["orange"] - before["orange"]) > 0.1 * before["orange"])


def look_at_one_map(viewer):
    walk_one_run(viewer)
    step_through_stages(viewer)
    measure(viewer)
    move_a_slider(viewer)


def find_break(viewer):
    viewer.wait("the runs", lambda c: c["best"] > 1000 and c["text"] > 100 and c["untorn"] < 50)
    viewer.press("b")
    alone = viewer.wait("the torn piece, its flag on the time line, and faint walls",
                        lambda c: c["untorn"] > 500 and c["before"] > 500 and c["flag"] > 20
                        and c["best"] < 1000)
    viewer.press("o")
    viewer.wait("what the best run shows there", lambda c: c["best"] > alone["best"] + 3000)
    viewer.press("o")
    viewer.wait("what the second run shows there",
                lambda c: c["orange"] > alone["orange"] + 3000)
    viewer.press("Escape", "Home")


def swipe(viewer):
    viewer.press("w")
    viewer.wait("one run on each side", lambda c: c["line"] > 2000 and
                c[LEFT_HALF]["torn"] > 500 and SWATCH <= c[LEFT_HALF]["best"] < SWATCH + 20)
    viewer.drag(640, 600, 300, 600)
    viewer.wait("less of the one", lambda c: c[LEFT_HALF]["best"] > 500)
    viewer.press("w")
    viewer.wait("no line", lambda c: c["line"] < 2000)


def disagreement(viewer):
    viewer.press("d")
    viewer.wait("where the runs disagree", lambda c: c["heat"] > 200)
    viewer.press("d")
    viewer.wait("no disagreement", lambda c: c["heat"] == 0)


def nudge(viewer):
    viewer.press("n", *["Right"] * 8)
    viewer.wait("the run beside the other", lambda c: c["torn"] > 500)
    before = viewer.counts()
    viewer.press("Return")
    viewer.wait("the run on the other again", lambda c: c["torn"] < before["torn"])


def compare_runs(viewer):
    find_break(viewer)
    swipe(viewer)
    disagreement(viewer)
    nudge(viewer)


def write_large_map(path):
    """Rooms of 5 m with doors, 4000 cells wide and high: it takes a while to read."""
    side, room = 4000, 100
    wall = bytes(0 if 40 <= x % room < 60 else 1 for x in range(side))  # 1 where wall is, but in doors
    rows = []
    for y in range(side):
        isDoor = 40 <= y % room < 60
        rows.append(bytes(0 if (y % room == 0 and wall[x]) or (x % room == 0 and not isDoor) else 254
                          for x in range(side)))
    path.write_bytes(b"P5 %d %d 255\n" % (side, side) + b"".join(rows))


def wait_for_what_takes_long(viewers, program, out):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
        large = pathlib.Path(home) / "large.pgm"
        write_large_map(large)
        viewer = Viewer(viewers, home, [program, str(large)],
                        pathlib.Path(out) / "roomgraph-view-large.ppm")
        try:
            viewer.wait("what is being read", lambda c: c["text"] > 30 and c["vertex"] == 0)
            viewer.wait("the map", lambda c: c["vertex"] > 100)
            if not viewer.ends_well():
                raise RuntimeError("Escape does not end it well")
            viewer.desk.start([program, home + "/missing.simplemap", home + "/none.simplemap"])
            if viewer.desk.processes[-1].wait(20) != 1:
                raise RuntimeError("what cannot be read does not end it with 1")
        finally:
            viewer.desk.close()


def main():
    program, maps, viewers_test, out = sys.argv[1:]
    for tool in ["Xvfb", "xdotool", "import"]:
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed (Debian: xvfb, xdotool, imagemagick)")
            return SKIPPED
    viewers = desk_module(viewers_test)
    runs = [f"{maps}/office_run{i}.simplemap.gz" for i in (1, 2, 4)]
    for name, files, look in [("run", runs[2:], look_at_one_map), ("runs", runs, compare_runs)]:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as home:
            viewer = Viewer(viewers, home, [program, *files],
                            pathlib.Path(out) / f"roomgraph-view-{name}.ppm")
            try:
                look(viewer)
                if not viewer.ends_well():
                    raise RuntimeError("Escape does not end it well")
            finally:
                viewer.desk.close()
    wait_for_what_takes_long(viewers, program, out)
    return 0


sys.exit(main())
