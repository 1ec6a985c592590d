"""Faults of a scanner that writes files, see faults.py."""

import os
import shutil
import signal
import struct
import time
import unittest

from faults import Fault, VIEWS
from laboratory import STRIPE, end, object_file, wait_until


class FileFaults(Fault):
    """The scanner's program, at its third file."""

    def setUp(self):
        super().setUp()
        self.table()

    def deliver_well(self, number, file, name=None):
        hidden = self.scans / (name or file.name + ".part")
        shutil.copy(file, hidden)
        os.rename(hidden, self.scans / (name or file.name))

    def with_courier(self, spoil, *options, then=True):
        def deliver(number, file):
            if number == 3:
                spoil(file)
                time.sleep(1.5)
            if number != 3 or then:
                self.deliver_well(number, file)
        self.courier(deliver, "--binary", *options)
        return self.acquire_some()

    def test_half_written(self):
        def spoil(file):
            data = file.read_bytes()
            (self.scans / "half.ply").write_bytes(data[:len(data) // 2])
        self.expect_good(self.with_courier(spoil))

    def test_half_written_in_place(self):
        def spoil(file):
            data = file.read_bytes()
            (self.scans / file.name).write_bytes(data[:len(data) // 2])
        self.expect_good(self.with_courier(spoil))

    def test_unreadable(self):
        def spoil(file):
            (self.scans / "noise.ply").write_bytes(os.urandom(5000))
            (self.scans / "empty.ply").write_bytes(b"")
            (self.scans / "text.xyz").write_text("this is\nno scan\n")
            (self.scans / "notes.txt").write_text("1 2\n")
            (self.scans / "folder.ply").mkdir()
            os.symlink("/nowhere", self.scans / "link.ply")
        self.expect_good(self.with_courier(spoil))

    def test_scan_of_before_again(self):
        def spoil(file):
            shutil.copy(self.scans / "scan_002.ply", self.scans / "again.ply")
        self.expect_good(self.with_courier(spoil))

    def test_wrong_units(self):
        def spoil(file):
            self.write_in_metres(file)
        ended = self.with_courier(spoil, then=False)
        scans = self.expect_failure(ended, "say --unit m")
        ended = self.resume(self.sensor, self.address, "--max-views", VIEWS, limit=200)
        self.expect_good(ended)
        self.assertGreaterEqual(self.info()["scans"], scans)

    def write_in_metres(self, file):
        """The same grid, every coordinate a thousandth."""
        data = file.read_bytes()
        header, body = data.split(b"end_header\n", 1)
        count = int(header.split(b"element vertex ")[1].split()[0])
        points = struct.unpack_from("<%df" % (3 * count), body)
        metres = struct.pack("<%df" % (3 * count), *(p / 1000 for p in points))
        (self.scans / "metres.ply.part").write_bytes(header + b"end_header\n" + metres + body[12 * count:])
        os.rename(self.scans / "metres.ply.part", self.scans / "metres.ply")

    def test_folder_goes_away(self):
        def spoil(file):
            os.rename(self.scans, self.folder / "away")
        def deliver(number, file):
            if number < 3:
                self.deliver_well(number, file)
            elif number == 3:
                spoil(file)
        courier = self.courier(deliver, "--binary")
        ended = self.acquire_some()
        scans = self.expect_failure(ended, "the folder is gone or cannot be read")
        os.rename(self.folder / "away", self.scans)
        end(courier)
        self.vendor("--binary", "--name", "later_%03d.ply")
        self.expect_goes_on(scans)

    def test_missed_scan_is_waited_for_until_stopped(self):
        program = self.vendor("--binary", "--skip", "4")
        process = self.begin("acquire", "--sensor", self.sensor, "--table", self.address, "--scanner", STRIPE, "--out",
                             self.out, "--max-views", VIEWS)
        wait_until(lambda: len(list(self.scans.iterdir())) >= 3, "scans", 60)
        time.sleep(5)
        self.assertIsNone(process.poll())
        begun = time.monotonic()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=10)
        self.assertLess(time.monotonic() - begun, 1.0)
        self.assertEqual(process.returncode, 3, err)
        scans = self.info()["scans"]
        self.expect_goes_on(scans)

    def test_program_dies(self):
        program = self.vendor("--binary", "--count", "3")
        process = self.begin("acquire", "--sensor", self.sensor, "--table", self.address, "--scanner", STRIPE, "--out",
                             self.out, "--max-views", VIEWS)
        wait_until(lambda: program.poll() is not None, "the program to end", 60)
        time.sleep(3)
        self.vendor("--binary", "--name", "later_%03d.ply")
        out, err = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 4, err)
        self.assertEqual(self.info()["views"], int(VIEWS))

    def test_scans_of_another_scanner(self):
        def spoil(file):
            shutil.copy(object_file("mug"), self.scans / "mug.ply")
        self.expect_good(self.with_courier(spoil))


if __name__ == "__main__":
    unittest.main()
