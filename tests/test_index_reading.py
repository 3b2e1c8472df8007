"""What is read of rosdistro's files and rosdep's lists, however odd they are, and what is kept of it."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_rosdistro import FILES

from rospkg_cli.index import NamesError
from rospkg_cli.index.file_url import FileUrl, index_url
from rospkg_cli.index.rosdep_lists import RosdepList, rosdep_lists
from rospkg_cli.index.rosdistro_files import distribution_files, released
from rospkg_cli.index.update import make_index, tables
from rospkg_cli.ros.name_index import BrokenIndexError, Index, check, dump, parse
from rospkg_cli.ros.rosdep import CODENAMES, installer, merged, packages

WORDS = st.text("abc-_.+7é", min_size=1, max_size=8)
NAMED = st.dictionaries(WORDS, st.lists(st.sampled_from(["apt", "pip", "-"]), min_size=1, max_size=3).map(tuple))
ODD = st.recursive(
    st.none() | st.booleans() | st.integers() | st.sampled_from(["", "x", "index", "distribution", "a b"]),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(["type", "distributions", "distribution", "repositories", "release", "packages"])
            | st.sampled_from(["ubuntu", "*", "apt", "pip", "jammy", "x"])
            | st.integers(0, 2),
            inner,
            max_size=4,
        )
    ),
    max_leaves=12,
)
HERE = FileUrl("file:///a/index-v4.yaml")


@given(NAMED, NAMED, NAMED, NAMED, st.text())
def test_an_index_is_read_back_as_it_was_written(packages, keys, pip, apt, source) -> None:
    index = Index(" ".join(source.split()), "2026-11-01T12:00:00Z", ("jazzy",), packages, keys, pip, apt, ("/b",))
    text = dump(index)
    check(text)
    assert parse(text) == index
    assert dump(parse(text)) == text


def test_names_with_blanks_are_left_out_and_places_stay_on_their_line() -> None:
    index = Index("/a\n/b", "2026-11-01T12:00:00Z", (), {"a b": ("jazzy",), "c": ("jazzy",)}, {"d\ne": ("apt",)})
    found = parse(dump(index))
    assert found.packages == {"c": ("jazzy",)}
    assert found.keys == {}
    assert found.source == "/a /b"


@given(st.text())
def test_what_is_no_index_is_refused(text: str) -> None:
    with pytest.raises(BrokenIndexError):
        check(text)


@pytest.mark.parametrize(
    "index, named, place",
    [
        ("https://a.org/b/index-v4.yaml?token=x", "jazzy/d.yaml", "https://a.org/b/jazzy/d.yaml?token=x"),
        ("https://a.org/b/index-v4.yaml?token=x", "https://b.org/d.yaml", "https://b.org/d.yaml"),
        ("file:///b/index-v4.yaml", "file:///c/d.yaml", "file:///c/d.yaml"),
        ("https://a.org/b/index-v4.yaml", "file:///etc/passwd", None),
        ("https://a.org/b/index-v4.yaml", "ftp://a.org/d.yaml", None),
        ("https://a.org/b/index-v4.yaml", "http://[x", None),
    ],
)
def test_what_an_index_names_lies_beside_it_or_elsewhere(index: str, named: str, place: str | None) -> None:
    if place:
        assert FileUrl(index).join(named) == FileUrl(place)
    else:
        with pytest.raises(NamesError):
            FileUrl(index).join(named)


@given(ODD)
def test_odd_files_are_refused_or_read(data) -> None:
    for read in (lambda: distribution_files(HERE, data), lambda: released([(HERE, data)])):
        if isinstance(data, dict):
            with suppress(NamesError):
                read()


@given(ODD)
def test_odd_entries_of_a_list_are_served_or_not(entry) -> None:
    for codename in CODENAMES.values():
        assert installer(entry, codename) in {"apt", "pip", "gem", "npm", "source", "-"}
        assert all(isinstance(each, str) for each in packages(entry, codename))
    if isinstance(entry, dict):
        merged([entry, entry])
        tables([(frozenset(CODENAMES.values()), entry)])


def lists(tmp_path: Path, write, text: str) -> list[RosdepList]:
    folder = write(tmp_path / "rosdistro", FILES)
    write(tmp_path / "lists", {"10-ours.list": text, "notes.txt": "no list"})
    return rosdep_lists(index_url(str(folder), {}, ""), {"ROSDEP_SOURCE_PATH": str(tmp_path / "lists")})


def test_the_lists_of_the_machine_come_first_and_those_of_rosdistro_from_the_source(tmp_path: Path, write) -> None:
    found = lists(
        tmp_path,
        write,
        "# ours\nyaml file:///ours.yaml\n\n"
        "yaml https://mirror.example.org/raw/ros/rosdistro/master/rosdep/base.yaml ubuntu\n",
    )
    names = [each.place.url.rpartition("/")[2] for each in found]
    assert names == ["ours.yaml", "base.yaml", "osx-homebrew.yaml", "python.yaml"]
    assert found[1].place.url == (tmp_path / "rosdistro/rosdep/base.yaml").as_uri()
    assert found[1].elsewhere == FileUrl("https://mirror.example.org/raw/ros/rosdistro/master/rosdep/base.yaml")


@pytest.mark.parametrize(
    "tags, releases",
    [
        ("", {"jammy", "noble", "resolute"}),
        ("ubuntu", {"jammy", "noble", "resolute"}),
        ("ubuntu noble", {"noble"}),
        ("humble", {"jammy"}),
        ("noble jammy", set()),
        ("osx", set()),
        ("noetic", set()),
    ],
)
def test_tags_limit_a_list(tags: str, releases: set[str]) -> None:
    assert RosdepList(HERE, frozenset(tags.split())).codenames == releases


@pytest.mark.parametrize("line", ["yaml", "yaml ours.yaml", "deb http://x y", "yml file:///x.yaml"])
def test_a_line_that_is_none_is_told_with_its_place(tmp_path: Path, write, line: str) -> None:
    with pytest.raises(NamesError, match=r"10-ours\.list:2: `"):
        lists(tmp_path, write, f"# ours\n{line}\n")


def test_keys_of_the_machines_own_lists_are_known(tmp_path: Path, write) -> None:
    folder = write(tmp_path / "rosdistro", FILES)
    own = "our-lib:\n  ubuntu: [libour]\ngripper-lib:\n  ubuntu: {noble: {pip: {packages: [gripper]}}}\n"
    write(tmp_path, {"ours.yaml": own, "lists/10-ours.list": f"yaml {(tmp_path / 'ours.yaml').as_uri()}\n"})
    surroundings = {"ROSDEP_SOURCE_PATH": str(tmp_path / "lists")}
    index = make_index(index_url(str(folder), {}, ""), ["jazzy"], surroundings)
    assert index.keys["our-lib"] == ("apt", "apt", "apt")
    assert index.keys["gripper-lib"] == ("-", "pip", "-"), "the first list holds"
    assert index.lists == (str(tmp_path / "ours.yaml"),)
    write(tmp_path, {"lists/20.list": "yaml file:///gone.yaml\n"})
    with pytest.raises(NamesError, match=r"gone\.yaml can't be read"):
        make_index(index_url(str(folder), {}, ""), ["jazzy"], surroundings)
