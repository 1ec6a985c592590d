"""An interrupt at any moment of a run: it ends at once, its session opens, and resume goes on to the end."""

import json
import os
import random
import signal
import subprocess
import time
import unittest

from laboratory import Case, STRIPE
from programs import Programs
from whole_runs_test import CAMERA

VIEWS = "3"
# Half a second is promised; a machine that is busy with other tests gets more.
LONGEST = float(os.environ.get("VANTAGE_LAB_LONGEST_STOP", "2"))
MOMENTS = int(os.environ.get("VANTAGE_LAB_STOPS", "4"))


class Stops(Programs, Case):
    def stop_somewhere(self, devices, seconds, evaluate_with=STRIPE):
        """Begins, is stopped, and is gone on with until nothing stops it, at moments of the first `seconds`."""
        dice = random.Random(self.id())
        slowest, begun_anew = 0.0, -1
        for moment in range(MOMENTS):
            last = moment + 1 == MOMENTS
            if self.session.exists():
                before = self.info()["scans"]
                arguments = ["resume", self.session, *devices]
            else:
                before = 0
                begun_anew += 1
                arguments = ["acquire", *devices, "--out", self.out]
                if "--rig" not in devices:
                    arguments += ["--scanner", evaluate_with]
            process = self.begin(*arguments, "--json", "--max-views", VIEWS)
            out = err = None
            try:
                out, err = process.communicate(timeout=300 if last else dice.uniform(0.0, seconds))
            except subprocess.TimeoutExpired:
                begun = time.monotonic()
                process.send_signal(signal.SIGINT)
                out, err = process.communicate(timeout=30)
                slowest = max(slowest, time.monotonic() - begun)
                # Before it has begun the signal itself ends it.
                self.assertIn(process.returncode, (-signal.SIGINT, 3, 4), err)
            if self.session.exists():
                self.assertGreaterEqual(self.info()["scans"], before)
            if process.returncode == 4:
                break
        print("%s: slowest stop %.2f s" % (self.id().split(".", 1)[1], slowest), flush=True)
        self.assertEqual(process.returncode, 4, err)
        self.assertLess(slowest, LONGEST)
        found = self.info()
        self.assertEqual((found["views"], found["rejected"]), (int(VIEWS), 0), err)
        if begun_anew and "--rig" not in devices:
            return  # the table was left in its first move: the model is turned by so much
        model = self.evaluate(profile=evaluate_with)
        self.assertLessEqual(model["rms_mm"], 0.12 if evaluate_with == STRIPE else 0.3, model)

    def test_table_and_folder(self):
        self.table()
        self.vendor("--binary")
        self.stop_somewhere(["--sensor", "folder:%s" % self.scans, "--table", "serial:%s,grbl" % self.port], 12)

    def test_table_that_does_not_tell(self):
        self.table("fabscan")
        self.vendor("--binary")
        self.stop_somewhere(["--sensor", "folder:%s" % self.scans, "--table", "serial:%s,fabscan" % self.port], 15)

    def test_slow_writing(self):
        self.table("marlin")
        self.vendor("--binary", "--write", "slow", "--write-seconds", "2")
        self.stop_somewhere(["--sensor", "folder:%s" % self.scans, "--table", "serial:%s,marlin" % self.port], 15)

    def test_camera(self):
        profile = self.folder / "camera_profile.json"
        profile.write_text(json.dumps(CAMERA))
        self.table()
        self.camera()
        self.stop_somewhere(["--sensor", "openni2", "--table", "serial:%s,grbl" % self.port], 12, profile)

    def test_programs(self):
        self.stop_somewhere(["--rig", self.rig("mug")], 6)

    def test_slow_programs(self):
        self.stop_somewhere(["--rig", self.rig("mug", every_scan="sleep 2", every_turn="sleep 2")], 12)


if __name__ == "__main__":
    unittest.main()
