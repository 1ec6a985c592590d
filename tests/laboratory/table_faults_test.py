"""Faults of the turntable, see faults.py."""

import os
import signal
import time
import unittest

from faults import Fault, VIEWS
from laboratory import STRIPE, end, wait_until


def in_move(number, do, **more):
    return {"at": {"move": number, "fraction": 0.5}, "do": do, **more}


class TableFaults(Fault):
    """The turntable, in the third move (the first goes to where the first scan is taken)."""

    def with_faults(self, *faults, protocol="grbl", options=()):
        self.process = self.table(protocol, *options, faults=faults)
        self.vendor("--binary")
        return self.acquire_some()

    def expect_unharmed(self, *faults, **more):
        self.expect_good(self.with_faults(*faults, **more))

    def test_split_lines(self):
        self.expect_unharmed({"at": {"time": 0}, "do": "split"})

    def test_garbage(self):
        self.expect_unharmed(in_move(2, "garbage", bytes=60), in_move(3, "garbage", bytes=200))

    def test_late_and_lost_answers(self):
        self.expect_unharmed({"at": {"move": 2}, "do": "late_ok", "count": 2}, {"at": {"move": 3}, "do": "lost_ok"})

    def test_short_silence(self):
        self.expect_unharmed(in_move(3, "silence", seconds=4))

    def test_slow(self):
        self.expect_unharmed(in_move(3, "slow", factor=0.2))

    def test_reset(self):
        ended = self.with_faults(in_move(3, "reset"))
        scans = self.expect_failure(ended, "has restarted by itself")
        self.expect_found_again(scans)

    def test_alarm(self):
        ended = self.with_faults(in_move(3, "alarm", code=1))
        scans = self.expect_failure(ended, "a limit switch was touched")
        self.expect_found_again(scans)

    def test_silence(self):
        ended = self.with_faults(in_move(3, "silence", seconds=12))
        scans = self.expect_failure(ended, "has not answered for 8 s")
        time.sleep(4)
        self.expect_found_again(scans)

    def test_unplugged_and_plugged_in_again(self):
        ended = self.with_faults(in_move(3, "unplug", seconds=2))
        scans = self.expect_failure(ended, "was unplugged")
        wait_until(self.port.exists, "the table to be plugged in again")
        self.expect_found_again(scans)

    def test_unplugged_for_ever(self):
        ended = self.with_faults(in_move(3, "unplug"))
        scans = self.expect_failure(ended, "was unplugged")
        again = self.resume(self.sensor, self.address, "--max-views", VIEWS)
        self.assertEqual(again.code, 1, again.err)
        self.assertIn("there is no such port; plug the table in", again.err)
        end(self.process)
        self.table()
        self.expect_goes_on(scans, rejected=3)

    def test_switched_off_and_on(self):
        self.process = self.table()
        self.vendor("--binary")
        process = self.begin("acquire", "--sensor", self.sensor, "--table", self.address, "--scanner", STRIPE, "--out",
                             self.out, "--max-views", VIEWS)
        wait_until(lambda: len(list(self.scans.iterdir())) >= 3, "scans", 60)
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, err)
        self.assertIn("was unplugged or switched off", err)
        scans = self.info()["scans"]
        os.unlink(self.port)
        self.table()
        self.expect_goes_on(scans, rejected=3)

    def test_refusal(self):
        ended = self.with_faults(in_move(2, "error", code=20))
        if ended.code == 4:
            return self.expect_good(ended)
        scans = self.expect_failure(ended, "refused to turn")
        self.expect_goes_on(scans)

    def test_door(self):
        ended = self.with_faults(in_move(3, "door"))
        scans = self.expect_failure(ended, "safety door is open")
        self.expect_goes_on(scans)

    def test_jam(self):
        ended = self.with_faults(in_move(3, "jam"))
        scans = self.expect_failure(ended, "is stuck")
        self.expect_found_again(scans)

    def expect_noticed(self, *faults):
        """The table says that it stands where it does not: the scan counts where it fits, and that is said."""
        ended = self.with_faults(*faults)
        self.assertIn(ended.code, (1, 4), ended.err)
        report = ended.report() if ended.code == 4 else {"views": [], "warnings": []}
        model = self.evaluate()
        self.assertLessEqual(model["false_surface"], 0.0005, "%s\n%s" % (model, ended.err))
        self.assertLessEqual(model["rms_mm"], 0.12, "%s\n%s" % (model, ended.err))
        told = [w for w in report["warnings"] if w["code"].startswith("scan_")]
        self.assertTrue(told, ended.err)
        self.info()
        return ended

    def test_stalled_motor(self):
        self.expect_noticed(in_move(3, "stall", fraction=0.7))

    def test_reversed_motor(self):
        ended = self.expect_noticed(in_move(3, "reverse"))
        self.assertIn("where the table would have turned the other way", ended.err)

    def test_bumped_plate(self):
        self.expect_noticed({"at": {"move": 3, "fraction": 0.99}, "do": "bump", "deg": 9})

    def test_turns_the_other_way(self):
        ended = self.with_faults(options=("--direction", "cw"))
        self.assertNotEqual(ended.code, 0)
        self.assertIn("where the table would have turned the other way", ended.err)
        self.assertIn("its sense is -1", ended.err)


if __name__ == "__main__":
    unittest.main()
