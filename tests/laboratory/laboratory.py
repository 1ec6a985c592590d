"""Whole acquisitions with the stand-ins of a laboratory that is no part of the project.

VANTAGE_LAB names the folder that it was built in, VANTAGE_CLI the command line program. Every case has a folder of its
own, so that cases may run at the same time.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import threading
import time
import unittest

RESOURCES = pathlib.Path(__file__).resolve().parents[2] / "resources"
STRIPE = RESOURCES / "scanners" / "rotating_stripe.json"
PROGRAMS = ("lab_table", "lab_vendor", "lab_openni2_dir", "libLabCamera.so.0")


def object_file(name):
    return RESOURCES / "objects" / (name + ".ply")


class Ended:
    """What became of a run of the command line program."""

    def __init__(self, code, out, err, seconds):
        self.code, self.out, self.err, self.seconds = code, out, err, seconds

    def report(self):
        return json.loads(self.out)


class Case(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        lab = os.environ.get("VANTAGE_LAB")
        if not lab or not all((pathlib.Path(lab) / program).exists() for program in PROGRAMS):
            self.skipTest("no laboratory: set VANTAGE_LAB to the folder that it was built in")
        self.lab = pathlib.Path(lab)
        self.cli = os.environ["VANTAGE_CLI"]
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="vantage-lab-"))
        self.addCleanup(self.remove_folder)
        self.state = self.folder / "state.json"
        self.scans = self.folder / "scans"
        self.scans.mkdir()
        self.out = self.folder / "out"
        self.session = self.out / "session.vantage"
        self.environment = dict(os.environ)
        self.started = 0

    def remove_folder(self):
        keep = os.environ.get("VANTAGE_LAB_KEEP")
        if keep:
            shutil.copytree(self.folder, pathlib.Path(keep) / self.id().split(".", 1)[1], symlinks=True,
                            dirs_exist_ok=True, ignore=lambda folder, names: {"table"} & set(names))
        shutil.rmtree(self.folder, ignore_errors=True)

    # --- the stand-ins ------------------------------------------------------------------------------------------------

    def start(self, arguments, **more):
        """A program that ends with the case."""
        self.started += 1
        log = open(self.folder / ("program_%d.txt" % self.started), "w")
        process = subprocess.Popen([str(a) for a in arguments], stdout=more.pop("stdout", log), stderr=log, **more)
        self.addCleanup(end, process)
        log.close()
        return process

    def table(self, protocol="grbl", *options, faults=()):
        """A turntable; the name to reach it by is self.port."""
        self.port = self.folder / "table"
        with open(self.folder / "faults.json", "w") as file:
            json.dump(list(faults), file)
        process = self.start([self.lab / "lab_table", "--protocol", protocol, "--link", self.port, "--state", self.state,
                              "--log", self.folder / "wire.log", "--fault", self.folder / "faults.json", "--boot", "400",
                              "--speed", "90", "--accel", "360", *options])
        wait_until(lambda: self.port.exists() and self.state.exists(), "the table of the laboratory")
        return process

    def vendor(self, *options, mesh="mug", profile=STRIPE, out=None, **more):
        """A vendor's program that scans whenever the table has come to rest."""
        return self.start([self.lab / "lab_vendor", "--mesh", object_file(mesh), "--profile", profile, "--state",
                           self.state, "--out", out or self.scans, "--settle", "0.5", *options], **more)

    def courier(self, deliver, *options, **more):
        """A vendor's program whose files come to the folder as deliver(number, file) has it, from 1."""
        hidden = self.folder / "vendor"
        hidden.mkdir()
        program = self.vendor(*options, out=hidden, stdout=subprocess.PIPE, **more)

        def carry():
            with program.stdout as lines:
                for number, line in enumerate(lines, 1):
                    deliver(number, hidden / json.loads(line)["file"])
        threading.Thread(target=carry, daemon=True).start()
        return program

    def camera(self, mesh="mug", **more):
        """A depth camera that programs which are started from now on see."""
        self.configure_camera(mesh, **more)
        subprocess.run([self.lab / "lab_openni2_dir", self.folder / "openni"], check=True, stdout=subprocess.DEVNULL)
        self.environment["LAB_CAMERA"] = str(self.folder / "camera.json")
        self.environment["LD_LIBRARY_PATH"] = str(self.folder / "openni")

    def configure_camera(self, mesh="mug", **more):
        described = {"mesh": str(object_file(mesh)), "state": "state.json", "width": 320, "height": 240}
        (self.folder / "camera.json").write_text(json.dumps(described | more))

    # --- the program --------------------------------------------------------------------------------------------------

    def begin(self, *arguments, **more):
        return subprocess.Popen([self.cli] + [str(a) for a in arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, env=self.environment, cwd=self.folder, **more)

    def run_cli(self, *arguments, limit=400):
        begun = time.monotonic()
        process = self.begin(*arguments)
        try:
            out, err = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            self.fail("has not ended within %d s: %s\n%s" % (limit, arguments, err[-3000:]))
        return Ended(process.returncode, out, err, time.monotonic() - begun)

    def acquire(self, sensor, table, *options, profile=STRIPE, limit=400):
        return self.run_cli("acquire", "--sensor", sensor, "--table", table, "--scanner", profile, "--out", self.out,
                            "--json", *options, limit=limit)

    def resume(self, sensor, table, *options, limit=400):
        return self.run_cli("resume", self.session, "--sensor", sensor, "--table", table, "--json", *options, limit=limit)

    def info(self):
        ended = self.run_cli("info", self.session, "--json")
        self.assertEqual(ended.code, 0, ended.err)
        found = json.loads(ended.out)
        self.assertEqual(found["damages"], 0, ended.err)
        return found

    def evaluate(self, mesh="mug", profile=STRIPE, model=None):
        ended = self.run_cli("evaluate", model or self.session, "--object", object_file(mesh), "--scanner", profile,
                             "--json")
        self.assertEqual(ended.code, 0, ended.err)
        return json.loads(ended.out)


def end(process):
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(5)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def wait_until(condition, what, seconds=20):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise TimeoutError("waited %d s for %s" % (seconds, what))
        time.sleep(0.02)
