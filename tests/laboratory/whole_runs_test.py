"""A complete model by itself, with every kind of device; as complete as with the simulated scanner of that profile."""

import json
import os
import pathlib
import struct
import subprocess
import unittest

from laboratory import Case, STRIPE, object_file
from programs import Programs

CAMERA = {
    "name": "Depth camera over a table",
    "scanner": {"type": "pinhole", "position": [450, 0, 250], "look_at": [0, 0, 60], "rows": 239, "columns": 319,
                "horizontal_fov_deg": 57.83, "vertical_fov_deg": 45.0, "receivers": [[75, 0, 0]],
                "breakdown_angle_deg": 70, "range_mm": [300, 1500], "noise": {"range_sigma_mm": 0.3}},
    "workspace": {"type": "turntable", "steps": 36},
    "viewing_volume": {"radius_mm": 100, "height_mm": 150},
    "mechanics": {"angle_sigma_deg": 0.3, "position_sigma_mm": 0.3}}
FORMATS = ("ply-range-grid", "ply-points", "ptx", "pcd", "pcd-binary", "xyz-grid", "asc", "png16")
WAYS = ("whole", "slow", "rename", "burst", "truncated-then-complete")


def points_of(ply):
    """The vertices of a binary PLY that begin with three floats."""
    data = pathlib.Path(ply).read_bytes()
    header, body = data.split(b"end_header\n", 1)
    count, size, vertex = 0, 0, False
    widths = {"float": 4, "double": 8, "uchar": 1, "int": 4, "uint": 4, "short": 2, "ushort": 2, "char": 1}
    for line in header.decode().splitlines():
        word = line.split()
        if word[0] == "element":
            vertex = word[1] == "vertex"
            count = int(word[2]) if vertex else count
        elif word[0] == "property" and vertex:
            size += widths[word[1]]
    return [struct.unpack_from("<3f", body, i * size) for i in range(count)]


class Runs(Programs, Case):
    def expect_complete(self, ended, mesh, profile=STRIPE, noise=0.1, codes=(0, 4)):
        self.assertIn(ended.code, codes, ended.err)
        self.assertEqual(ended.report()["terminated_by"], "finished", ended.err)
        found = self.evaluate(mesh, profile)
        simulated = self.simulated(mesh, profile)
        line = "%s: %d views, covered %.4f (simulated %.4f), RMS %.4f mm (simulated %.4f), false %.5f (simulated %.5f)" % (
            self.id().split(".", 1)[1], len(ended.report()["views"]), found["coverage_of_scannable"],
            simulated["coverage_of_scannable"], found["rms_mm"], simulated["rms_mm"], found["false_surface"],
            simulated["false_surface"])
        print(line, flush=True)
        self.assertGreaterEqual(found["coverage_of_scannable"], simulated["coverage_of_scannable"] - 0.01, line)
        # Where the samples are far apart their triangles, too, leave the surface: also with the simulated scanner.
        self.assertLessEqual(found["rms_mm"], max(1.2 * noise, 1.02 * simulated["rms_mm"]), line)
        self.assertLessEqual(found["false_surface"], 0.0005 + 2.0 * simulated["false_surface"], line)
        self.expect_nothing_else()
        self.info()

    def expect_nothing_else(self):
        """Neither table nor wall: nothing below the table's top, nothing outside of the object's reach."""
        points = points_of(self.out / "model.ply")
        self.assertGreater(min(z for _, _, z in points), -1.0)
        self.assertLess(max((x * x + y * y) ** 0.5 for x, y, _ in points), 75.0)

    def simulated(self, mesh, profile):
        out = self.folder / "simulated"
        ended = self.run_cli("acquire", "--object", object_file(mesh), "--scanner", profile, "--out", out, "--json")
        self.assertIn(ended.code, (0, 4), ended.err)
        return self.evaluate(mesh, profile, out / "session.vantage")

    def write_camera_profile(self):
        path = self.folder / "camera_profile.json"
        path.write_text(json.dumps(CAMERA))
        return path

    def write_pinhole(self):
        path = self.folder / "pinhole.json"
        path.write_text(json.dumps(CAMERA | {"scanner": CAMERA["scanner"] | {"noise": {"range_sigma_mm": 0.1}}}))
        return path

    def with_folder(self, mesh, *options, table=("grbl",)):
        self.table(*table)
        self.vendor("--binary", *options, mesh=mesh)
        return self.acquire("folder:%s" % self.scans, "serial:%s" % self.port)

    def with_camera(self, mesh, **more):
        profile = self.write_camera_profile()
        self.table()
        self.camera(mesh, **more)
        ended = self.acquire("openni2", "serial:%s,grbl" % self.port, profile=profile)
        self.expect_complete(ended, mesh, profile, noise=0.3 + 1.5 * 0.45 ** 2)


