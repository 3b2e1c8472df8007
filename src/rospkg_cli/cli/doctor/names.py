"""The index of names, and the targets."""

from __future__ import annotations

import os

from ...config.file import Config
from ...control_characters import visible
from ...index import NamesError
from ...index.cache import cache_file, cached_index
from ...ros.distros import DISTROS, fault_of_name
from ...ros.names import BUILT_IN
from ..index.age import OLD, age, in_words
from .topic import Topic

UPDATE = "`rospkg index update` fetches a new one"


def index() -> tuple[Topic, bool]:
    """Return where known names come from, and whether an index was fetched."""
    path = cache_file(os.environ)
    data: dict[str, object] = {"path": str(path), "fetched": None}
    try:
        found = cached_index(os.environ)
    except NamesError as error:
        return Topic("index", (str(error),), data, "until then, the built-in names are used", is_wrong=True), False
    if found is None:
        names = f"{len(BUILT_IN.packages):,} package names and {len(BUILT_IN.keys):,} rosdep keys are built in"
        return Topic("index", (f"none fetched; {names}",), data, "`rospkg index update` fetches all names"), False
    days = age(found)
    data |= {"fetched": found.fetched, "age_days": days, "source": found.source, "distros": list(found.distros)}
    line = f"fetched {in_words(days)} for {', '.join(found.distros)} from {visible(found.source)}; {path}"
    return Topic("index", (line,), data, UPDATE if days > OLD else ""), True


def targets(config: Config) -> Topic:
    """Return the distributions that packages are judged for, and who says so."""
    sourced = os.environ.get("ROS_DISTRO", "")
    if config.target:
        names, source = config.target, str(config.path)
    elif sourced and not fault_of_name(sourced):
        names, source = (sourced,), "$ROS_DISTRO"
    else:
        every = tuple(each.name for each in DISTROS)
        return Topic("targets", (f"all: {', '.join(every)}",), {"names": list(every), "source": None})
    return Topic("targets", (f"{', '.join(names)} (from {source})",), {"names": list(names), "source": source})
