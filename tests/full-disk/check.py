#!/usr/bin/env python3
"""A sweep whose disk becomes full: what was computed is kept, and the sweep goes on when there is room again.

    check.py EZY      EZY: the program

The disk is a file system in memory that is mounted for this, which needs root, or user namespaces (`unshare`). Without them the status is 77.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCENE = ["ezyroller/driven", "--until", "2", "--vary", "m0=1:4.8:0.2", "--vary", "omega=1:4.8:0.2", "--part", "50"]
SWEEPS = {
    "rows": (SCENE + ["--keep", "C.x,max:seat.vx"], [8, 16, 28]),
    "trajectories": (SCENE + ["--keep", "C.x,samples", "--every", "0.1"], [100, 700, 1500]),
}
N_CASES = 400


def files(folder):
    return {path.relative_to(folder): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def n_rows(folder):
    """Whole rows, headings left out."""
    return sum(max(path.read_bytes().count(b"\n") - 1, 0) for path in folder.glob("part-*"))


def sweep(ezy, arguments, out):
    done = subprocess.run([ezy, "sweep", *arguments, "--out", out, "--resume"], capture_output=True, text=True)
    return done.returncode, done.stderr


def room(mount, kilobytes):
    subprocess.run(["mount", "-o", f"remount,size={kilobytes}k", mount], check=True)


def check(ezy, name, disk, whole):
    arguments, sizes = SWEEPS[name]
    n_full = 0
    for kilobytes in sizes:
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "tmpfs", disk], check=True)
        try:
            out = disk / "sweep"
            status, message = sweep(ezy, arguments, out)
            # no row is lost, and none is written twice, where it stays full
            before = n_rows(out)
            again, _ = sweep(ezy, arguments, out)
            assert status == again == 1 and n_rows(out) >= before, (status, again, before, n_rows(out), message)
            assert "No space left" in message and "what was computed is kept" in message, message
            n_full += 2
            room(disk, 1 << 16)
            status, message = sweep(ezy, arguments, out)
            assert status == 0, message
            assert files(out) == whole, "the files differ from those of a sweep with room"
            print(f"{name}: full at {kilobytes} kB with {before} of {N_CASES} rows; the same bytes in the end")
        finally:
            subprocess.run(["umount", disk], check=True)
    assert n_full == 2 * len(sizes)


def main():
    ezy = sys.argv[1]
    if os.environ.get("EZY_FULL_DISK") is None:
        # a name space of its own, where mounting is allowed and ends with it
        inside = ["unshare", "--map-root-user", "--mount"]
        with tempfile.TemporaryDirectory() as folder:
            mount = "mount -t tmpfs -o size=16k tmpfs . && mount -o remount,size=32k $PWD"
            can = shutil.which("unshare") and subprocess.run([*inside, "sh", "-c", mount], cwd=folder, capture_output=True).returncode == 0
        if not can:
            print("skipped: there is no `unshare` that may mount a small disk")
            sys.exit(77)
        words = [*inside, sys.executable, __file__, ezy]
        sys.exit(subprocess.run(words, env={**os.environ, "EZY_FULL_DISK": "1"}).returncode)
    with tempfile.TemporaryDirectory() as folder:
        disk = pathlib.Path(folder) / "disk"
        disk.mkdir()
        for name, (arguments, _) in SWEEPS.items():
            out = pathlib.Path(folder) / name
            status, message = sweep(ezy, arguments, out)
            assert status == 0, message
            check(ezy, name, disk, files(out))


if __name__ == "__main__":
    main()
