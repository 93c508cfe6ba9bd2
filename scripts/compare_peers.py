"""What scripts/compare-peers runs: Mitsuba and this program on one scene after the other, a line for each."""
import os
import re
import resource
import shlex
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import peer_scenes

WORK = Path(sys.argv[1]).resolve()
SCENES = sys.argv[2:] or ["cornell5k", "cornell50k", "big100k"]
SAMPLES = int(os.environ.get("MITSUBA_SAMPLES", "64"))
ACCURACIES = os.environ.get("ACCURACIES", "5 2 1").split()
OPTIONS = shlex.split(os.environ.get("OPTIONS", ""))
TIMEOUT = float(os.environ.get("TIMEOUT", "900"))
TARGET = 0.02
OURS = WORK / "ours"


def number(name, text):
    return float(re.search(name + r" ([-+0-9.e]+)", text).group(1))


def process(command, **more):
    """Output, CPU-seconds and wall seconds of a program and all that it starts."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, timeout=TIMEOUT, **more)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return run.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def line(scene, program, *columns):
    print("| " + " | ".join((scene, program) + columns) + " |", flush=True)


def too_long(scene, program, settings):
    line(scene, program, settings, f"not waited for beyond {TIMEOUT:.0f} s", *[""] * 5)


def figures(rmse, solve, cpu, wall):
    return f"{100 * rmse:.2f} %", f"{solve:.2f}", f"{cpu:.2f}", f"{wall:.2f}"


class Mitsuba:
    """Its second run counts as the solve: the first compiles kernels. A whole process has no second one."""

    def __init__(self, scene):
        self.scene = scene
        self.rmse = self.solve = float("nan")
        self.run(SAMPLES)
        if self.rmse > TARGET:
            self.run(round(SAMPLES * (self.rmse / TARGET) ** 2))

    def run(self, samples):
        try:
            out, cpu, wall = process([sys.executable, str(WORK / "scripts/peer_mitsuba.py"), self.scene, str(samples),
                                      "llvm_ad_rgb", "1"])
        except subprocess.TimeoutExpired:
            too_long(self.scene, "Mitsuba", f"{samples} samples")
            return
        self.rmse, self.solve = number("rmse", out), number("cpu_s", out)
        line(self.scene, "Mitsuba", f"{samples} samples",
             *figures(self.rmse, self.solve, cpu - self.solve, wall - number("time_s", out)), "", "")

    def to(self, error):
        """CPU-seconds to an error: it falls with the root of the samples."""
        return self.solve * (self.rmse / error) ** 2


def answer(scene, options):
    """Error, CPU and wall seconds of a whole process that is asked for the light at the peers' points."""
    found, raw = OURS / (scene + ".answer.csv"), OURS / (scene + ".f64")
    _, cpu, wall = process(["scripts/RadiosityRenderer", "-q", *options, "--points", str(OURS / "points" / (scene + ".csv")),
                            str(found), str(OURS / "lightwave" / (scene + ".lws")), str(OURS / (scene + ".scene"))])
    np.loadtxt(found, delimiter=",", skiprows=1)[:, 9:12].tofile(raw)
    return number("rmse", process([sys.executable, str(WORK / "scripts/rmse_of.py"), scene, str(raw)])[0]), cpu, wall


def warm(scene, accuracy):
    """CPU-seconds of a solve in a process that has solved the scene before, as Mitsuba's are."""
    turns = "2" if scene == "big100k" else "4"
    out, _, _ = process(["scripts/accuracy", *OPTIONS, "--accuracy", accuracy, "--repeat", turns, scene],
                        env={**os.environ, "TRUTH": str(OURS)})
    return min([float(row.split()[7]) for row in out.splitlines() if row.startswith(scene)][1:])


def ours(scene, accuracy, mitsuba):
    """Whether it was waited for."""
    settings = " ".join([*OPTIONS, "--accuracy", accuracy + "%"])
    try:
        rmse, cpu, wall = answer(scene, [*OPTIONS, "--accuracy", accuracy + "%"])
        solve = warm(scene, accuracy)
    except subprocess.TimeoutExpired:
        too_long(scene, "this program", settings)
        return False
    same = mitsuba.to(rmse)
    line(scene, "this program", settings, *figures(rmse, solve, cpu, wall), f"{same:.1f}", f"{same / solve:.1f}")
    return True


def compare(scene):
    peer_scenes.write(WORK, OURS, scene)
    subprocess.run(["scripts/RadiosityRenderer", "--version"], check=True, stdout=subprocess.DEVNULL)
    mitsuba = Mitsuba(scene)
    all(ours(scene, accuracy, mitsuba) for accuracy in ACCURACIES)  # finer ones take longer: none after the first too long


if __name__ == "__main__":
    line("scene", "program", "settings", "rmse", "CPU s of the solve", "CPU s of the process", "wall s of the process",
         "CPU s of Mitsuba to the same error", "over this program's")
    line(*["---"] * 9)
    for name in SCENES:
        compare(name)
