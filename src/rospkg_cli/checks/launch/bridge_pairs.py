"""Pairs of types that ros_gz_bridge does not know: in the wrong order, alone, or not made for each other."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...ros.bridge_types import BRIDGED

PAIR = regex(r"(?<!\S)[^@\s]*@([\w./]+)(?:([^\w./:\s])([\w./]+))?(?=\s|$)")
"""`topic@type`, perhaps with a direction and a second type; a service has a third one, and is not matched."""
GAZEBO_TYPE = regex(r"((?:gz|ignition)\.msgs\.)(\w+)")
ROS_TYPE = regex(r"([a-z]\w*)/(?:msg/)?([A-Z]\w*)")
SIGNS = "@[]"


def pair_problems(text: str, *, is_whole: bool) -> Iterator[tuple[int, int, str]]:
    """Yield where an argument of the bridge names no pair, and what is wrong; a type alone only in a whole argument."""
    for match in PAIR.finditer(text):
        first, sign, second = match.groups()
        problem = problem_alone(first) if second is None and is_whole else problem_of(first, sign or "", second or "")
        if problem:
            yield match.start(), match.end(), problem


def problem_alone(first: str) -> str:
    """Return what is wrong with an argument of one type; "" for a service, and for what may be anything else."""
    ros = ROS_TYPE.fullmatch(first)
    if ros is not None and "/msg/" in first:
        known = BRIDGED.get(f"{ros[1]}/{ros[2]}", ())
        intended = (
            f"`{first}[gz.msgs.{known[0]}`, or with `]` or `@`" if known else "`[` and the type of Gazebo behind it"
        )
        return f"`{first}` stands alone, without a direction and the type of Gazebo; write {intended}"
    if GAZEBO_TYPE.fullmatch(first):
        return f"`{first}` stands alone, without the type of ROS; write `package/msg/Type[{first}`"
    return ""


def problem_of(first: str, sign: str, second: str) -> str:
    """Return what is wrong with two types; "" for nothing."""
    ros, gazebo = ROS_TYPE.fullmatch(first), GAZEBO_TYPE.fullmatch(second)
    if GAZEBO_TYPE.fullmatch(first) and ROS_TYPE.fullmatch(second):
        return f"the type of ROS comes first; write `{second}{sign}{first}`"
    if ros is not None and gazebo is not None and sign not in SIGNS:
        return f"`{sign}` is no direction; write `[`, `]` or `@`"
    return unknown_pair(first, second)


def unknown_pair(first: str, second: str) -> str:
    """Return what is wrong with a type of ROS and one of Gazebo; "" where a later bridge may know the pair."""
    ros, gazebo = ROS_TYPE.fullmatch(first), GAZEBO_TYPE.fullmatch(second)
    known = BRIDGED.get(f"{ros[1]}/{ros[2]}", ()) if ros is not None else ()
    if gazebo is None or gazebo[2] in known or not known:
        return ""
    others = {name for names in BRIDGED.values() for name in names}
    is_slip = plain(gazebo[2]) in map(plain, known)
    if not is_slip and gazebo[2] not in others:
        return ""
    intended = " or ".join(f"`{gazebo[1]}{name}`" for name in known)
    return f"`{first}` goes with {intended}, not with `{second}`"


def plain(name: str) -> str:
    return name.replace("_", "").lower()
