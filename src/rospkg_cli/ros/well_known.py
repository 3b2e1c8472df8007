"""What the packages that everybody uses offer: programs, components, plugins, and what they offered once."""

from __future__ import annotations

from functools import cache
from typing import Literal

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..suggest import near_names
from .read_table import rows, sets

TABLE = "well_known.txt"
LAUNCH_FILES = "well_known_launch.txt"
LAUNCH_NAME = regex(r"[._-]launch|\.(?:py|xml|ya?ml)$|[_-]")
LAUNCH_FILE = regex(r"[._]launch(?:\.(?:py|xml|ya?ml))?$")
Kind = Literal["programs", "components", "plugins"]
ENDINGS = ("_node", ".py", "_exe", "_server")
"""Of names of programs; some packages have them, and some do not."""
WORD = regex(r"[A-Z]+(?![a-z])|[A-Z]?[a-z0-9]+")
PLAIN_WORDS = frozenset({
    "Behavior", "Checker", "Controller", "Costmap", "Critic", "Layer", "Node", "Planner", "Plugin", "Server",
    "Smoother",
})  # fmt: skip
DISPLAYED = frozenset({"rviz_common", "rviz_default_plugins", "rqt_gui_cpp", "rqt_gui_py", "gz_ros2_control"})
"""Packages whose names stand for more than plugins: panels and tools that are built in."""
SHORTEST = 8
"""Letters; a shorter name of a program may be that of any other."""


@dataclass(frozen=True, slots=True)
class WrongName:
    """A name that a package does not offer."""

    better: str
    """The right one, behind the package where that is another one; "" where it has no successor."""
    is_removed: bool
    """Whether distributions that are no longer supported had it; else it is misspelt."""


def wrong_name(kind: Kind, package: str, name: str) -> WrongName | None:
    """Return what is wrong with a program or a component of a package; None where nothing shows that anything is."""
    if name in removed(kind).get(package, {}):
        return WrongName(removed(kind)[package][name], True)
    known = sets(TABLE, kind).get(package, frozenset())
    if not known or name in known:
        return None
    near = with_other_ending(name, known) or closest(name, known)
    homes = packages_with_program(name) if kind == "programs" and not near else ()
    near = near or [f"{home}/{name}" for home in homes]
    return WrongName(near[0], False) if len(near) == 1 else None


def with_other_ending(name: str, names: frozenset[str]) -> list[str]:
    """Return the names that a name is but for an ending that programs have, or have not."""
    return [each for each in names if any(each == name + end or name == each + end for end in ENDINGS)]


def wrong_plugin(name: str) -> WrongName | None:
    """Return what is wrong with the name by which a plugin is loaded; None where nothing shows that anything is."""
    if name in every_plugin():
        return None
    gone = [names[name] for names in removed("plugins").values() if name in names]
    if gone:
        return WrongName(gone[0], True)
    prefix, tail = split(name)
    alike = [each for each in every_plugin() if split(each)[0] == prefix]
    same = [each for each in alike if split(each)[1].lower() == tail.lower()]
    near = set(closest(tail, {split(each)[1] for each in alike})) if not same else set()
    found = sorted(
        same or (each for each in alike if split(each)[1] in near), key=lambda each: ("::" in each) != ("::" in name)
    )
    if alike and not found:
        return other_plugin(prefix, tail, name)
    if not alike:  # the package's name stands for the first name of its plugins
        found = [each for each in rows(TABLE, "plugins").get(prefix, ()) if split(each)[1] == tail]
        return WrongName(found[0], False) if len(found) == 1 else None
    return WrongName(found[0], False) if len({split(each)[1] for each in found}) == 1 else None


