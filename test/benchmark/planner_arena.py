#!/usr/bin/env python3
"""Opens a database in the real Planner Arena with headless Chromium and checks what its three tabs draw.

planner_arena.py PROGRAM SOURCE_DIR [SCREENSHOT_DIR]: runs a campaign with PROGRAM; exit status 77 if a
required program is not installed. planner_arena.py --database FILE.db SOURCE_DIR [SCREENSHOT_DIR] opens FILE.db.
"""
import os
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from browser import Browser, free_port, skip, wait_for

CONFIG = """[problem]
name = arena
world = {source}/benchmarks/worlds/paper_scene.yaml
robot = disc
robot.radius = 0.3
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
time_limit = 3
run_count = 3
[planner]
mfa =
rrtstar =
prmstar =
rrtconnect =
"""

# Number of connected groups of columns with the boxes' colours, and the pixels of each colour inside the panel.
LOOK = """
const [selector, colours] = arguments;
const image = document.querySelector(selector);
const canvas = document.createElement('canvas');
canvas.width = image.naturalWidth; canvas.height = image.naturalHeight;
const context = canvas.getContext('2d');
context.drawImage(image, 0, 0);
const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data;
const near = (i, c) => Math.abs(pixels[i] - c[0]) + Math.abs(pixels[i + 1] - c[1]) + Math.abs(pixels[i + 2] - c[2]) < 30;
let right = 0;
for (let x = 0; x < canvas.width; ++x) {
    let panel = 0;
    for (let y = 0; y < canvas.height; ++y) panel += near(4 * (y * canvas.width + x), [235, 235, 235]) ? 1 : 0;
    if (panel > 0.3 * canvas.height) right = x;
}
const counts = colours.map(() => 0);
let groups = 0, inside = false;
for (let x = 0; x <= right; ++x) {
    let found = false;
    for (let y = 0; y < canvas.height; ++y)
        colours.forEach((c, k) => { if (near(4 * (y * canvas.width + x), c)) { ++counts[k]; found = true; } });
    if (found && !inside) ++groups;
    inside = found;
}
return {width: canvas.width, groups: groups, counts: counts};
"""


def missing_requirement():
    for program in ("Rscript", "chromium", "chromedriver", "ompl_benchmark_statistics"):
        if shutil.which(program) is None:
            return program
    packages = "shiny shinyjs dplyr tidyr ggplot2 Hmisc RSQLite markdown dbplyr mgcv"
    check = f'quit(status = !all(sapply(strsplit("{packages}", " ")[[1]], requireNamespace, quietly = TRUE)))'
    if subprocess.run(["Rscript", "-e", check], stderr=subprocess.DEVNULL).returncode != 0:
        return "one of the R packages " + packages
    return None