class WholeRun(Runs):
    def test_mug_grbl_camera(self):
        self.with_camera("mug")

    def test_candle_holder_grbl_camera(self):
        self.with_camera("candle_holder")

    def test_mug_grbl_folder(self):
        self.expect_complete(self.with_folder("mug"), "mug")

    def test_candle_holder_grbl_folder(self):
        self.expect_complete(self.with_folder("candle_holder"), "candle_holder")

    def test_wall_and_large_table(self):
        self.expect_complete(self.with_folder("mug", "--wall", "160", "--table-radius", "250"), "mug")

    def test_horus(self):
        self.expect_complete(self.with_folder("mug", table=("horus",)), "mug")

    def test_marlin(self):
        self.expect_complete(self.with_folder("mug", table=("marlin",)), "mug")

    def test_fabscan(self):
        self.expect_complete(self.with_folder("mug", table=("fabscan",)), "mug")

    def test_comxim(self):
        self.expect_complete(self.with_folder("mug", table=("comxim",)), "mug")

    def with_programs(self, mesh):
        ended = self.run_cli("acquire", "--rig", self.rig(mesh), "--out", self.out, "--json")
        self.expect_complete(ended, mesh)

    def test_mug_programs(self):
        self.with_programs("mug")

    def test_candle_holder_programs(self):
        self.with_programs("candle_holder")

    def with_hand(self, mesh):
        process = self.begin("acquire", "--sensor", "folder:%s" % self.scans, "--table", "hand", "--events", "--scanner",
                             STRIPE, "--out", self.out, stdin=subprocess.PIPE)
        count, ended = 0, None
        for line in process.stdout:
            event = json.loads(line)
            ended = event if event["event"] == "done" else ended
            if event["event"] != "turn":
                continue
            count += 1
            process.stdin.write("done\n")
            process.stdin.flush()
            # A person meets an angle to a few degrees.
            angle = event["table_deg"] + (0, 4, -6, 3, -2, 5)[count % 6] * (count > 1)
            self.scan_once(mesh, count, angle)
        err = process.stderr.read()
        code = process.wait()
        for stream in (process.stdin, process.stdout, process.stderr):
            stream.close()
        self.assertIn(code, (0, 4), err)
        self.assertIsNotNone(ended, err)
        self.assertEqual(ended["terminated_by"], "finished", err)
        report = json.loads((self.out / "report.json").read_text())
        found, simulated = self.evaluate(mesh), self.simulated(mesh, STRIPE)
        print("%s: %d views, covered %.4f (simulated %.4f), RMS %.4f mm, false %.5f" % (
            self.id().split(".", 1)[1], len(report["views"]), found["coverage_of_scannable"],
            simulated["coverage_of_scannable"], found["rms_mm"], found["false_surface"]), flush=True)
        self.assertGreaterEqual(found["coverage_of_scannable"], simulated["coverage_of_scannable"] - 0.01)
        self.assertLessEqual(found["rms_mm"], 0.12)
        self.assertLessEqual(found["false_surface"], 0.0005)
        self.expect_nothing_else()

    def scan_once(self, mesh, number, angle):
        subprocess.run([self.lab / "lab_vendor", "--mesh", object_file(mesh), "--profile", STRIPE, "--angle", str(angle),
                        "--out", self.folder / "by_hand", "--name", "s%03d.ply" % number, "--binary", "--seed",
                        str(number)], check=True, stdout=subprocess.DEVNULL)
        os.rename(self.folder / "by_hand" / ("s%03d.ply" % number), self.scans / ("s%03d.ply" % number))

    def test_mug_hand(self):
        self.with_hand("mug")

    def test_candle_holder_hand(self):
        self.with_hand("candle_holder")


class Folder(Runs):
    """Every format and way of writing: few views, nothing lost, every one at its place."""

    def few_views(self, *options, profile=STRIPE):
        self.table()
        self.vendor(*options, profile=profile)
        ended = self.acquire("folder:%s" % self.scans, "serial:%s,grbl" % self.port, "--max-views", "3", profile=profile,
                             limit=400)
        self.assertEqual(ended.code, 4, ended.err)
        report = ended.report()
        self.assertEqual(report["terminated_by"], "max_views", ended.err)
        # A view of a mug that shows little of its handle is held by the table alone until another joins it.
        told = [w for w in report["warnings"] if w["code"] != "ended_early" and "the mechanics' word alone" not in w["text"]]
        self.assertEqual(told, [], ended.err)
        self.assertEqual(self.info()["rejected"], 0)
        found = self.evaluate(profile=profile)
        self.assertLessEqual(found["rms_mm"], 0.12, found)
        self.assertLessEqual(found["false_surface"], 0.0005, found)

    def every_way(self, kind):
        for way in WAYS:
            with self.subTest(format=kind, way=way):
                self.fresh()
                profile = self.write_pinhole() if kind == "png16" else STRIPE
                self.few_views("--format", kind, *binary_of(kind), "--write", way, "--write-seconds", "2",
                               profile=profile)

    def test_one_name_again_and_again(self):
        self.few_views("--name", "scan.ply")

    def test_frames(self):
        for kind, frame in (("asc", "camera"), ("xyz-grid", "opengl"), ("pcd", "camera")):
            with self.subTest(kind + " " + frame):
                self.fresh()
                self.few_views("--format", kind, "--frame", frame)

    def fresh(self):
        """A place for another run of the same case."""
        if self.started:
            self.tearDown()
            self.doCleanups()
            self.setUp()


class Formats(Runs):
    """A complete model from every format."""

    def complete(self, kind, mesh):
        profile = self.write_pinhole() if kind == "png16" else STRIPE
        self.table()
        self.vendor("--format", kind, *binary_of(kind), mesh=mesh, profile=profile)
        self.expect_complete(self.acquire("folder:%s" % self.scans, "serial:%s,grbl" % self.port, profile=profile), mesh,
                             profile)


def binary_of(kind):
    return ["--binary"] if kind == "ply-range-grid" else []


def add_cases():
    for kind in FORMATS:
        name = "test_" + kind.replace("-", "_")
        setattr(Folder, name, lambda self, kind=kind: self.every_way(kind))
        for mesh in ("mug", "candle_holder"):
            setattr(Formats, name + "_" + mesh, lambda self, kind=kind, mesh=mesh: self.complete(kind, mesh))


add_cases()

if __name__ == "__main__":
    unittest.main()
