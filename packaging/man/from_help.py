#!/usr/bin/env python3
"""Writes what follows from the commands of vantage-cli: its man page and the completion of bash.

    from_help.py VANTAGE_CLI FOLDER        writes man/vantage-cli.1 and completion/vantage-cli into a folder
    from_help.py VANTAGE_CLI FOLDER --check   compares them with what is there; exit code 1 when they differ
"""
import dataclasses
import pathlib
import re
import subprocess
import sys


@dataclasses.dataclass
class Option:
    names: list          # ["-h", "--help"]; of a positional its name
    value: str           # what it takes, "" for a flag
    choices: list        # that it takes, where these are few
    required: bool
    help: str


@dataclasses.dataclass
class Command:
    name: str
    help: str
    positionals: list
    options: list


def help_of(cli, *arguments):
    return subprocess.run([cli, *arguments, "--help"], check=True, capture_output=True, text=True).stdout


def sections_of(text):
    """Lines of a help text by the title of their section."""
    sections, title = {}, "description"
    for line in text.splitlines():
        if re.fullmatch(r"[A-Z][a-z]+:", line):
            title = line[:-1]
        elif not line.startswith(" ") and title != "description":
            title = "rest"
        sections.setdefault(title, []).append(line)
    return sections


def entries_of(lines):
    """(names and value, help) of a table; a help text that is wrapped or in the next line belongs to the entry."""
    entries = []
    for line in lines:
        if not line.strip() or re.fullmatch(r"[A-Z][a-z]+:", line):
            continue
        if re.match(r"  \S", line):
            parts = re.split(r" {2,}", line.strip(), maxsplit=1)
            entries.append([parts[0], parts[1] if len(parts) > 1 else ""])
        else:
            entries[-1][1] = (entries[-1][1] + " " + line.strip()).strip()
    return entries


def option_of(left, text):
    names, _, value = left.partition(" ")
    required = value.endswith("REQUIRED")
    value = value.removesuffix("REQUIRED").strip()
    # "--jobs excludes ..." is said by CLI11 behind the value.
    value = re.sub(r"\s*(Excludes|Needs):.*$", "", value)
    value = re.sub(r"=[^ ]*$", "", value)
    choices = []
    if found := re.search(r"\{([^}]*)\}", value):
        choices = found.group(1).split(",")
    many = value.endswith("...")
    value = value.removesuffix("...").strip()
    kind = value.split(":")[0]
    return Option(names.split(","), kind + (" ..." if many else ""), choices, required, text)


def command_of(cli, name, about):
    sections = sections_of(help_of(cli, name))
    read = {title: [option_of(*entry) for entry in entries_of(sections.get(title, []))]
            for title in ("Positionals", "Options")}
    return Command(name, about, read["Positionals"], read["Options"])


def commands_of(cli):
    sections = sections_of(help_of(cli))
    return [command_of(cli, name, about) for name, about in entries_of(sections["Subcommands"])]


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(['.])", r"\\&\1", text)


def option_page(option):
    names = ", ".join("\\fB" + roff(name) + "\\fR" for name in option.names)
    value = " \\fI" + roff(option.value) + "\\fR" if option.value else ""
    about = option.help + (" Needed." if option.required else "")
    if option.choices:
        about += " One of " + ", ".join(option.choices) + "."
    return ".TP\n" + names + value + "\n" + roff(about) + "\n"


def command_page(command):
    needed = [f"\\fB{roff(option.names[-1])}\\fR \\fI{roff(option.value)}\\fR" for option in command.options if option.required]
    files = ["\\fI" + roff(p.names[0]) + "\\fR" + (" ..." if p.value.endswith("...") else "") for p in command.positionals]
    text = ".SS vantage\\-cli " + " ".join([command.name, *files, *needed, "[options]"]) + "\n" + roff(command.help) + ".\n"
    for option in command.positionals:
        text += ".TP\n\\fI" + roff(option.names[0]) + "\\fR\n" + roff(option.help) + "\n"
    return text + "".join(option_page(o) for o in command.options if o.names[-1] not in COMMON)


COMMON = ("--help", "--json", "--threads")


def man_page(template, commands):
    common = [o for o in commands[0].options if o.names[-1] in COMMON]
    text = template.replace("@COMMANDS@\n", "".join(command_page(c) for c in commands))
    return text.replace("@COMMON@\n", "".join(option_page(o) for o in common))


def completion(template, commands):
    cases = ""
    for command in commands:
        names = " ".join(name for option in command.options for name in option.names)
        cases += f'    {command.name}) options="{names}" ;;\n'
    values = ""
    for command in commands:
        for option in command.options:
            if option.choices:
                values += f'    {command.name}:{option.names[-1]}) values="{" ".join(option.choices)}" ;;\n'
    valued = sorted({name for c in commands for o in c.options if o.value for name in o.names})
    text = template.replace("@COMMANDS@", " ".join(c.name for c in commands))
    return text.replace("@VALUED@", "|".join(valued)).replace("@OPTIONS@\n", cases).replace("@VALUES@\n", values)


def main():
    cli, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    here = pathlib.Path(__file__).resolve().parents[1]
    commands = commands_of(cli)
    made = {
        "man/vantage-cli.1": man_page((here / "man/vantage-cli.1.in").read_text(), commands),
        "completion/vantage-cli": completion((here / "completion/vantage-cli.in").read_text(), commands),
    }
    different = [name for name, text in made.items()
                 if not (folder / name).exists() or (folder / name).read_text() != text]
    if "--check" in sys.argv:
        for name in different:
            print(f"{folder / name} is not what the commands are: run packaging/man/from_help.py VANTAGE_CLI packaging")
        sys.exit(1 if different else 0)
    for name, text in made.items():
        (folder / name).write_text(text)


if __name__ == "__main__":
    main()
