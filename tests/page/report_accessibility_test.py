"""report_accessibility_test.py WRITE_SAMPLE_REPORT FOLDER AXE: asks axe-core (the file AXE, which
scripts/test fetches) what in a report keeps people out who cannot see it well or have no mouse, at
three sizes, light, dark and printed. Exits with 77 without Chromium or axe-core."""
import pathlib
import sys

from report_in_browser_test import check, find_browser, opened_report

WIDTHS = (1400, 1000, 400)
LOOKS = (("light", ""), ("dark", ""), ("light", "print"))
ASK = """axe.run().then(r => r.violations.map(
    v => v.id + ' at ' + v.nodes.map(n => n.target.join(' ')).slice(0, 4).join(', ')))"""


def violations(browser, width, scheme, medium):
    browser.ask("Emulation.setEmulatedMedia",
                {"media": medium, "features": [{"name": "prefers-color-scheme", "value": scheme}]})
    browser.resize(width, 900)
    browser.settle()
    answer = browser.ask("Runtime.evaluate",
                         {"expression": ASK, "awaitPromise": True, "returnByValue": True})
    return answer["result"]["value"]


def look_at(browser, what):
    for scheme, medium in LOOKS:
        for width in WIDTHS:
            found = violations(browser, width, scheme, medium)
            check(found == [], f"{what}, {width} px, {scheme} {medium}: {found}")


def main():
    write_sample, folder, axe = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    program = find_browser()
    if not program or not axe.is_file():
        print("skipped: no Chromium here (Debian's package: chromium)" if not program else
              "skipped: no axe-core here; scripts/test fetches it where there is npm and a network")
        return 77
    with opened_report(program, write_sample, folder) as (browser, _):
        browser.value(axe.read_text(encoding="utf-8") + ";0")
        check(violations(browser, 1400, "light", "") == [], "the page as it opens")
        browser.value("document.querySelectorAll('details').forEach(d => { d.open = true; });0")
        look_at(browser, "with all opened")
        browser.resize(1400, 900)
        browser.click_on("#room-1 td")
        browser.click_on("#break-0 td")
        look_at(browser, "with a room and a break chosen")
        browser.resize(1400, 900)
        for button in ("#swipe", "#beside"):
            browser.click_on(button)
            found = violations(browser, 1400, "light", "")
            check(found == [], f"after {button}: {found}")
        browser.value("document.body.append(Object.assign(new Image(), {src: 'data:,'}));0")
        check(violations(browser, 1400, "light", "") != [], "axe-core finds nothing ever")
    print("axe-core finds nothing to complain of")
    return 0


if __name__ == "__main__":
    sys.exit(main())
