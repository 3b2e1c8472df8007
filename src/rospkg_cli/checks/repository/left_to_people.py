"""Files that a repository lacks on purpose: people make them in a folder kept empty, or a page says how to get them.

Maps and calibrations belong to one building and one camera: whoever runs the package makes them, although a launch
file names them.
"""

from __future__ import annotations

import posixpath

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.launch.joined_path import OPEN
from ...package.package_facts import PackageFacts
from .pages_and_scripts import FetchedFiles

KEEPS = frozenset({".gitkeep", ".keep", ".placeholder", ".gitignore", ".empty", "placeholder", "placeholder.txt"})
"""Files that are there for git alone, which keeps no empty folder."""
OF_PEOPLE = regex(
    r"(?i)(?:.*_)?(?:maps?|calib(?:ration)?s?|data|datasets?|(?:ros)?bags?|recordings?|weights|models|checkpoints"
    r"|waypoints|routes|poses|logs|results|media|secrets|keys|certs?|certificates)(?:_.*)?"
)
"""Names of folders whose files are made where the robot runs, or are too large or too secret for git."""
WHOLE = {
    "setup.py": regex(r"""['"](?:\./)?([\w-][\w./-]*?)/?['"]"""),
    "CMakeLists.txt": regex(r"""(?i)\bDIRECTORY\s+"?(?:\$\{\w+\}/)?([\w-][\w./-]*?)/"?\s"""),
}
"""How builds name folders that may go to the share directory without their own name."""
OF_BUILDS = frozenset({"build", "install", "log", "dist"})
UNTIL_PUT = "until people put one into `{}/`, which is kept empty for theirs"
UNTIL_ADDED = "until people add one of theirs to `{}/`"
UNTIL_BROUGHT = "until people add it to `{}/`, which is installed, and which git ignores"
UNTIL_NAMED = "until people name theirs there"
UNTIL_MADE = "until it is fetched or made, as a page or a script here says"


def files_of(files: PackageFiles, facts: PackageFacts, *, own: bool) -> PackageFiles | None:
    """Return the files of a package of the run, by those of the one that is checked; None where they are not here."""
    if own:
        return files
    return PackageFiles(files.whole.sub(facts.folder), facts.folder, files.whole) if files.whole is not None else None


def why_left(files: PackageFiles | None, path: str, *, is_code: bool = False) -> str:
    """Return why a missing file does no harm to those who follow the pages of a package; "" where it may.

    Files that launch or xacro reads as code (`is_code`) are not made by people: only pages and what git ignores count.
    """
    if files is None:
        return ""
    if OPEN not in path and FetchedFiles(files).has_itself(path):
        return UNTIL_MADE
    if OPEN not in path and (theirs := ignored_folder(files, path)):
        return UNTIL_BROUGHT.format(theirs)
    folder = posixpath.dirname(path.partition(OPEN)[0])
    if is_code or not folder:
        return ""
    if is_kept(files, folder, path):
        return UNTIL_PUT.format(folder)
    return UNTIL_ADDED.format(folder) if OPEN in path and has_none_yet(files, folder, path) else ""


def ignored_folder(files: PackageFiles, path: str) -> str:
    """Return the folder that a build installs, and that git ignores, in which the file of a path may lie; "" for none.

    It is named as a whole (`os.walk('resource')`), so that `resource/urdf/a.urdf` may become `share/x/urdf/a.urdf`.
    """
    words = (each for build, word in WHOLE.items() for each in word.findall(files.readable_text(build)))
    folders = (each for each in dict.fromkeys(words) if each not in OF_BUILDS)
    return next((each for each in folders if files.absent.is_ignored(f"{each}/{path}")), "")


def is_kept(files: PackageFiles, folder: str, path: str) -> bool:
    """Return whether a folder holds nothing but what keeps it, and says or shows that people fill it."""
    names = [posixpath.basename(each).lower() for each in files.below(folder)]
    pages = [name for name in names if name.startswith("readme")]
    if not names or not all(name in KEEPS or name in pages for name in names):
        return False
    return bool(pages) or OPEN in path or is_of_people(folder)


def has_none_yet(files: PackageFiles, folder: str, path: str) -> bool:
    """Return whether a folder for what people make has no file of the kind that is named, so that none is misnamed."""
    end = posixpath.splitext(path)[1]
    return is_of_people(folder) and bool(end) and not any(each.endswith(end) for each in files.below(folder))


def is_of_people(folder: str) -> bool:
    return OF_PEOPLE.fullmatch(posixpath.basename(folder)) is not None
