#!/usr/bin/env python3
"""Opens the pages of `ompl_mfa report`, `animate` and `drive` in headless Chromium, at two widths, and checks that they draw.

pages.py PROGRAM SOURCE_DIR [SCREENSHOT_DIR]: runs two small campaigns with PROGRAM; exit status 77 if Chromium is not
installed.
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from browser import Browser, skip, wait_for

CONFIG = """[problem]
name = {name}
world = {source}/benchmarks/worlds/paper_scene.yaml
robot = disc
robot.radius = {radius}
start.x = 0.3
start.y = 2.2
goal.x = 20
goal.y = 20
volume.min.x = 0
volume.min.y = 0
volume.max.x = 20
volume.max.y = 20
objective = length
[benchmark]
time_limit = 0.4
run_count = 6
seed = 3
[planner]
mfa =
rrtstar =
rrtconnect =
mfa_paper.slices = 6
fa_paper.slices = 6
"""

# Pixels of a plot's canvases that are neither white nor transparent, nor grey as grid and axes.
COLOURED = """
let count = 0;
for (const canvas of arguments[0].querySelectorAll('canvas')) {
    if (canvas.width === 0) continue;
    const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    for (let i = 0; i < pixels.length; i += 4) {
        const spread = Math.max(pixels[i], pixels[i + 1], pixels[i + 2]) - Math.min(pixels[i], pixels[i + 1], pixels[i + 2]);
        if (pixels[i + 3] > 40 && spread > 40) ++count;
    }
}
return count;
"""
WIDTHS = (1280, 480)


def make_results(program, source, folder):
    logs = []
    for name, radius in (("wide", 0.3), ("narrow", 0.2)):
        config = os.path.join(folder, name + ".cfg")
        with open(config, "w") as file:
            file.write(CONFIG.format(name=name, radius=radius, source=source))
        logs.append(os.path.join(folder, name + ".log"))
        subprocess.run([program, "benchmark", config, "--output", logs[-1], "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
    return logs


def require_no_errors(browser, page):
    # the browser's advice on how this test reads canvases is none
    messages = [entry for entry in browser.messages() if entry["source"] != "rendering"]
    assert messages == [], (page, messages)


def require_no_overflow(browser, page, width):
    wide = browser.run("return document.documentElement.scrollWidth")
    assert wide <= width, f"{page} is {wide} pixels wide in a window of {width}"


def keep(browser, folder, name):
    if folder:
        browser.screenshot(os.path.join(folder, name + ".png"))


def count_coloured(browser, selector, index):
    return browser.run("return (function () {" + COLOURED + "})(document.querySelectorAll(arguments[0])[arguments[1]])",
                       selector, index)


def check_report(browser, page, screenshots):
    for width in WIDTHS:
        browser.resize(width, 1000)
        browser.go("file://" + page)
        require_no_errors(browser, page)
        require_no_overflow(browser, page, width)
        kinds = browser.run("return Array.from(document.querySelectorAll('.plot')).map(plot => plot.dataset.plot)")
        for kind in ("solved", "cost", "runs", "profile"):
            assert kind in kinds, kinds
        for index, kind in enumerate(kinds):
            coloured = count_coloured(browser, ".plot", index)
            # markers have few pixels, lines of several planners many
            assert coloured > (60 if kind == "runs" else 300), (width, kind, coloured)
        keep(browser, screenshots, f"report_{width}")
    # hiding all planners empties the plots
    browser.run("document.querySelectorAll('.legend input').forEach(box => box.click())")
    wait_for("the plots to be empty", lambda: count_coloured(browser, ".plot", kinds.index("solved")) == 0, 10)
    browser.run("document.querySelectorAll('.legend input').forEach(box => box.click())")
    browser.run("const axis = document.getElementById('cost-axis'); axis.value = 'cost';"
                "axis.dispatchEvent(new Event('change'))")
    wait_for("the other axis", lambda: browser.run(
        "return document.querySelector('.plot[data-plot=cost]').textContent.includes('median cost')"), 10)
    require_no_errors(browser, page)


def check_animation(browser, page, screenshots):
    for width in WIDTHS:
        browser.resize(width, 1000)
        browser.go("file://" + page)
        require_no_overflow(browser, page, width)
        states = []
        for position in (0, 10, 20):
            browser.run("const slider = document.getElementById('slider'); slider.value = arguments[0];"
                        "slider.dispatchEvent(new Event('input'))", position)
            for index in range(2):
                coloured = count_coloured(browser, ".swarms figure", index)
                assert coloured > 500, (width, index, coloured)
            states.append(browser.run("return document.querySelector('.state').textContent"))
        assert len(set(states)) == 3 and states[2].startswith("Generation 20: "), states
        require_no_errors(browser, page)
        keep(browser, screenshots, f"swarm_{width}")
    browser.run("document.getElementById('slider').value = 0; document.getElementById('slider')."
                "dispatchEvent(new Event('input')); document.getElementById('play').click()")
    wait_for("the animation to play", lambda: browser.run("return Number(document.getElementById('slider').value)") > 1, 20)


def check_drive(browser, page, screenshots):
    for width in WIDTHS:
        browser.resize(width, 1000)
        browser.go("file://" + page)
        require_no_overflow(browser, page, width)
        states, drawn = [], []
        for part in (0, 0.5, 1):
            browser.run("const slider = document.getElementById('slider');"
                        "slider.value = Math.round(arguments[0] * slider.max);"
                        "slider.dispatchEvent(new Event('input'))", part)
            # what is known as an obstacle is dark, what is not known is the grey of a cell
            drawn.append(browser.run("""
                const canvas = document.querySelector('.drive canvas');
                const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
                let dark = 0, unknown = 0;
                for (let i = 0; i < pixels.length; i += 4) {
                    dark += pixels[i] === 0x2b && pixels[i + 1] === 0x2b && pixels[i + 2] === 0x2b;
                    unknown += pixels[i] === 0xcc && pixels[i + 1] === 0xd2 && pixels[i + 2] === 0xd9;
                }
                return [dark, unknown];"""))
            states.append(browser.run("return document.querySelector('.state').textContent"))
            keep(browser, screenshots, f"drive_{width}_{part}")
        assert drawn[0][0] < 0.5 * drawn[1][0] and drawn[2][0] > 0.9 * drawn[1][0], drawn  # the path hides some
        assert drawn[0][1] > drawn[1][1] > drawn[2][1], drawn
        assert len(set(states)) == 3 and states[2].endswith(", arrived"), states
        require_no_errors(browser, page)
    browser.run("document.getElementById('slider').value = 0; document.getElementById('slider')."
                "dispatchEvent(new Event('input')); document.getElementById('play').click()")
    wait_for("the drive to play", lambda: browser.run("return Number(document.getElementById('slider').value)") > 1, 20)
    require_no_errors(browser, page)


def make_drive(program, folder, page):
    """A wall of which the robot knows nothing."""
    rows = ["".join("@" if x == 20 and y > 3 else "." for x in range(40)) for y in range(25)]
    with open(os.path.join(folder, "wall.map"), "w") as file:
        file.write("type octile\nheight 25\nwidth 40\nmap\n" + "\n".join(rows) + "\n")
    config = os.path.join(folder, "drive.cfg")
    with open(config, "w") as file:
        file.write("[problem]\nworld = wall.map\nrobot = disc\nrobot.radius = 0.6\nstart.x = 3\nstart.y = 12\n"
                   "goal.x = 36\ngoal.y = 12\ndrive.speed = 2\n")
    subprocess.run([program, "drive", config, "--animation", page], check=True, stdout=subprocess.DEVNULL)


def check_picture(browser, picture, screenshots):
    """The paths of the swarms are elsewhere at another time, and the right caption is shown."""
    browser.resize(900, 520)
    browser.go("file://" + picture)
    places = []
    for seconds in (0.01, 3, 11):
        # for a document of its own: an image in a page plays by itself
        places.append(browser.run(
            "const svg = document.documentElement; svg.pauseAnimations(); svg.setCurrentTime(arguments[0]);"
            "const lines = Array.from(svg.querySelectorAll('.swarm polyline'));"
            "const shown = Array.from(svg.querySelectorAll('text')).filter(text => text.textContent.startsWith('gen') &&"
            "    getComputedStyle(text).visibility === 'visible').map(text => text.textContent);"
            "return [lines.reduce((sum, line) => sum + line.animatedPoints.getItem(1).y, 0), shown.length, shown[0]]",
            seconds))
        time.sleep(0.5)  # painting follows later
        keep(browser, screenshots, f"swarm_svg_{int(seconds)}")
    assert len({place[0] for place in places}) == 3, places
    assert all(place[1] == 2 for place in places), places
    assert places[0][2].startswith("generation 0:") and places[2][2].startswith("generation 20:"), places


def main():
    # CTest ends tests that exceed their timeout with this signal: the browser must end too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    for needed in ("chromium", "chromedriver"):
        if shutil.which(needed) is None:
            skip(needed + " is not installed")
    program, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    screenshots = sys.argv[3] if len(sys.argv) > 3 else None
    folder = tempfile.mkdtemp()
    browser = None
    try:
        logs = make_results(program, source, folder)
        report, swarm, picture = (os.path.join(folder, name) for name in ("report.html", "swarm.html", "swarm.svg"))
        subprocess.run([program, "report", *logs, "-o", report], check=True)
        for output in (swarm, picture):
            subprocess.run([program, "animate", os.path.join(folder, "wide.cfg"), "-o", output, "--generations", "20"],
                           check=True)
        drive = os.path.join(folder, "drive.html")
        make_drive(program, folder, drive)
        browser = Browser(folder)
        check_report(browser, report, screenshots)
        check_animation(browser, swarm, screenshots)
        check_drive(browser, drive, screenshots)
        check_picture(browser, picture, screenshots)
    finally:
        if browser:
            browser.close()
        shutil.rmtree(folder, ignore_errors=True)
    print("passed")


if __name__ == "__main__":
    main()
