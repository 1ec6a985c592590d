#!/usr/bin/env python3
"""translate.py finds what is wrong with a translation, and begins a language. usage: translate_test.py SOURCES"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES = pathlib.Path(sys.argv.pop())


class Translate(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        for part in ("app", "widgets", "core", "resources/translations"):
            shutil.copytree(SOURCES / part, self.root / part)
        self.german = self.root / "resources/translations/vantage_de.ts"

    def tearDown(self):
        self.folder.cleanup()

    def run_with(self, *arguments):
        return subprocess.run([sys.executable, SOURCES / "packaging/translate.py", "--sources", self.root, *arguments],
                              capture_output=True, text=True, check=False)

    def replace(self, file, pattern, text):
        before = file.read_text(encoding="utf-8")
        after, count = re.subn(pattern, text, before, count=1, flags=re.S)
        self.assertEqual(count, 1, pattern)
        file.write_text(after, encoding="utf-8")

    def expect_fault(self, *parts):
        answer = self.run_with("--check")
        self.assertEqual(answer.returncode, 1, answer.stdout + answer.stderr)
        faults = [line for line in answer.stdout.splitlines() if all(part in line for part in parts)]
        self.assertEqual(len(faults), 1, answer.stdout)

    def test_nothing_is_said_of_what_is_whole(self):
        answer = self.run_with("--check")
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)

    def test_an_entry_that_is_gone_is_missed(self):
        self.replace(self.german, r"    <message>\n        <source>Ended by you\..*?</message>\n", "")
        self.expect_fault("Ended by you.", "missing")

    def test_an_entry_that_no_source_has_is_left_over(self):
        self.replace(self.german, r"<source>Ended by you\.</source>", "<source>Ended by nobody.</source>")
        self.expect_fault("Ended by nobody.", "in no source any more")

    def test_an_unfinished_entry_is_told(self):
        self.replace(self.german, r"<translation>Von Ihnen beendet\.", '<translation type="unfinished">Von Ihnen beendet.')
        self.expect_fault("Ended by you.", "unfinished")

    def test_other_places_for_values_are_told(self):
        self.replace(self.german, r">Scan %1 gehört", ">Scan %2 gehört")
        self.expect_fault("Scan %1 is not part of the model.", "places %2")

    def test_a_letter_that_was_forgotten_is_told(self):
        self.replace(self.german, r">&amp;Pause<", ">Pause<")
        self.expect_fault("&Pause", "a letter to reach it by")

    def test_new_words_of_core_are_missed(self):
        self.replace(self.root / "core/report/wording.cpp", r'words\("Opened again"\)', 'words("Opened " "anew")')
        answer = self.run_with("--check")
        self.assertEqual(answer.stdout.count("missing: Opened anew"), 2, answer.stdout)

    def test_words_without_a_literal_are_refused(self):
        self.replace(self.root / "core/report/wording.cpp", r'words\("Opened again"\)', "words(kAgain)")
        answer = self.run_with("--check")
        self.assertNotEqual(answer.returncode, 0)
        self.assertIn("no literal", answer.stderr)

    def test_a_language_is_begun_with_one_command(self):
        answer = self.run_with("fr")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        begun = (self.root / "resources/translations/vantage_fr.ts").read_text(encoding="utf-8")
        self.assertIn('language="fr', begun)
        self.assertEqual(begun.count("<source>"), self.german.read_text(encoding="utf-8").count("<source>"))
        self.assertEqual(self.run_with("--check").returncode, 1)

    def test_what_is_no_language_is_refused(self):
        self.assertNotEqual(self.run_with("../fr").returncode, 0)


if __name__ == "__main__":
    unittest.main()
