"""report_in_browser_test.py WRITE_SAMPLE_REPORT FOLDER: opens a report in a headless Chromium from
the disk, as a user does, and works with it by mouse and keyboard. Exits with 77 without Chromium.
Talks to the browser through two pipes (--remote-debugging-pipe): JSON, ended by a zero byte."""
import base64
import collections
import contextlib
import csv
import json
import os
import pathlib
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

TIMEOUT = 60


class Browser:
    def __init__(self, program, profile):
        to_read, self._write = os.pipe()
        self._read, to_write = os.pipe()

        def wire():  # the browser reads commands from 3 and writes answers to 4
            low = os.dup(to_read), os.dup(to_write)
            os.dup2(low[0], 3)
            os.dup2(low[1], 4)

        # High numbers, so that 3 and 4 are free.
        self._process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--no-first-run", "--disable-background-networking", "--remote-debugging-pipe",
             "--user-data-dir=" + profile, "about:blank"],
            preexec_fn=wire, close_fds=False,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self._buffer, self._last, self._session = b"", 0, None
        self.events = []

    def attach(self):
        targets = self.ask("Target.getTargets")["targetInfos"]
        page = next(t for t in targets if t["type"] == "page")
        self._session = self.ask("Target.attachToTarget",
                                 {"targetId": page["targetId"], "flatten": True})["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.ask(domain + ".enable")

    def ask(self, method, parameters=None):
        self._last += 1
        message = {"id": self._last, "method": method, "params": parameters or {}}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive()
            if answer.get("id") == self._last:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def _receive(self, timeout=TIMEOUT):
        """The next message; events are kept, too."""
        end = time.monotonic() + timeout
        while b"\0" not in self._buffer:
            if not select.select([self._read], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            data = os.read(self._read, 1 << 20)
            if not data:
                raise RuntimeError("the browser has ended")
            self._buffer += data
        line, self._buffer = self._buffer.split(b"\0", 1)
        message = json.loads(line)
        if "method" in message:
            self.events.append(message)
        return message

    def open(self, url):
        """Anew, also where only what follows the # of the address differs."""
        for to, is_there in (("about:blank", "true"),
                             (url, "!!document.querySelector('.leaflet-pane')")):
            self.ask("Page.navigate", {"url": to})
            self.wait("document.readyState === 'complete' && " + is_there)

    def value(self, expression):
        result = self.ask("Runtime.evaluate", {"expression": expression, "returnByValue": True})
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def count(self, selector):
        return self.value(f"document.querySelectorAll('{selector}').length")

    def wait(self, expression):
        end = time.monotonic() + TIMEOUT
        while not self.value(expression):
            if time.monotonic() > end:
                raise TimeoutError(expression)
            time.sleep(0.05)

    def click(self, x, y):
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent",
                     {"type": kind, "x": x, "y": y, "button": "left", "clickCount": 1})

    def drag(self, x, y, to_x, to_y):
        for kind, at in (("mouseMoved", (x, y)), ("mousePressed", (x, y)),
                         ("mouseMoved", (to_x, to_y)), ("mouseReleased", (to_x, to_y))):
            self.ask("Input.dispatchMouseEvent", {"type": kind, "x": at[0], "y": at[1],
                                                  "button": "left", "buttons": 1, "clickCount": 1})

    def settle(self):
        """Waits until the page has been drawn as it is now."""
        self.ask("Runtime.evaluate", {"awaitPromise": True, "expression":
                 "new Promise(r => requestAnimationFrame(() => requestAnimationFrame(r)))"})

    def click_on(self, selector):
        self.value(f"document.querySelector('{selector}').scrollIntoView({{block: 'center', behavior: 'instant'}})")
        self.settle()
        box = self.value(f"(b => [b.x + b.width / 2, b.y + b.height / 2])"
                         f"(document.querySelector('{selector}').getBoundingClientRect())")
        self.click(*box)

    def press(self, key, code, text=""):
        for kind in ("keyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent",
                     {"type": kind, "key": key, "code": key if key != " " else "Space",
                      "windowsVirtualKeyCode": code, "text": text if kind == "keyDown" else ""})

    def resize(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride",
                 {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def save_picture(self, path):
        self._save(path, self.ask("Page.captureScreenshot", {"format": "png"}))

    def save_print(self, path):
        return self._save(path, self.ask("Page.printToPDF",
                                         {"printBackground": True, "preferCSSPageSize": True,
                                          "paperWidth": 8.27, "paperHeight": 11.69}))

    def _save(self, path, answer):
        content = base64.b64decode(answer["data"])
        pathlib.Path(path).write_bytes(content)
        return content

    def close(self):
        try:
            self._session = None
            self.ask("Browser.close")
        except (RuntimeError, TimeoutError, OSError):
            pass
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()


def check(is_so, what):
    if not is_so:
        raise AssertionError(what)


def chosen(browser):
    """The rooms that are marked in the ledger and on the map."""
    return (browser.value("Array.from(document.querySelectorAll('tr.room.chosen'), r => r.dataset.room)"),
            browser.value("Array.from(document.querySelectorAll('path.chosen'),"
                          " p => p.getAttribute('data-room'))"))


def middle_on_map(browser, selector):
    """How far the middle of an element is from that of the map, as a share of the map's width."""
    return browser.value(
        f"((a, b) => Math.hypot(a.x + a.width / 2 - b.x - b.width / 2,"
        f" a.y + a.height / 2 - b.y - b.height / 2) / b.width)"
        f"(document.querySelector('{selector}').getBoundingClientRect(),"
        f" document.querySelector('#map').getBoundingClientRect())")


def rows_lead_to_the_map(browser, runs=4):
    browser.click_on("#room-1 td")
    check(chosen(browser) == (["1"], ["1"]), f"a click on a row chooses {chosen(browser)}")
    check(middle_on_map(browser, "path[data-room=\"1\"]") < 0.1, "the chosen room is not centred")
    check(browser.value("document.querySelector('tr.details tbody').rows.length") == runs,
          "the chosen room does not show its runs")
    browser.value("document.querySelector('#room-2').focus()")
    browser.press("Enter", 13, "\r")
    check(chosen(browser) == (["2"], ["2"]), f"Enter on a row chooses {chosen(browser)}")
    check(browser.value("document.querySelector('#said').textContent").startswith("R3 is chosen"),
          "nothing is said to those who cannot see")


def the_map_leads_to_rows(browser):
    browser.click_on('button[data-show="fit"]')
    browser.value("document.querySelector('#map').scrollIntoView({block: 'center', behavior: 'instant'})")
    x, y = browser.value("(b => [b.x + b.width / 2 + 30, b.y + b.height / 2 + 20])"
                         "(document.querySelector('path[data-room=\"3\"]').getBoundingClientRect())")
    browser.click(x, y)
    check(chosen(browser) == (["3"], ["3"]), f"a click on a room chooses {chosen(browser)}")
    browser.wait("(b => b.top >= 0 && b.bottom <= innerHeight)"
                 "(document.querySelector('#room-3').getBoundingClientRect())")
    check(browser.value("document.activeElement.id") == "room-3", "the row has no focus")


def layers_are_switched_by_keyboard(browser):
    images = ".leaflet-runs-pane img"
    check(browser.count(images) == 2, "not the best run and the torn one are shown at first")
    browser.click_on('button[data-show="all"]')
    check(browser.count(images) == 4, "not every run is shown")
    browser.value("document.querySelector('input[data-layer=\"run-1\"]').focus()")
    browser.press(" ", 32, " ")
    check(browser.count(images) == 3, "the space bar does not hide a run")
    browser.press("Tab", 9)
    check(browser.value("document.activeElement.dataset.layer") == "run-2", "Tab goes elsewhere")
    browser.press(" ", 32, " ")
    check(browser.count(images) == 2, "the space bar does not hide the next run")
    browser.value("document.querySelector('button[data-show=heat]').focus()")
    browser.press("Enter", 13, "\r")
    check(browser.count(images) == 1, "more than the best run is shown with the heat map")
    check(browser.count(".leaflet-heat-pane img") == 1, "no heat map")
    browser.click_on('button[data-show="all"]')
    check(browser.count(images) == 4, "not all runs come back")


def names_of_rooms_do_not_cover_each_other(browser):
    hidden = ".room-label.covered"
    check(browser.count(hidden) == 0, "names are hidden though they do not touch")
    browser.value("document.querySelector('.room-label:nth-child(2) span').textContent = 'long'.repeat(99);0")
    browser.value("document.querySelector('input[data-layer=rooms]').click();0")
    browser.value("document.querySelector('input[data-layer=rooms]').click();0")
    check(browser.count(hidden) > 0, "a name lies over others")
    browser.value("document.querySelector('.room-label:nth-child(2) span').textContent = 'R2';0")


def all_pictures_are_whole(browser):
    browser.wait("Array.from(document.images).every(i => i.complete)")
    check(browser.value("Array.from(document.images).every(i => i.naturalWidth > 10)"),
          "a picture is broken")


def breaks_and_sorting_work(browser):
    browser.click_on('tr[data-break="1"] td')
    check("17.2" not in browser.value("document.querySelector('.break-card').textContent")
          and "-2.9°" in browser.value("document.querySelector('.break-card').textContent"),
          "the break does not tell its turn")
    browser.click_on("#pairs-table thead th:nth-child(4) button")
    column = browser.value("Array.from(document.querySelectorAll('#pairs-table tbody tr'),"
                           " r => r.cells[3].textContent)")
    check(column == sorted(column) and len(column) == 6, f"not sorted: {column}")
    for _ in range(2):  # up, then down
        browser.click_on("#rooms thead th:nth-child(4) button")
    check(browser.value("document.querySelector('#rooms tbody tr').id") == "room-4",
          "the room with the largest shift is not on top")


def breaks_and_marks_belong_together(browser):
    marks, paths = ".break-mark", ".leaflet-paths-pane path"
    browser.click_on('button[data-show="all"]')
    check(browser.count(marks) == 2, "a mark is missing")
    browser.click_on('tr[data-break="0"] td')
    check(browser.value("document.querySelector('#break-0').classList.contains('chosen') &&"
                        " document.querySelectorAll('.break-mark.chosen').length") == 1,
          "row and mark of a break are not chosen together")
    check(browser.count(".leaflet-poses-pane path[stroke=\"#00825a\"]") == 1,
          "the torn piece is not shown where it belongs")
    check(browser.value("document.querySelector('#break-0').cells[6].textContent") == "12",
          "the key frame is not told")
    check(browser.value("document.querySelector('.break-card b').textContent") ==
          browser.value("document.querySelector('#break-0').cells[0].textContent").strip(),
          "nothing is said of the break on the map")
    browser.click_on(".break-card button")
    check(browser.count(".break-card, tr.break.chosen") == 0, "the break does not close")
    before = browser.count(paths)
    browser.click_on('input[data-layer="run-2"]')
    check(browser.count(marks) == 0, "a hidden run keeps its marks")
    check(browser.count(paths) < before, "a hidden run keeps its path")
    browser.click_on('tr[data-break="1"] td')
    check(browser.count(marks) == 2, "the run of a chosen break is not shown")
    check(browser.count("tr.break.chosen") == 1, "more than one break is chosen")
    browser.click_on('button[data-show="fit"]')
    check(browser.count("tr.break.chosen, .leaflet-poses-pane path") == 0,
          "the whole site still shows a break")


def the_ledger_can_be_filtered(browser):
    rows = ("Array.from(document.querySelectorAll('tr.room'))"
            ".filter(r => r.getClientRects().length).map(r => r.dataset.room).sort().join()")
    check(browser.value(rows) == "0,1,2,3,4", "not all rooms are listed")
    browser.click_on("#only-different")
    check(browser.value(rows) == "0,1,2,3", f"what differs is {browser.value(rows)}")
    browser.click_on("#only-different")
    check(browser.value(rows) == "0,1,2,3,4", "the rooms do not come back")


def the_picture_is_in_the_first_screen(browser):
    browser.resize(1400, 900)
    browser.value("scrollTo({top: 0, behavior: 'instant'})")
    browser.settle()
    check(browser.value("document.querySelector('#map').getBoundingClientRect().bottom") <= 900,
          "the map ends below the first screen")
    check(browser.value("document.querySelector('.layers.runs').getBoundingClientRect().bottom") < 900,
          "the ranking ends below the first screen")


def it_is_dark_where_that_is_preferred(browser, folder):
    light = "getComputedStyle(document.body).backgroundColor"
    check(browser.value(light) == "rgb(255, 255, 255)", "it is not light")
    browser.ask("Emulation.setEmulatedMedia",
                {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
    check(browser.value(light) == "rgb(23, 28, 36)", "it is not dark")
    check(browser.value("getComputedStyle(document.querySelector('#map')).backgroundColor")
          == "rgb(255, 255, 255)", "the map is not paper")
    for turned in ("#map", "#map-beside", ".layers .mark", ".legend i", "td .scans-picture"):
        check("invert" in browser.value(f"getComputedStyle(document.querySelector('{turned}')).filter"),
              f"{turned} glares in the dark, or has other colours than the map")
    browser.settle()
    browser.save_picture(folder / "dark.png")
    browser.ask("Emulation.setEmulatedMedia", {"features": []})


def runs_are_swiped(browser):
    clips = ("Array.from(document.querySelectorAll('.leaflet-runs-pane img'), i => i.style.clipPath)"
             ".filter(Boolean).length")
    browser.value("document.querySelector('#left-run').value = 0;"
                  "document.querySelector('#right-run').value = 1")
    browser.click_on("#swipe")
    check(browser.value(clips) == 2, "the two runs are not cut at the line")
    line = "document.querySelector('#divider').getBoundingClientRect().left"
    before = browser.value(line)
    x, y = browser.value("(b => [b.x + b.width / 2, b.y + b.height / 3])"
                         "(document.querySelector('#divider').getBoundingClientRect())")
    browser.drag(x, y, x + 100, y)
    check(abs(browser.value(line) - before - 100) < 2, "the line does not follow the mouse")
    browser.value("document.querySelector('#divider').focus()")
    browser.press("ArrowLeft", 37)
    check(browser.value(line) < before + 99, "the line does not follow the keys")
    browser.click_on("#swipe")
    check(browser.value(clips) == 0, "the runs stay cut")


def runs_are_shown_side_by_side(browser):
    browser.click_on("#beside")
    images = "#map-beside .leaflet-runs-pane img"
    check(browser.count(images) == 1, "no second map")
    check(browser.value("document.querySelector('#map-beside').getBoundingClientRect().left >"
                        " document.querySelector('#map').getBoundingClientRect().right"),
          "not side by side")
    browser.click_on("#beside")
    check(browser.value("document.querySelector('#map-beside').offsetWidth") == 0,
          "the second map stays")


def scans_are_shown_in_the_row_of_a_break(browser):
    check(browser.count("#break-0 .scans path") == 3, "no picture of the scans at the break")
    check(browser.value("document.querySelector('#break-1 .scans').textContent") == "–",
          "scans of a break that has none")


def the_address_brings_back_what_is_shown(browser, url):
    browser.click_on('button[data-show="best"]')
    browser.click_on("#room-1 td")
    browser.wait("location.hash.includes('room=R2') && location.hash.includes('runs=1&')")
    address = browser.value("location.href")
    browser.open(address)
    check(chosen(browser) == (["1"], ["1"]), "the room of the address is not chosen")
    check(browser.count(".leaflet-runs-pane img") == 1, "the runs of the address are not those shown")
    browser.open(url + "#break=1&runs=1,3&layers=breaks")
    check(browser.count("tr.break.chosen") == 1, "the break of the address is not chosen")
    browser.open(url + "#swipe=1,2,30")
    check(browser.value("document.querySelector('#divider').getAttribute('aria-valuenow')") == "30",
          "the line of the address is not there")
    for nonsense in ("#break=99&room=nowhere&view=a,b&swipe=7,8,x&runs=&layers=none", "#=&&%E0%A4"):
        browser.open(url + nonsense)
    browser.open(url)


def errors_are_drawn_along_each_drive(browser):
    drawn = json.loads(browser.value("""JSON.stringify(
        Array.from(document.querySelectorAll('#along .along'), (group) => [
          group.querySelector('title').textContent, group.querySelectorAll('path').length]))"""))
    data = json.loads(browser.value("document.querySelector('#comparison').textContent"))
    marks = collections.Counter(tear["run"] for tear in data["breaks"] if tear["key_frame"] is not None)
    driven = [run["name"] for run in data["runs"] if len(run["path"]) > 1]
    check(driven and dict(drawn) == {name: 1 + marks[name] for name in driven},
          f"along the drives there is {drawn}, with {marks} at breaks")


def figures_and_tables_are_saved(browser, folder):
    saved = folder / "saved"
    shutil.rmtree(saved, ignore_errors=True)
    saved.mkdir()
    browser.ask("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(saved)})
    # Chromium lets a page save ten files; both plots are saved in the same way.
    for figure, kind in (("map", "SVG"), ("map", "PNG"), ("plot", "PNG"), ("along", "SVG")):
        browser.click_on(f'[data-figure="{figure}"] [data-kind="{kind}"]')
    browser.value("Array.from(document.querySelectorAll('.csv')).filter("
                  "b => b.textContent === 'Save as CSV').forEach(b => b.click())")
    wanted = {"map.svg", "map.png", "plot.png", "along.svg", "rooms.csv", "ranking.csv", "breaks.csv",
              "pairs.csv", "measures.csv", "files.csv"}
    end = time.monotonic() + TIMEOUT
    while not wanted <= {p.name for p in saved.iterdir()}:
        if time.monotonic() > end:
            raise AssertionError(f"saved is only {sorted(p.name for p in saved.iterdir())}")
        time.sleep(0.1)
    for name in ("map.png", "plot.png"):
        check((saved / name).read_bytes().startswith(b"\x89PNG") and
              (saved / name).stat().st_size > 5000, f"{name} is no picture")
    for name in ("map.svg", "along.svg"):
        xml.etree.ElementTree.parse(saved / name)
    with open(saved / "breaks.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    check(rows[0][:2] == ["Run", "x [m]"] and len(rows) == 3 and rows[1][6] == "12",
          f"breaks.csv holds {rows}")
    check(len({len(row) for row in rows}) == 1, "the rows of breaks.csv differ in length")


def a_hundred_runs_can_be_worked_with(browser, folder):
    check(browser.count(".layers.runs label") == 100, "not all runs are listed")
    check(browser.value("document.querySelector('#pairs-table').closest('details').open") is False,
          "thousands of pairs are open")
    check(browser.value("document.documentElement.scrollHeight") < 9000, "the page is endless")
    browser.click_on('button[data-show="all"]')
    check(browser.count(".layers.runs input:checked") == 100, "not all runs can be shown")
    rows_lead_to_the_map(browser, 100)
    weaves = browser.value("Array.from(new Set(Array.from(document.querySelectorAll('.weave'),"
                           " w => w.className + w.style.color))).length")
    check(weaves >= 28, f"only {weaves} runs look different")
    browser.save_picture(folder / "hundred.png")
    nothing_is_wider_than_the_window(browser, 400)


def places_on_the_map(browser):
    """Where rooms, breaks and paths are, on the map of the whole site."""
    browser.click_on('button[data-show="all"]')
    browser.click_on('button[data-show="fit"]')
    return browser.value(
        "(m => Array.from(document.querySelectorAll('path.room-shape, .break-mark, .leaflet-paths-pane path,"
        " .leaflet-runs-pane img'), e => e.getBoundingClientRect())"
        ".map(b => [b.x - m.x, b.y - m.y, b.width, b.height]))"
        "(document.querySelector('#map').getBoundingClientRect())")


def an_askew_site_stands_upright(browser, url, upright):
    """`upright` are the places on the map of the same site in an upright frame."""
    check(browser.value("document.querySelector('#turned').textContent").startswith("Turned by -23°"),
          "it is not said that the picture is turned")
    places = places_on_the_map(browser)
    check(len(places) == len(upright), "it shows other things")
    for i, (at, wanted) in enumerate(zip(places, upright)):
        check(max(abs(a - b) for a, b in zip(at, wanted)) < 12, f"{i} is at {at}, not {wanted}")
    browser.click_on('tr[data-break="0"] td')
    check(middle_on_map(browser, ".break-mark.chosen") < 0.05, "the chosen break is not in the middle")
    x, y = (float(browser.value(f"document.querySelector('#break-0').cells[{k}].textContent")) for k in (1, 2))
    browser.wait("location.hash.includes('view=')")
    center = browser.value("new URLSearchParams(location.hash.slice(1)).get('view')").split(",")
    check(abs(float(center[0]) - x) < 0.1 and abs(float(center[1]) - y) < 0.1,
          f"the address has {center}, the table {x}, {y}")
    address = browser.value("location.href").replace("&break=1", "")
    browser.open(address)
    check(middle_on_map(browser, ".break-mark") < 0.05, "the address leads elsewhere")


def names_strike_nothing(browser):
    check(browser.value("window.struck") is None, "a name was run as code")
    check(browser.count("img[src=x]") == 0, "a name made an image")
    check(browser.value("document.querySelector('#ranking-table').textContent"
                        ".includes('<img src=x onerror')"), "a name is not shown as it is")


def nothing_is_wider_than_the_window(browser, width):
    browser.resize(width, 800)
    time.sleep(0.4)  # the plot follows the window a moment later
    check(browser.value("document.documentElement.scrollWidth") <= width,
          f"the page is wider than {width} px: "
          + str(browser.value("document.documentElement.scrollWidth")))
    check(browser.value("document.querySelector('#plot svg').getBoundingClientRect().width") <= width,
          "the plot is too wide")


def it_asks_for_nothing_and_complains_of_nothing(browser, url):
    for event in browser.events:
        parameters = event["params"]
        if event["method"] == "Network.requestWillBeSent":
            asked = parameters["request"]["url"]
            own = asked.split("#")[0] == url or asked == "about:blank"
            check(own or asked.startswith(("data:", "blob:")), f"the page asks for {asked}")
        check(event["method"] != "Runtime.exceptionThrown", f"an error: {parameters}")
        if event["method"] == "Log.entryAdded":
            check(parameters["entry"]["level"] not in ("error", "warning"), f"a complaint: {parameters}")
        if event["method"] == "Runtime.consoleAPICalled":
            check(parameters["type"] not in ("error", "warning"), f"a complaint: {parameters}")


def it_can_be_printed(browser, folder):
    content = browser.save_print(folder / "report.pdf")
    check(content.startswith(b"%PDF") and len(content) > 20000, "the print is empty")
    pages = len(re.findall(rb"/Type\s*/Page\b", content))
    check(pages <= 4, f"the print has {pages} pages")
    check(browser.value("document.querySelector('#map').style.width") == "",
          "the map keeps the size of the paper")
    check(browser.value("document.querySelector('#options details').open") is False,
          "what was folded stays open after the print")


def measures_stand_below_each_other_on_paper(browser):
    browser.ask("Emulation.setEmulatedMedia", {"media": "print"})
    browser.value("document.querySelector('.all-measures').open = true")
    places = browser.value("""JSON.stringify(
        [...document.querySelectorAll('#measures-table thead th')].map((cell, k) => {
          const box = cell.getBoundingClientRect();
          const value = document.querySelectorAll('#measures-table tbody tr')[0].cells[k]
            .getBoundingClientRect();
          return [box.left, box.top, value.top];
        }))""")
    lines = json.loads(places)
    check(len({left for left, _, _ in lines}) == 1, "names of measures stand beside each other")
    check(all(abs(top - value) < 1 for _, top, value in lines),
          "a measure does not stand beside its name")
    browser.ask("Emulation.setEmulatedMedia", {"media": ""})


def find_browser():
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))),
                None)


def work_with(browser, folder, url):
    browser.save_picture(folder / "wide.png")
    the_picture_is_in_the_first_screen(browser)
    it_is_dark_where_that_is_preferred(browser, folder)
    all_pictures_are_whole(browser)
    names_of_rooms_do_not_cover_each_other(browser)
    names_strike_nothing(browser)
    layers_are_switched_by_keyboard(browser)
    rows_lead_to_the_map(browser)
    the_map_leads_to_rows(browser)
    browser.save_picture(folder / "chosen.png")
    breaks_and_sorting_work(browser)
    breaks_and_marks_belong_together(browser)
    the_ledger_can_be_filtered(browser)
    scans_are_shown_in_the_row_of_a_break(browser)
    runs_are_swiped(browser)
    runs_are_shown_side_by_side(browser)
    errors_are_drawn_along_each_drive(browser)
    figures_and_tables_are_saved(browser, folder)
    the_address_brings_back_what_is_shown(browser, url)
    names_strike_nothing(browser)
    it_can_be_printed(browser, folder)
    measures_stand_below_each_other_on_paper(browser)
    for width in (1000, 400):
        nothing_is_wider_than_the_window(browser, width)
    rows_lead_to_the_map(browser)
    browser.save_picture(folder / "narrow.png")
    it_asks_for_nothing_and_complains_of_nothing(browser, url)


@contextlib.contextmanager
def opened_report(program, write_sample, folder, *runs):
    """A browser with the sample report, and its address; or with one of so many runs, in a site that
    is turned by so much."""
    folder.mkdir(parents=True, exist_ok=True)
    report = folder / "report.html"
    subprocess.run([write_sample, str(report), *runs], check=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(program, profile)
        try:
            browser.attach()
            browser.resize(1400, 900)
            browser.open(report.as_uri())
            yield browser, report.as_uri()
        finally:
            browser.close()


def main():
    write_sample, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    program = find_browser()
    if not program:
        print("skipped: no Chromium here (Debian's package: chromium)")
        return 77
    with opened_report(program, write_sample, folder) as (browser, url):
        upright = places_on_the_map(browser)
        browser.open(url)
        work_with(browser, folder, url)
    with opened_report(program, write_sample, folder / "askew", "4", "0.4") as (browser, url):
        an_askew_site_stands_upright(browser, url, upright)
        it_asks_for_nothing_and_complains_of_nothing(browser, url)
    with opened_report(program, write_sample, folder / "hundred", "100") as (browser, url):
        a_hundred_runs_can_be_worked_with(browser, folder)
        it_asks_for_nothing_and_complains_of_nothing(browser, url)
    print("the report works in", program)
    return 0


if __name__ == "__main__":
    sys.exit(main())
