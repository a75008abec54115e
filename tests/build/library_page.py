#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/library.md says what the examples do: library_page.py SOURCE-FOLDER

Below the link to an example, each block of C++ stands in that program line by line, and each block of text in its
expected output. Every example is linked, in order, and has a block of each kind.
"""

import re
import sys
import textwrap
from pathlib import Path

root = Path(sys.argv[1])
LINK = re.compile(r"^\[examples/(\w+)\.cpp\]\(\.\./examples/\1\.cpp\)$")


def stands_in(block, text):
    """Whether the lines of the block stand in the text one after the other, but for one indentation of them all."""
    block = textwrap.dedent("\n".join(block)).splitlines()
    lines = text.splitlines()
    windows = (lines[i:i + len(block)] for i in range(len(lines) - len(block) + 1))
    return any(textwrap.dedent("\n".join(window)).splitlines() == block for window in windows)


def blocks(page):
    """(line, example, language, lines) of each fenced block, and the examples linked."""
    example, language, inside, linked = None, None, [], []
    for number, line in enumerate(page.splitlines(), 1):
        if match := LINK.match(line):
            example = match[1]
            linked.append(example)
        elif line.startswith("```"):
            if language is None:
                language, inside = line[3:], []
            else:
                yield number, example, language, inside
                language = None
        elif language is not None:
            inside.append(line)
    yield 0, None, None, linked


def main():
    wrong, kinds, linked = [], {}, []
    for number, example, language, lines in blocks((root / "docs" / "library.md").read_text(encoding="utf-8")):
        if number == 0:
            linked = lines
            continue
        suffix = {"cpp": "cpp", "text": "expected"}.get(language)
        if example is None or suffix is None or not lines:
            wrong.append(f"docs/library.md:{number}: this block belongs to no example")
            continue
        kinds.setdefault(example, set()).add(language)
        if not stands_in(lines, (root / "examples" / f"{example}.{suffix}").read_text(encoding="utf-8")):
            wrong.append(f"docs/library.md:{number}: does not stand in examples/{example}.{suffix}")
    programs = sorted(file.stem for file in (root / "examples").glob("*.cpp"))
    if linked != programs:
        wrong.append(f"docs/library.md links {linked}, and there are {programs}")
    wrong += [f"examples/{name}: docs/library.md shows not both its code and its output"
              for name in programs if kinds.get(name) != {"cpp", "text"}]
    print("\n".join(wrong))
    print(f"{len(programs)} examples, {len(wrong)} wrong")
    sys.exit(1 if wrong or not programs else 0)


if __name__ == "__main__":
    main()
