"""Faults of a depth camera, see faults.py."""

import json
import unittest

from faults import Fault, VIEWS
from whole_runs_test import CAMERA


class CameraFaults(Fault):
    def with_camera(self, **more):
        self.profile = self.folder / "camera_profile.json"
        self.profile.write_text(json.dumps(CAMERA))
        self.sensor = "openni2"
        self.table()
        self.camera(**more)
        return self.acquire(self.sensor, self.address, "--max-views", VIEWS, profile=self.profile, limit=300)

    def expect_camera_good(self, ended):
        self.assertEqual(ended.code, 4, ended.err)
        self.assertEqual(ended.report()["terminated_by"], "max_views", ended.err)
        self.assertEqual(self.info()["views"], int(VIEWS), ended.err)
        model = self.evaluate(profile=self.profile)
        self.assertLessEqual(model["rms_mm"], 0.3, model)

    def goes_on(self, scans):
        self.configure_camera()
        self.assertGreaterEqual(self.info()["scans"], scans)
        self.expect_camera_good(self.resume(self.sensor, self.address, "--max-views", VIEWS, limit=300))

    def test_unplugged_for_a_moment(self):
        self.expect_camera_good(self.with_camera(faults=[{"at_frame": 60, "do": "disconnect", "back_after_s": 3}]))

    def test_unplugged(self):
        ended = self.with_camera(faults=[{"at_frame": 60, "do": "disconnect"}])
        self.goes_on(self.expect_failure(ended, "disconnected"))

    def test_hangs_for_a_moment(self):
        self.expect_camera_good(self.with_camera(faults=[{"at_frame": 60, "do": "freeze", "seconds": 4}]))

    def test_hangs(self):
        ended = self.with_camera(faults=[{"at_frame": 60, "do": "freeze", "seconds": 1000}])
        self.assertIn(ended.code, (1, 4), ended.err)
        if ended.code == 1:
            self.goes_on(self.expect_failure(ended, "it has sent no picture"))

    def test_sees_nothing(self):
        ended = self.with_camera(faults=[{"at_frame": 60, "do": "black"}])
        self.goes_on(self.expect_failure(ended, "it sees nothing"))

    def test_repeats_itself(self):
        ended = self.with_camera(faults=[{"at_frame": 60, "do": "repeat"}])
        self.assertIn(ended.code, (1, 4), ended.err)
        if ended.code == 1:
            self.goes_on(self.expect_failure(ended, "the same picture again and again"))


if __name__ == "__main__":
    unittest.main()
