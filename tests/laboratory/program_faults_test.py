"""Faults of programs as scanner and table, see faults.py."""

import unittest

from faults import Fault, VIEWS
from programs import Programs


class ProgramFaults(Programs, Fault):
    """Programs as scanner and table, which do at the third call what the case says."""

    def acquire_some(self, limit=200):
        return self.run_cli("acquire", "--rig", self.rig_file, "--out", self.out, "--json", "--max-views", VIEWS,
                            limit=limit)

    def with_scan(self, third, timeout=60):
        self.rig_file = self.rig("mug", scan_third=third, timeout=timeout)
        return self.acquire_some()

    def with_turn(self, third, timeout=60):
        self.rig_file = self.rig("mug", turn_third=third, timeout=timeout)
        return self.acquire_some()

    def goes_on(self, ended, *sentences):
        scans = self.expect_failure(ended, *sentences)
        again = self.run_cli("resume", self.session, "--rig", self.rig_file, "--json", "--max-views", VIEWS, limit=200)
        self.expect_good(again)
        self.assertGreaterEqual(self.info()["scans"], scans)

    def test_scan_fails(self):
        self.goes_on(self.with_scan('echo "no laser" >&2; exit 3'), "exit code 3", "no laser")

    def test_scan_hangs(self):
        self.goes_on(self.with_scan("echo waiting; sleep 1000", timeout=4), "has not ended within 4 s", "waiting")

    def test_scan_writes_nothing(self):
        self.goes_on(self.with_scan("exit 0"), "wrote no file")

    def test_scan_writes_nonsense(self):
        self.goes_on(self.with_scan('head -c 4000 /dev/urandom > "$1"; exit 0'), "its file cannot be used")

    def test_scan_writes_half(self):
        self.goes_on(self.with_scan('scan; head -c 60000 "$1" > "$1.half"; mv "$1.half" "$1"; exit 0'),
                     "its file cannot be used")

    def test_scan_is_killed(self):
        self.goes_on(self.with_scan("kill -9 $$"), "exit code 137")

    def test_scan_says_endlessly(self):
        self.goes_on(self.with_scan("yes", timeout=4), "has not ended within 4 s")

    def test_scan_is_gone(self):
        self.goes_on(self.with_scan('exec /nowhere/scan "$1"'), "exit code")

    def test_turn_fails(self):
        self.goes_on(self.with_turn("echo stuck >&2; exit 1"), "exit code 1", "stuck")

    def test_turn_hangs(self):
        self.goes_on(self.with_turn("sleep 1000", timeout=4), "has not ended within 4 s")

    def test_turn_says_nonsense(self):
        ended = self.with_turn('echo "$1" > angle; echo "went to nan degrees or so"; exit 0')
        self.expect_good(ended)

    def test_turn_reports_another_angle(self):
        ended = self.with_turn('awk "BEGIN { print $1 + 5 }" > angle; cat angle; exit 0')
        self.expect_good(ended)

    def test_turn_lies(self):
        ended = self.with_turn('awk "BEGIN { print $1 + 25 }" > angle; echo "$1"; exit 0')
        model = self.evaluate()
        self.assertLessEqual(model["false_surface"], 0.0005, "%s\n%s" % (model, ended.err))
        self.assertTrue([w for w in ended.report()["warnings"] if w["code"].startswith("scan_")], ended.err)


if __name__ == "__main__":
    unittest.main()
