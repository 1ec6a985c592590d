"""Faults in the midst of an acquisition: a sentence that says so, a session that is whole, nothing good that is wrong,
and a way to go on to a complete model without losing a scan."""

import os
import pathlib
import shutil
import signal
import stat
import threading
import time
import unittest

from laboratory import Case, STRIPE, end, object_file, wait_until
from programs import Programs

VIEWS = "4"


def in_move(number, do, **more):
    return {"at": {"move": number, "fraction": 0.5}, "do": do, **more}


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


class Table(Fault):
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


class Files(Fault):
    """The scanner's program, at its third file."""

    def setUp(self):
        super().setUp()
        self.table()

    def deliver_well(self, number, file, name=None):
        hidden = self.scans / (name or file.name + ".part")
        shutil.copy(file, hidden)
        os.rename(hidden, self.scans / (name or file.name))

    def spoiled(self, number, file):
        """What comes before the third file."""

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
        self.vendor_out = self.folder / "metres"
        def spoil(file):
            self.write_in_metres(file)
        ended = self.with_courier(spoil, then=False)
        scans = self.expect_failure(ended, "say --unit m")
        ended = self.resume(self.sensor, self.address, "--max-views", VIEWS, limit=200)
        self.expect_good(ended)
        self.assertGreaterEqual(self.info()["scans"], scans)

    def write_in_metres(self, file):
        """The same grid, every coordinate a thousandth."""
        import struct
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


class Camera(Fault):
    def with_camera(self, **more):
        from whole_runs_test import CAMERA
        import json
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


class Program(Programs, Fault):
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
