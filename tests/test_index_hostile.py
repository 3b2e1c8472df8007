"""`rospkg index update` on malicious data, by many at once, and killed at any moment: the old names stay."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml
from small_rosdistro import FILES
from test_index import cache as cache
from test_index import fails
from test_index import folder as folder
from test_index import run as run
from test_index import surroundings as surroundings

from rospkg_cli.index import plain_yaml
from rospkg_cli.index.cache import STRAY_SECONDS
from rospkg_cli.index.plain_yaml import MAX_DEPTH, YamlError
from rospkg_cli.ros.name_index import parse

Run = Callable[..., SimpleNamespace]


def bomb(row: str) -> str:
    """Return nine levels of aliases, each nine times the one before."""
    rows = [row.format(level, ",".join([f"*a{level - 1}"] * 9)) for level in range(1, 10)]
    return "\n".join(["a0: &a0 {key: 1}", *rows, ""])


MALICIOUS = {
    "brackets": ("[" * 100_000, "is not read, from line 1 on: it is nested deeper than 50 levels"),
    "braces": ("{a: " * 100_000, "is nested deeper than 50 levels"),
    "dashes": ("- " * 100_000, "is nested deeper than 50 levels"),
    "question marks": ("? " * 100_000, "is nested deeper than 50 levels"),
    "indentation": ("\n".join(" " * level + "a:" for level in range(1_000)), "is nested deeper than 50 levels"),
    "merge keys": (bomb("a{0}: &a{0} {{<<: [{1}]}}"), "more than 1,000,000 values, with what aliases stand for"),
    "aliases": (bomb("a{0}: &a{0} [{1}]"), "more than 1,000,000 values, with what aliases stand for"),
    "aliases in names": (bomb("a{0}: &a{0} {{ubuntu: [{1}]}}"), "more than 1,000,000 values"),
    "itself": ("a: &a {ubuntu: *a}", "`*a` stands for nothing before it"),
    "a tag": ("a: !!python/object/apply:os.system [id]", "has a tag `tag:yaml.org,2002:python/object/apply:os.system`"),
    "a scalar's tag": ("a: !!python/name:os.system", "is not YAML, from line 1 on"),
    "a long number": (f"a: {'1' * 10_000}", "a number or a date has 10000 characters"),
    "base sixty": (f"a: 1{':1' * 100_000}", "a number or a date has 200001 characters"),
    "no date": ("a: 2020-99-99", "is not YAML, from line 1 on"),
    "a list as key": ("{[a]: b}", "a key is a list or a mapping"),
    "merged text": ("a: {<<: b}", "what is merged is no mapping"),
    "escapes": ("\x1b]0;owned\x07: [", "base.yaml is not YAML"),
}


@pytest.mark.parametrize("name", MALICIOUS)
@pytest.mark.parametrize("path", ["rosdep/base.yaml", "index-v4.yaml"])
def test_malicious_data_is_one_sentence_and_the_old_names_stay(
    run: Run, folder: Path, tmp_path: Path, cache: Path, write, name: str, path: str
) -> None:
    run("update", "--source", folder, "--quiet")
    before = cache.read_bytes()
    text, says = MALICIOUS[name]
    bad = write(tmp_path / "bad", {**FILES, path: text})
    fails(run("update", "--source", bad), says.replace("base.yaml", Path(path).name))
    assert cache.read_bytes() == before


PLAIN = [
    FILES["rosdep/base.yaml"],
    FILES["humble/distribution.yaml"],
    "a: &a {k: 1, j: [x, y]}\nb: {<<: *a, k: 3}\nc: {<<: [*a, {j: 2, z: 0}], z: 1}\nd: *a\n",
    "'on': on\n'1': 1\nnull: ~\nf: 1.5\nd: 2020-01-01\nx: 0x1f\no: 010\ns: 1:30\nm: !!map {a: !!str 1}\nq: ! on\n",
    "a: |\n  text\nb: >-\n  more\n? key\n: value\nlist: [<<, =]\n",
    "",
    "# nothing\n",
    "- 1\n- [a, {b: c}]\n",
]


@pytest.mark.parametrize("text", PLAIN)
def test_plain_yaml_says_what_pyyaml_says(text: str) -> None:
    try:
        expected = yaml.safe_load(text)
    except yaml.YAMLError:
        with pytest.raises(YamlError):
            plain_yaml.plain_yaml(text.encode())
        return
    assert plain_yaml.plain_yaml(text.encode()) == expected


def test_of_several_merge_keys_the_first_wins() -> None:
    """PyYAML says so since 6.0.4; before, the last one won."""
    found = plain_yaml.plain_yaml(b"a: {<<: [{k: 1}, {k: 2, z: 0}], <<: {z: 1, y: 3}}")
    assert found == {"a": {"k": 1, "z": 0, "y": 3}}


def test_no_more_is_kept_than_the_bounds_say(monkeypatch: pytest.MonkeyPatch) -> None:
    assert plain_yaml.plain_yaml(b"[" * MAX_DEPTH + b"]" * MAX_DEPTH)
    monkeypatch.setattr(plain_yaml, "MAX_VALUES", 10)
    assert plain_yaml.plain_yaml(b"[a, b, c, d, e, f, g, h, i]")
    for text in (b"[a, b, c, d, e, f, g, h, i, j]", b"[&a [a, b, c], *a, *a]", b"[&a {a: b, c: d}, {<<: *a, e: f}]"):
        with pytest.raises(YamlError, match="more than 10 values"):
            plain_yaml.plain_yaml(text)


def test_names_that_no_terminal_should_show_are_left_out(run: Run, tmp_path: Path, cache: Path, write) -> None:
    keys = '"a\\e]0;owned\\a": {ubuntu: [x]}\nok: {ubuntu: ["y\\e[2J"]}\n"\\u202eko": {ubuntu: [z]}\n'
    keys += f"{'k' * 300}: {{ubuntu: [w]}}\np: {{ubuntu: {{pip: [[deep, [er]], 'q\\r']}}}}\n"
    bad = write(tmp_path / "bad", {**FILES, "rosdep/base.yaml": keys})
    assert run("update", "--source", bad).returncode == 0
    text = cache.read_text()
    assert all(each.isprintable() for each in text.split("\n"))
    assert not set(parse(text).keys) & {"k" * 300, "\u202eko"}
    assert {"ok", "p"} <= set(parse(text).keys)


def test_a_source_cannot_name_files_without_end(run: Run, tmp_path: Path, write) -> None:
    listed = FILES["index-v4.yaml"].replace("[humble/distribution.yaml]", f"[{', '.join(['x.yaml'] * 51)}]")
    fails(
        run("update", "--source", write(tmp_path / "a", {**FILES, "index-v4.yaml": listed})), "names 51 files for one"
    )
    lines = "".join(f"yaml https://127.0.0.1:9/{number}.yaml\n" for number in range(101))
    lists = {**FILES, "rosdep/sources.list.d/20-default.list": lines}
    fails(run("update", "--source", write(tmp_path / "b", lists)), "name 101 lists; at most 100 are read")


def test_a_fifo_is_not_waited_for(run: Run, folder: Path) -> None:
    (folder / "rosdep/base.yaml").unlink()
    os.mkfifo(folder / "rosdep/base.yaml")
    fails(run("update", "--source", folder), "rosdep/base.yaml can't be read: it is not a file")


def start(folder: Path, cwd: Path, environment: dict[str, str], code: str = "") -> subprocess.Popen[bytes]:
    """Start `index update`, after some code of the test's own."""
    arguments = ["rospkg", "index", "update", "--source", str(folder), "--quiet"]
    program = f"import sys; {code}\nfrom rospkg_cli.__main__ import main; sys.argv = {arguments!r}; sys.exit(main())"
    return subprocess.Popen([sys.executable, "-c", program], cwd=cwd, env={**os.environ, **environment})


