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
OPTIONS = shlex.split(os.environ.get("OPTIONS", ""))
TARGETS = (0.02, 0.01)
OURS = WORK / "ours"


def number(name, text):
    return float(re.search(name + r" ([-+0-9.e]+)", text).group(1))


def process(command, **more):
    """Output, CPU-seconds and wall seconds of a program and all that it starts."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, **more)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return run.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def line(scene, program, settings, rmse, solve, cpu, wall):
    print(f"| {scene} | {program} | {settings} | {100 * rmse:.2f} % | {solve:.2f} | {cpu:.2f} | {wall:.2f} |", flush=True)


def mitsuba(scene, samples):
    """Its second run counts as the solve: the first compiles kernels. A whole process has no second one."""
    out, cpu, wall = process([sys.executable, str(WORK / "scripts/peer_mitsuba.py"), scene, str(samples), "llvm_ad_rgb", "1"])
    rmse, solve = number("rmse", out), number("cpu_s", out)
    line(scene, "Mitsuba", f"{samples} samples", rmse, solve, cpu - solve, wall - number("time_s", out))
    return rmse, solve


def ours(scene):
    answer, raw = OURS / (scene + ".answer.csv"), OURS / (scene + ".f64")
    command = ["scripts/RadiosityRenderer", "-q", *OPTIONS, "--points", str(OURS / "points" / (scene + ".csv")),
               str(answer), str(OURS / "lightwave" / (scene + ".lws")), str(OURS / (scene + ".scene"))]
    _, cpu, wall = process(command)
    np.loadtxt(answer, delimiter=",", skiprows=1)[:, 9:12].tofile(raw)
    rmse = number("rmse", process([sys.executable, str(WORK / "scripts/rmse_of.py"), scene, str(raw)])[0])
    solve = min(warm(scene))
    line(scene, "this program", " ".join(OPTIONS) or "default", rmse, solve, cpu, wall)
    return rmse, solve


def warm(scene):
    """CPU-seconds of a solve in a process that has solved the scene before, as Mitsuba's are."""
    out, _, _ = process(["scripts/accuracy", *OPTIONS, "--repeat", "4" if scene != "big100k" else "2", scene],
                        env={**os.environ, "TRUTH": str(OURS)})
    return [float(row.split()[7]) for row in out.splitlines() if row.startswith(scene)]


def compare(scene):
    peer_scenes.write(WORK, OURS, scene)
    subprocess.run(["scripts/RadiosityRenderer", "--version"], check=True, stdout=subprocess.DEVNULL)
    look, _ = mitsuba(scene, SAMPLES)
    rmse, cpu = mitsuba(scene, round(SAMPLES * (look / max(TARGETS)) ** 2))
    reached, solve = ours(scene)
    for target in sorted({*TARGETS, reached}, reverse=True):
        needed = cpu * (rmse / target) ** 2
        note = f": {needed / solve:.1f} times this program's" if target == reached else ""
        print(f"Mitsuba on {scene} to {100 * target:.2f} %, by its error's root of samples: {needed:.1f} CPU s{note}")


if __name__ == "__main__":
    print("| scene | program | settings | rmse | CPU s of the solve | CPU s of the process | wall s of the process |")
    print("|---|---|---|---|---|---|---|")
    for name in SCENES:
        compare(name)
