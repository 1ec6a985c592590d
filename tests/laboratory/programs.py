"""Scanner and table as programs that are run."""

import json
import stat

from laboratory import STRIPE, object_file

ONCE = 'count=$(($(cat %s 2>/dev/null || echo 0) + 1)); echo $count > %s\nif [ $count = 3 ]; then :\n%s\nfi\n'


class Programs:
    def rig(self, mesh, scan_third="", turn_third="", every_scan="", every_turn="", timeout=60):
        """A rig whose programs do what is said, at their third call or at each; the table leaves the angle to the
        scanner."""
        scan = self.script("scan.sh", 'scan() {\nrm -rf scanning\n"%s" --mesh "%s" --profile "%s" --angle "$(cat angle)" '
                           '--seed "$position" --out scanning --count 1 --every 0.1 --binary > /dev/null && '
                           'mv scanning/*.ply "$file"\n}\nfile=$1 position=$2\n%s%s\nscan' %
                           (self.lab / "lab_vendor", object_file(mesh), STRIPE, self.at_third("scans_done", scan_third),
                            every_scan))
        turn = self.script("turn.sh", self.at_third("turns_done", turn_third) + every_turn + '\necho "$1" > angle; echo "$1"')
        rig = {"sensor": {"kind": "command", "run": [scan, "{file}", "{position}"], "timeout_s": timeout},
               "table": {"kind": "command", "run": [turn, "{angle}"], "timeout_s": timeout}, "scanner": str(STRIPE)}
        path = self.folder / "rig.json"
        path.write_text(json.dumps(rig))
        return path

    @staticmethod
    def at_third(counter, what):
        return ONCE % (counter, counter, what) if what else ""

    def script(self, name, body):
        path = self.folder / name
        path.write_text("#!/bin/sh\ncd '%s'\n%s\n" % (self.folder, body))
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return str(path)