def make_database(program, source, folder):
    config = os.path.join(folder, "arena.cfg")
    with open(config, "w") as file:
        file.write(CONFIG.format(source=source))
    log = os.path.join(folder, "arena.log")
    subprocess.run([program, "benchmark", config, "--output", log, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    # The Regression tab compares versions: the same log once more, under another one.
    with open(log) as file:
        first, rest = file.read().split("\n", 1)
    other = os.path.join(folder, "other.log")
    with open(other, "w") as file:
        file.write(first + "-other\n" + rest)
    database = os.path.join(folder, "arena.db")
    text = subprocess.run(["ompl_benchmark_statistics", log, other, "-d", database], check=True, capture_output=True,
                          text=True)
    assert text.stderr == "" and "Ignoring" not in text.stdout, text
    return database


def planner_count(database):
    with sqlite3.connect(database) as connection:
        return connection.execute("SELECT count(DISTINCT name) FROM plannerConfigs").fetchone()[0]


def hues(count):
    text = subprocess.run(["Rscript", "-e", f"cat(scales::hue_pal()({count}))"], check=True, capture_output=True,
                          text=True).stdout
    return [[int(colour[i:i + 2], 16) for i in (1, 3, 5)] for colour in text.split()]


def wait_for_plot(browser, tab, plot):
    idle = "return !document.documentElement.classList.contains('shiny-busy')"
    time.sleep(2)
    wait_for(tab + " to be idle", lambda: browser.run(idle))
    wait_for(tab + " plot", lambda: browser.run(
        "const i = document.querySelector(arguments[0]); return i !== null && i.complete && i.naturalWidth > 0", plot))


def select_planners(browser, page, names):
    """Ticks the boxes of the planners, of all if names is null."""
    browser.run("document.querySelectorAll('input[name=' + arguments[0] + '_planners]').forEach(box => {"
                "if (box.checked !== (arguments[1] === null || arguments[1].includes(box.value))) box.click(); });",
                page, names)


def show(browser, tab, page, select, attribute):
    """Opens a tab with all planners and one attribute, and waits until its plot is redrawn."""
    plot = f"#{page}_plot img"
    # Chosen by its value: clicking depends on the version of Bootstrap.
    browser.run("$('a[data-value=' + arguments[0] + ']').click()", tab)
    wait_for(tab + " planners", lambda: browser.run(
        "return document.querySelectorAll('input[name=' + arguments[0] + '_planners]').length", page))
    time.sleep(1)
    browser.run("$('.alert .close').click();")
    select_planners(browser, page, None)
    browser.run("$('#' + arguments[0])[0].selectize.setValue(arguments[1]);", select, attribute)
    wait_for_plot(browser, tab, plot)
    errors = browser.run("return Array.from(document.querySelectorAll('.tab-pane.active .shiny-output-error'))"
                         ".map(e => e.textContent)")
    assert errors == [], (tab, errors)
    return plot


def check(browser, planners, folder):
    def keep(name):
        if folder:
            browser.screenshot(os.path.join(folder, f"planner_arena_{name}.png"))

    colours = hues(planners)
    wait_for("the page", lambda: browser.run("return document.querySelectorAll('#perf_attr').length"))
    plot = show(browser, "performance", "perf", "perf_attr", "time_to_first_solution")
    seen = browser.run(LOOK, plot, [[48, 115, 186], [153, 201, 235]])
    print("Overall performance:", seen)
    keep("performance")
    assert seen["groups"] == planners, "not one box for each planner"
    rows = browser.run("return document.querySelectorAll('#perf_missing_data_table tbody tr').length")
    assert rows == planners, rows

    plot = show(browser, "progress", "prog", "progress", "best_cost")
    seen = browser.run(LOOK, plot, colours)
    print("Progress:", seen)
    keep("progress")
    names = browser.run("return Array.from(document.querySelectorAll('input[name=prog_planners]')).map(b => b.value)")
    for name, count in zip(names, seen["counts"]):
        if count > 40:
            continue
        # a curve that others cover is shown alone
        select_planners(browser, "prog", [name])
        wait_for_plot(browser, "progress", plot)
        alone = browser.run(LOOK, plot, hues(1))
        print(f"Progress of {name} alone:", alone)
        assert alone["counts"][0] > 40, "no curve for " + name

    plot = show(browser, "regression", "regr", "regr_attr", "path_cost")
    seen = browser.run(LOOK, plot, colours)
    print("Regression:", seen)
    keep("regression")
    assert min(seen["counts"]) > 1000, "not one bar for each planner"


def main():
    # CTest ends tests that exceed their timeout with this signal: the servers must end too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    missing = missing_requirement()
    if missing:
        skip(missing + " is not installed")
    folder = tempfile.mkdtemp()
    arena = browser = None
    try:
        if sys.argv[1] == "--database":
            database, rest = sys.argv[2], sys.argv[3:]
        else:
            database, rest = make_database(sys.argv[1], sys.argv[2], folder), sys.argv[2:]
        port = free_port()
        with open(os.path.join(folder, "arena.out"), "w+") as output:
            arena = subprocess.Popen([os.path.join(rest[0], "benchmarks/arena/planner_arena"), database, str(port)],
                                     stdout=output, stderr=output, start_new_session=True)

            def listening():
                if arena.poll() == 3:
                    skip("Planner Arena cannot be had")
                with socket.socket() as probe:
                    return probe.connect_ex(("127.0.0.1", port)) == 0

            wait_for("Planner Arena", listening)
            browser = Browser(folder)
            browser.go(f"http://127.0.0.1:{port}/")
            check(browser, planner_count(database), rest[1] if len(rest) > 1 else None)
            output.seek(0)
            text = output.read()
            assert "Computation failed" not in text, text
    finally:
        if browser:
            browser.close()
        if arena:
            os.killpg(arena.pid, signal.SIGTERM)
        shutil.rmtree(folder, ignore_errors=True)
    print("passed")


if __name__ == "__main__":
    main()
