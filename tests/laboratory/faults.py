"""Faults in the midst of an acquisition: a sentence that says so, a session that is whole, nothing good that is wrong,
and a way to go on to a complete model without losing a scan."""

from laboratory import Case

VIEWS = "4"


class Fault(Case):
    def setUp(self):
        super().setUp()
        self.sensor = "folder:%s" % self.scans
        self.address = "serial:%s" % (self.folder / "table")

    def acquire_some(self, limit=200):
        return self.acquire(self.sensor, self.address, "--max-views", VIEWS, limit=limit)

    def expect_failure(self, ended, *sentences):
        """The work failed, said why, and left a session with the scans before."""
        self.assertEqual(ended.code, 1, ended.err)
        for sentence in sentences:
            self.assertIn(sentence, ended.err)
        found = self.info()
        self.assertGreaterEqual(found["scans"], 1, ended.err)
        self.assertEqual(found["rejected"], 0)
        return found["scans"]

    def expect_good(self, ended, views=int(VIEWS), rejected=0):
        """All views that were asked for, and nothing in the model that is not the object."""
        self.assertIn(ended.code, (0, 4), ended.err)
        report = ended.report()
        self.assertEqual(report["terminated_by"], "max_views", ended.err)
        found = self.info()
        self.assertEqual(found["views"], views, ended.err)
        self.assertLessEqual(found["rejected"], rejected, ended.err)
        model = self.evaluate()
        self.assertLessEqual(model["rms_mm"], 0.12, "%s\n%s" % (model, ended.err))
        self.assertLessEqual(model["false_surface"], 0.0005, "%s\n%s" % (model, ended.err))
        return report

    def expect_goes_on(self, scans, **more):
        """With the devices as they are now; no scan is lost."""
        self.assertGreaterEqual(self.info()["scans"], scans)
        ended = self.resume(self.sensor, self.address, "--max-views", VIEWS, limit=200)
        return self.expect_good(ended, **more), ended

    def expect_found_again(self, scans):
        """The same of a table that stands anywhere: scans that fit nowhere are kept out until one does."""
        (report, ended) = self.expect_goes_on(scans, rejected=3)
        self.assertIn("the table was left in a move from position", ended.err)
        self.assertIn("away from where the table says it is", ended.err)
