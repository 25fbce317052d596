#!/usr/bin/env python3
"""program_documents.py PROGRAM FOLDER: the manual page and the completion for bash of the program ompl_mfa, from what
its --help prints, into FOLDER/ompl_mfa.1 and FOLDER/ompl_mfa."""
import re
import subprocess
import sys
from pathlib import Path


def help_of(program, *command):
    """The description, and the sections (positionals, options, subcommands) as lists of names and meanings."""
    text = subprocess.run([program, *command, "--help"], check=True, capture_output=True, text=True).stdout
    description, sections, entries = text.splitlines()[0], {}, None
    for line in text.splitlines()[1:]:
        if re.fullmatch(r"[A-Z][A-Za-z]*:", line):
            entries = sections.setdefault(line[:-1], [])
        elif entries is not None and re.match(r"  \S", line):
            parts = re.split(r"\s{2,}", line.strip(), maxsplit=1)
            entries.append([parts[0], parts[1] if len(parts) > 1 else ""])
        elif entries and line.strip():
            entries[-1][1] = (entries[-1][1] + " " + line.strip()).strip()
    return description, sections


def troff(text):
    return text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")


def manual(version, description, commands):
    lines = [f'.TH OMPL_MFA 1 "" "{version}" "User Commands"', ".SH NAME", f"ompl_mfa \\- {troff(description)}",
             ".SH SYNOPSIS", ".B ompl_mfa", "\\fICOMMAND\\fR [\\fIOPTION\\fR]... [\\fIFILE\\fR]...", ".SH DESCRIPTION",
             "The program solves the motion planning problems of OMPL\\(aqs benchmark configs (.cfg), checks them, and runs",
             "campaigns of planners. Results are written to standard output, messages to standard error."]
    for name, (meaning, sections) in commands.items():
        arguments = " ".join(entry[0].split()[0] for entry in sections.get("Positionals", []))
        lines += [f".SH COMMAND {troff(name.upper())}", f"\\fBompl_mfa {troff(name)}\\fR [\\fIOPTION\\fR]... "
                  f"\\fI{troff(arguments)}\\fR", ".PP", troff(meaning) + "."]
        for entry in sections.get("Positionals", []) + sections.get("Options", []):
            lines += [".TP", f"\\fB{troff(entry[0])}\\fR", troff(entry[1])]
    lines += [".SH EXIT STATUS", ".TP", "0", "success", ".TP", "1", "no exact solution was found, or a result cannot be "
              "written", ".TP", "2", "invalid input; one line on standard error names file, key, value and what is accepted",
              ".TP", "128 + N", "ended by signal N"]
    return "\n".join(lines) + "\n"


def completion(commands):
    cases = []
    for name, (_, sections) in commands.items():
        options = [word for entry in sections.get("Options", []) for word in re.findall(r"--[a-z-]+", entry[0])]
        cases.append(f'        {name}) options="{" ".join(options)}" ;;')
    return "\n".join([
        "# Completion for bash: commands and options of ompl_mfa, and files.",
        "_ompl_mfa()", "{", '    local word=${COMP_WORDS[COMP_CWORD]} options=""', "    COMPREPLY=()",
        "    if [[ $COMP_CWORD -eq 1 ]]; then",
        f'        mapfile -t COMPREPLY < <(compgen -W "{" ".join(commands)} --help --version" -- "$word")',
        "        return", "    fi", "    case ${COMP_WORDS[1]} in", *cases, "    esac",
        '    if [[ $word == -* ]]; then', '        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")', "    else",
        '        mapfile -t COMPREPLY < <(compgen -f -- "$word")', "    fi", "}",
        "complete -o filenames -F _ompl_mfa ompl_mfa"]) + "\n"


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    description, sections = help_of(program)
    commands = {name: help_of(program, name) for name, _ in sections["Subcommands"]}
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.splitlines()[0]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "ompl_mfa.1").write_text(manual(version, description, commands), encoding="utf-8")
    (folder / "ompl_mfa").write_text(completion(commands), encoding="utf-8")


if __name__ == "__main__":
    main()
