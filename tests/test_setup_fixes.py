"""What --fix makes of faulty setup.py and setup.cfg: the fault is gone, and what was not at fault stands as it was."""

from __future__ import annotations

import difflib

import pytest
from broken_setups import BROKEN, FILES

from rospkg_cli.engine.fixing.apply import apply_fixes
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree, TreeEntry


def codes(files: dict[str, str | TreeEntry]) -> set[str]:
    return {f.code for f in lint_files(files).findings if f.code.startswith(("SET", "RPK"))}


def mended(files: dict[str, str | TreeEntry]) -> dict[str, str | TreeEntry]:
    """Apply every fix of setup.py's rules, unsafe ones too, until none is left."""
    for _ in range(8):
        fixes = [f.fix for f in lint_files(files).findings if f.fix and f.code.startswith("SET")]
        changes, taken = apply_fixes(MemoryTree.of(files), fixes)
        if not taken:
            return files
        files = {path: entry for path, entry in {**files, **changes}.items() if entry is not None}
    pytest.fail("the fixes do not come to an end")


def text(files: dict[str, str | TreeEntry], path: str) -> str:
    return MemoryTree.of(files).entry(path).text.text


@pytest.mark.parametrize("variant", BROKEN)
def test_the_fault_is_named_and_mended(variant: str) -> None:
    before: dict[str, str | TreeEntry] = dict(BROKEN[variant].of(variant))
    assert BROKEN[variant].code in codes(before)
    assert codes(mended(before)) == set()


@pytest.mark.parametrize("variant", BROKEN)
def test_what_is_not_at_fault_stays(variant: str) -> None:
    before: dict[str, str | TreeEntry] = dict(BROKEN[variant].of(variant))
    after = mended(before)
    for path in sorted(set(before) & set(after)):
        old, new = text(before, path).splitlines(), text(after, path).splitlines()
        blocks = difflib.SequenceMatcher(None, old, new).get_opcodes()
        changed = [line for tag, a, b, _, _ in blocks if tag != "equal" for line in old[a:b]]
        assert len(changed) <= 3
        assert [line.partition("#")[2] for line in old if "#" in line] == [
            line.partition("#")[2] for line in new if "#" in line
        ]
    compile(text(after, "setup.py"), "setup.py", "exec")


def test_the_right_package_is_silent() -> None:
    files = {
        path.replace("NAME", "right"): content.replace("NAME", "right") for path, content in FILES.items() if content
    }
    assert codes({**files, "right/__init__.py": "", "resource/right": ""}) == set()
