#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reference in docs/scripting.md, made from scripts/hyrax.d.lua.

scripting_reference.py          writes it anew between its two marks
scripting_reference.py --check  exits with 1 if that would change something
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GUIDE = ROOT / "docs" / "scripting.md"
BEGIN = "<!-- reference: made by scripting_reference.py from scripts/hyrax.d.lua -->\n"
END = "<!-- end of the reference -->\n"

# As they are called, in the order of the reference.
TITLES = {
    "hyrax": "The module `hyrax`", "Pet": "Pets", "Subscription": "Subscriptions", "Store": "`hyrax.store`",
    "Log": "`hyrax.log`", "Plugin": "`hyrax.plugin`", "Test": "`hyrax.test`", "SpawnOptions": "Options of `hyrax.spawn`",
    "PetFilter": "Filters", "Near": "`near` of a filter", "PlayOptions": "Options of `pet:play`", "Rect": "Rectangles",
    "Monitor": "Monitors",
}
PREFIXES = {"Pet": "pet", "Subscription": "subscription", "Store": "hyrax.store", "Log": "hyrax.log", "Test": "hyrax.test"}


class Class:
    def __init__(self, note):
        self.note = note
        self.fields = []  # (name, type, note, readonly)
        self.functions = []  # (call, lines, parameters, results)


def split_type(text):
    """A type and the note behind it: types hold blanks only within brackets and before '|'."""
    depth = 0
    for index, letter in enumerate(text):
        depth += (letter in "<({[") - (letter in ">)}]")
        if letter == " " and depth == 0:
            return text[:index], text[index:].strip()
    return text, ""


def read(text):
    classes, events = {}, []
    current, lines, parameters, results = None, [], [], []
    for line in text.splitlines():
        if match := re.match(r'---\| "(\w+)"\s*# (fun\(.*?\))\s*(.*)', line):
            events.append(match.groups())
        elif match := re.match(r"---@class hyrax(?:\.(\w+))?(: \S+)?\s*(.*)", line):
            current = classes.setdefault(match.group(1) or "hyrax", Class(match.group(3)))
        elif match := re.match(r"---@field (readonly )?(\w+\??) (.*)", line):
            kind, note = split_type(match.group(3))
            current.fields.append((match.group(2), kind, note, bool(match.group(1))))
        elif match := re.match(r"---@param (\S+) (.*)", line):
            parameters.append((match.group(1), *split_type(match.group(2))))
        elif match := re.match(r"---@return (.*)", line):
            results.append(match.group(1))
        elif line.startswith("---@async"):
            lines.append("Waits.")
        elif line.startswith("---@"):
            pass
        elif line.startswith("---"):
            lines.append(line[3:].strip())
        elif match := re.match(r"function (\w+)([.:])(.*) end", line):
            owner, dot, call = match.groups()
            prefix = PREFIXES.get(owner, owner)
            classes[owner].functions.append((prefix + dot + call, lines, parameters, results))
            lines, parameters, results = [], [], []
        elif line:
            lines, parameters, results = [], [], []
    return classes, events


def cell(text):
    return text.replace("|", "\\|")


def plain(kind):
    return re.sub(r"hyrax\.(?=[A-Z])", "", kind)


def entry(call, lines, parameters, results):
    yield f"#### `{call}`\n"
    text = " ".join(sorted(lines, key=lambda line: line == "Waits."))
    if text:
        yield text + "\n"
    items = [f"* `{name}`: `{plain(kind)}`{', ' + note if note else ''}" for name, kind, note in parameters]
    items += [f"* returns `{plain(split_type(each)[0])}` {split_type(each)[1]}".rstrip() for each in results]
    if items:
        yield "\n".join(items) + "\n"


def reference(text):
    classes, events = read(text)
    unknown = set(classes) - set(TITLES)
    if unknown:
        sys.exit(f"hyrax.d.lua: no title for {sorted(unknown)} in scripting_reference.py")
    parts = ["### Events\n", "| Event | Its handler | |\n|---|---|---|"]
    parts[-1] += "".join(f"\n| `{name}` | `{cell(plain(call))}` | {cell(note)} |" for name, call, note in events) + "\n"
    for name, title in TITLES.items():
        one = classes[name]
        parts.append(f"### {title}\n")
        if one.note:
            parts.append(one.note[0].upper() + one.note[1:] + ".\n")
        if one.fields:
            rows = "".join(f"\n| `{field}` | `{cell(plain(kind))}` | {cell(note)}{' (read only)' if readonly else ''} |"
                           for field, kind, note, readonly in one.fields)
            parts.append("| Field | Type | |\n|---|---|---|" + rows + "\n")
        for function in one.functions:
            parts.extend(entry(*function))
    return "\n".join(parts)


def main():
    guide = GUIDE.read_text(encoding="utf-8")
    before, _, rest = guide.partition(BEGIN)
    old, mark, after = rest.partition(END)
    if not mark:
        sys.exit(f"{GUIDE.name}: the marks of the reference are missing")
    new = "\n" + reference((ROOT / "scripts" / "hyrax.d.lua").read_text(encoding="utf-8")) + "\n"
    if "--check" in sys.argv[1:]:
        if new != old:
            sys.exit(f"{GUIDE.name}: the reference is not that of hyrax.d.lua; run docs/scripting_reference.py")
        return
    GUIDE.write_text(before + BEGIN + new + END + after, encoding="utf-8")


main()