def other_plugin(prefix: str, tail: str, name: str) -> WrongName | None:
    """Return the plugin of a package that is called alike but for words that say nothing: `ObstacleCostmapPlugin`.

    Another name is a guess: none of the package's own, which somebody else may have described.
    """
    own = [each for each in rows(TABLE, "plugins").get(prefix, ()) if split(each)[0] == prefix]
    if prefix in DISPLAYED or not own or name in sets(TABLE, "components").get(prefix, ()):
        return None
    alike = [each for each in own if telling(split(each)[1]) == telling(tail)] if telling(tail) else []
    return WrongName(alike[0], False) if len(alike) == 1 else WrongName("", False)


def telling(name: str) -> tuple[str, ...]:
    """Return the words of a class but for those that any plugin of its kind may have."""
    return tuple(word for word in WORD.findall(name) if word not in PLAIN_WORDS)


def plugins_of_class(name: str) -> list[str]:
    """Return the plugins of the same class whose first names are a letter off that of a name, or have all its words."""
    first, tail = split(name)
    words = frozenset(first.split("_"))
    found = [each for each in every_plugin() if split(each)[1] == tail and len(words) > 1]
    alike = near_names(first, {split(each)[0] for each in found}, 1)
    return sorted(each for each in found if split(each)[0] in alike or words < frozenset(split(each)[0].split("_")))


def closest(name: str, names: frozenset[str] | set[str]) -> list[str]:
    """Return the names that are one edit from a name, and else those that are two."""
    return near_names(name, names, 1) or near_names(name, names)


def split(name: str) -> tuple[str, str]:
    """Return what stands before the class of a plugin, and the class."""
    parts = name.replace("::", "/").split("/")
    return parts[0] if len(parts) > 1 else "", parts[-1]


def packages_with_program(name: str) -> tuple[str, ...]:
    """Return the packages that have a program; none where it is on the PATH too, or its name is one for anything."""
    on_path = any(name in names for names in sets(TABLE, "on the path").values())
    if on_path or not ("_" in name or len(name) >= SHORTEST):
        return ()
    return tuple(package for package, names in rows(TABLE, "programs").items() if name in names)


def packages_with_plugin(name: str) -> tuple[str, ...]:
    """Return the packages that have a plugin."""
    found = name.replace(" ", "%20")
    return tuple(package for package, names in rows(TABLE, "plugins").items() if found in names)


@cache
def is_well_known(package: str) -> bool:
    """Return whether users know what a package offers, or offered once."""
    kinds: tuple[Kind, ...] = ("programs", "components", "plugins")
    known = any(package in rows(TABLE, kind) or package in removed(kind) for kind in kinds)
    return known or package in sets(LAUNCH_FILES)


def other_launch_file(package: str, path: str) -> tuple[str, str] | None:
    """Return package and path of the launch file that a wrong path intends; None where it exists, or none is near.

    It is one with a similar name in the package, else the only one with the same name in another package.
    """
    known = sets(LAUNCH_FILES).get(package, frozenset())
    if not known or path in known or not LAUNCH_FILE.search(path):
        return None
    same = [each for each in known if plain_launch_name(each) == plain_launch_name(path)]
    names = {each.rpartition("/")[2]: each for each in known}
    near = same or [names[each] for each in closest(path.rpartition("/")[2], set(names))]
    elsewhere = [(home, path) for home, files in sets(LAUNCH_FILES).items() if path in files and not near]
    found = [(package, each) for each in near] or elsewhere
    return found[0] if len(found) == 1 else None


def plain_launch_name(path: str) -> str:
    """Return the name of a launch file without what names differ by: `bringup` for `launch/bringup.launch.py`."""
    return LAUNCH_NAME.sub("", path.rpartition("/")[2].lower())


@cache
def every_plugin() -> frozenset[str]:
    """Return the names of all plugins; the table has `%20` for a blank, as in the names of panels of RViz."""
    return frozenset(name.replace("%20", " ") for names in rows(TABLE, "plugins").values() for name in names)


@cache
def removed(kind: Kind) -> dict[str, dict[str, str]]:
    """Return what each package had once, with what it is called now."""
    found = rows(TABLE, f"removed {kind}")
    return {package: dict(word.rpartition("=")[::2] for word in words) for package, words in found.items()}
