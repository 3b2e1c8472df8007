"""The command line of tf2_ros's static_transform_publisher. (static_transform_broadcaster_program.cpp: parse_args)"""

from __future__ import annotations

from collections.abc import Sequence

from ...lazy_regex import regex
from ...ros.program_options import ANGLES, FRAMES, NUMBERS, QUATERNION
from ...suggest import nearest
from .argument_words import ArgumentWord

NUMBER = regex(r"\s*[+-]?(?:\d|\.\d|inf|nan)")
"""What a number begins with for std::stod, which passes over what follows."""
HELP = ("--help", "-h")
WITH_ANGLES, WITH_QUATERNION = 8, 9
"""How many words there are without options: numbers and two frames."""
TAKES = "takes three numbers of a place, three angles or a quaternion, and two frames: 8 or 9 words"
Problem = tuple[ArgumentWord | None, str]


def transform_problem(words: Sequence[ArgumentWord]) -> Problem | None:
    """Return the word that it refuses, None for all of them, and why; None where it may take all."""
    given: dict[str, ArgumentWord] = {}
    plain: list[ArgumentWord] = []
    has_options = any(word.text in NUMBERS | FRAMES or word.text in HELP for word in words)
    index = 0
    while index < len(words):
        word, index = words[index], index + 1
        if word.text is None and has_options:
            return None
        if word.text in HELP:
            return None
        if word.text not in NUMBERS | FRAMES:
            plain.append(word)
            continue
        if index == len(words):
            return word, f"is given no value for `{word.text}`"
        if word.text in NUMBERS and (wrong := no_number(words[index])):
            return words[index], f"reads a number for `{word.text}`, not `{wrong}`"
        given[word.text] = words[index]
        index += 1
    return plain_problem(plain, given) or frame_problem(plain, given)


def plain_problem(plain: Sequence[ArgumentWord], given: dict[str, ArgumentWord]) -> Problem | None:
    if ANGLES & given.keys() and QUATERNION & given.keys():
        return given[min(QUATERNION & given.keys())], "takes angles or a quaternion, not both"
    if len(plain) in (WITH_ANGLES, WITH_QUATERNION):
        if given:
            return plain[0], "takes words with options or without, not both"
        wrong = next((each for each in plain[:-2] if no_number(each)), None)
        if wrong is not None:
            which = f"reads a number where `{wrong.text}` stands"
            return wrong, which + period(plain, WITH_ANGLES)
    elif plain and given:
        name = plain[0].text or ""
        near = nearest(name, NUMBERS | FRAMES)
        return plain[0], f"has no option `{name}`" + (f", but `{near}`" if near else "")
    elif plain and (len(plain) > WITH_QUATERNION or all(each.text is not None for each in plain)):
        return None, f"{TAKES}, not {len(plain)}" + period(plain, WITH_QUATERNION)
    return None


def period(plain: Sequence[ArgumentWord], usual: int) -> str:
    """Return what to do where the last of the words is the period of ROS 1."""
    last = plain[-1].text
    is_last = len(plain) == usual + 1 and last and NUMBER.match(last) and no_number(plain[-2]) and no_number(plain[-3])
    return f"; there is no period as in ROS 1, remove `{last}`" if is_last else ""


def frame_problem(plain: Sequence[ArgumentWord], given: dict[str, ArgumentWord]) -> Problem | None:
    missing = sorted(FRAMES - given.keys(), key=len) if not plain else []
    return (None, f"is not given {' and '.join(f'`{name}`' for name in missing)}") if missing else None


def no_number(word: ArgumentWord) -> str:
    """Return a text that is certainly no number; "" for any other."""
    return "" if word.text is None or NUMBER.match(word.text.lower()) else word.text or "''"
