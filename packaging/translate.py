#!/usr/bin/env python3
"""The languages of the window.

translate.py            takes what changed in the sources into all of resources/translations
translate.py fr pt_BR   begins further languages there: fill in the file with linguist or an editor, and build
translate.py --check    changes nothing; says what is missing, left over or does not fit, and fails if anything does

A language needs nothing else: the build embeds what lies in resources/translations, and the window offers it.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parent.parent
LITERALS = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
WORDS = re.compile(r"\bwords\(\s*" + LITERALS)
ANY_WORDS = re.compile(r"\breturn words\(|[=,({?:]\s*words\(")
FIELD = re.compile(r"\b(number|whole|text|choice|onOff)<[^;]*?>\(\s*(?:Basic|Expert|Session)\s*,\s*(.*?)\),?\n", re.S)
GROUP = re.compile(r'\{"[a-z]*",\s*(".*?")\}')
PLACE = re.compile(r"%(?:L?\d+|n)")


def lupdate():
    found = shutil.which("lupdate", path="/usr/lib/qt6/bin") or shutil.which("lupdate")
    if not found:
        sys.exit("translate.py: lupdate is missing, see packaging/dependencies")
    return found


def joined(literals):
    """The literals of one text, as one literal."""
    return '"' + "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals)) + '"'


def phrases(root):
    """What core has words for: patterns of Phrase, in the context that the window translates them in."""
    for source in sorted((root / "core").rglob("*.cpp")):
        text = source.read_text(encoding="utf-8")
        literal = {match.start() for match in WORDS.finditer(text)}
        for match in ANY_WORDS.finditer(text):
            if text.index("words(", match.start()) not in literal:
                line = text.count("\n", 0, match.start()) + 1
                sys.exit(f"{source}:{line}: words() has no literal, so it cannot be translated")
        for match in WORDS.finditer(text):
            if joined(match.group(1)) != '""':
                yield "Phrase", joined(match.group(1))


def arguments(text):
    """The literals between the commas of a call."""
    return [joined(part) for part in re.findall(LITERALS, text)]


def settings(root):
    """Names, units and explanations of the options."""
    table = (root / "core/acquisition/settings_table.cpp").read_text(encoding="utf-8")
    for match in FIELD.finditer(table):
        given = arguments(match.group(2))
        wanted = [given[1], given[-1]] + ([given[2]] if match.group(1) == "number" else [])
        yield from (("Settings", text) for text in wanted if text != '""')
    lookup = (root / "core/acquisition/setting_lookup.cpp").read_text(encoding="utf-8")
    yield from (("Settings", match.group(1)) for match in GROUP.finditer(lookup))


def update(root, files):
    """Runs lupdate. @return what it complained of"""
    with tempfile.TemporaryDirectory() as folder:
        texts = pathlib.Path(folder) / "core_texts.cpp"
        texts.write_text("".join(f"QT_TRANSLATE_NOOP(\"{context}\", {text});\n"
                                 for context, text in [*phrases(root), *settings(root)]), encoding="utf-8")
        run = subprocess.run([lupdate(), root / "app", root / "widgets", texts, "-extensions", "cpp,h",
                              "-locations", "none", "-no-obsolete", "-source-language", "en", "-ts", *files],
                             capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"translate.py: {run.stderr or run.stdout}")
    return [line for line in run.stderr.splitlines() if "lacks Q_OBJECT" in line or "Cannot" in line]


def messages(file):
    """(context, source, comment) -> the entry."""
    found = {}
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            comment = message.findtext("comment") or ""
            found[(context.findtext("name"), message.findtext("source"), comment)] = message
    return found


def texts_of(message):
    translation = message.find("translation")
    forms = translation.findall("numerusform")
    return [form.text or "" for form in forms] if forms else [translation.text or ""]


def faults_of(key, message):
    """What is wrong with one entry."""
    _, source, _ = key
    translation = message.find("translation")
    if translation.get("type"):
        yield translation.get("type")
    for text in texts_of(message):
        if not text:
            yield "empty"
            continue
        places, own = sorted(set(PLACE.findall(source))), sorted(set(PLACE.findall(text)))
        # A plural form may say "one" in words.
        if places != own and not (message.get("numerus") and sorted({*own, "%n"}) == places):
            yield f"places {' '.join(own) or 'none'} in the place of {' '.join(places) or 'none'}: {text}"
        if letter(source) != letter(text):
            yield f"a letter to reach it by is there in one only: {text}"
        for tag in ("<a ", "</a>", "<b>", "\n", "(*."):
            if source.count(tag) != text.count(tag):
                yield f"{tag.strip() or 'line ends'} not as in the source: {text}"


def letter(text):
    return re.search(r"&(?=[^\s&])(?!\w+;)", text) is not None


def check(root, folder):
    faults = []
    files = sorted(folder.glob("*.ts"))
    if not files:
        faults.append(f"{folder}: no language")
    with tempfile.TemporaryDirectory() as copies:
        copied = [shutil.copy(file, copies) for file in files]
        faults += update(root, copied)
        for file, copy in zip(files, copied):
            known, wanted = messages(file), messages(copy)
            for key in wanted.keys() - known.keys():
                faults.append(f"{file.name}: {key[0]}: missing: {key[1]}")
            for key in known.keys() - wanted.keys():
                faults.append(f"{file.name}: {key[0]}: in no source any more: {key[1]}")
            for key, message in known.items():
                faults += [f"{file.name}: {key[0]}: {key[1]}: {fault}" for fault in faults_of(key, message)]
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("languages", nargs="*", help="languages to begin, as de or zh_CN")
    parser.add_argument("--check", action="store_true", help="change nothing, fail when anything is missing or wrong")
    parser.add_argument("--sources", type=pathlib.Path, default=ROOT, help="root of the sources")
    given = parser.parse_args()
    folder = given.sources / "resources/translations"
    if given.check:
        faults = check(given.sources, folder)
        print("\n".join(faults) or "every text is translated")
        return 1 if faults else 0
    folder.mkdir(parents=True, exist_ok=True)
    for language in given.languages:
        if not re.fullmatch(r"[a-z]{2,3}(_[A-Z]{2})?", language):
            sys.exit(f"translate.py: '{language}' is no language: expected it as de or zh_CN")
    begun = [folder / f"vantage_{language}.ts" for language in given.languages]
    files = sorted({*folder.glob("*.ts"), *begun})
    print("\n".join(update(given.sources, files)))
    for file in files:
        open_ = sum(message.find("translation").get("type") is not None for message in messages(file).values())
        print(f"{file.name}: {len(messages(file))} texts, {open_} to be translated")
    return 0


if __name__ == "__main__":
    sys.exit(main())