def test_eight_at_once_leave_one_whole_index(
    run: Run, folder: Path, tmp_path: Path, cache: Path, surroundings: dict[str, str]
) -> None:
    processes = [start(folder, tmp_path, surroundings) for _ in range(8)]
    assert [process.wait(60) for process in processes] == [0] * 8
    assert run("status").returncode == 0
    assert "alone" in parse(cache.read_text()).packages
    assert [path.name for path in cache.parent.iterdir()] == ["index.txt"]


KILL = "import os, signal; kill = lambda *_, **__: os.kill(os.getpid(), signal.SIGKILL)\n"
MOMENTS = {
    "before the file": "import tempfile; tempfile.mkstemp = kill",
    "half of it": "from rospkg_cli.engine.fixing import write; write.os = __import__('types').SimpleNamespace("
    "**{**vars(os), 'fsync': kill})",
    "before it is put in place": "from pathlib import Path; Path.replace = kill",
}


@pytest.mark.parametrize("moment", MOMENTS)
def test_killed_while_it_writes_the_old_names_stay_and_the_next_run_tidies_up(
    run: Run, folder: Path, tmp_path: Path, cache: Path, surroundings: dict[str, str], moment: str
) -> None:
    run("update", "--source", folder, "--quiet")
    before = cache.read_bytes()
    assert start(folder, tmp_path, surroundings, KILL + MOMENTS[moment]).wait(60) in (-9, 0)
    assert cache.read_bytes() == before or parse(cache.read_text())
    other = cache.parent / ".mine"
    for path in (other.touch() or other, *cache.parent.glob(".index.txt.*")):
        os.utime(path, (time.time() - STRAY_SECONDS - 9,) * 2)
    fresh = cache.parent / ".index.txt.another1"
    fresh.touch()
    assert run("update", "--source", folder, "--quiet").returncode == 0
    assert {path.name for path in cache.parent.iterdir()} == {".mine", fresh.name, "index.txt"}
