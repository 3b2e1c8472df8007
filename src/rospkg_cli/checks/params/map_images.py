"""The image of a map, which map_server looks for in the folder of the map (PRM010)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.package_facts import PackageFacts
from ...source import Span
from ..fault import Fault, softer_advice
from ..paths.closest_path import closest_path
from ..repository.left_to_people import UNTIL_NAMED, why_left

MAP = regex(r"^resolution[ \t]*:[\s\S]*^origin[ \t]*:|^origin[ \t]*:[\s\S]*^resolution[ \t]*:", re.MULTILINE)
IMAGE = regex(r"^image[ \t]*:[ \t]*[\"']?([\w][\w ./-]*\.\w+)[\"']?[ \t]*(?:#.*)?\r?$", re.MULTILINE)
IMAGES = frozenset({".pgm", ".png", ".bmp", ".jpg"})


def image_faults(files: PackageFiles, package: PackageFacts, path: str, text: str) -> Iterator[Fault]:
    """Yield the image of a map, which map_server looks for in the folder of the map."""
    found = IMAGE.search(text)
    image = posixpath.normpath(posixpath.join(posixpath.dirname(path), found[1].strip())) if found else ".."
    if found is None or image.startswith("..") or files.is_there(image) or files.absent.is_expected(image):
        return
    if package.may_write(image):
        return
    from .made_files import why_made  # few packages need it

    near = closest_path(image, [each for each in files.paths if posixpath.splitext(each)[1] in IMAGES])
    message = f"the map names its image `{found[1].strip()}`, and it is not there: map_server can't load the map"
    hint = posixpath.relpath(near, posixpath.dirname(path) or ".") if near else ""
    hint = f"did you mean `{hint}`?" if hint else "add it, or correct it"
    left = "" if near else why_left(files, image) or why_made(image, files.paths)
    left = left or why_replaced(text, found.start(1))
    fault = Fault(Span(*found.span(1)), f"{message}; {hint}")
    yield softer_advice(fault, "info", left) if left else fault


def why_replaced(text: str, place: int) -> str:
    """Return that a comment next to a name asks the user to replace it; "" where none does."""
    from ..python.blank_names import is_to_be_replaced  # few packages miss a file

    return UNTIL_NAMED if is_to_be_replaced(text, place) else ""
