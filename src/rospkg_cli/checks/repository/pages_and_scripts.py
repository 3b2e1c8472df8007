"""The pages and scripts that say what to type, and which files they fetch or make that are not in git."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .linked_build import build_files, build_texts

TEXTS = (".md", ".rst", ".txt", ".sh", ".bash", "Makefile")
FETCHES = regex(
    r"(?im)^.*\b(?:unzip|unrar|7z|tar|wget|curl|gdown|rsync|scp|download\w*|git[ \t]+(?:lfs|clone|submodule))\b.*$"
)
"""A line that fetches or unpacks files."""
BY_COMMAND = r"\b(?:cp|mv|ln)(?:[ \t]+-\S+)*[ \t]+[^\s-]\S*[ \t]+\S*{0}|(?:>|\btouch\b|[ \t]-o)[ \t]*[^\s>]*{0}"
"""How a command makes a file."""
MAKES = (
    r"(?im)^.*\b(?:save|put|place|copy|export(?![ \t]+\w+=)|store|record|generate|create|move|rename|provide)\b"
    rf"[^\n]*{{0}}|{BY_COMMAND}"
)
"""Words before the name of a file that say to make it, or to put it there."""
MOUNTS = r"(?m)^\s*-\s*[\"']?[^\s:\"']+:[^\s:\"']*/{0}(?=[:\s\"']|$)|\b(?:target|dst)=[^\s,\"']*/{0}(?=[,\s\"']|$)"
"""How a container is given a file in place of one of its own."""
COPIES = r"(?m)^(?!\s*#).*\b(?:cp[ \t]+(?:-\w+[ \t]+)*-\w*[rRa]\w*|mv|ln[ \t]+-\w+)[ \t][^\n]*[/ \t]{0}/?(?=[\s`\"']|$)"
"""What copies or links a whole folder."""
PLAIN = regex(r"(?i)mesh(?:es)?|models?|textures?|maps?|media|worlds?|weights|checkpoints|datasets?|(?:ros)?bags?")
"""Folders that are called like what lies in them."""
MAPS = r"(?im)^.*\b(?:map_saver\w*|save_?map|serialize_?map)\b.*?(?:-f[ \t=]*|[/\"']){0}(?:\.\w+)?(?=[\s\"'`]|$)"
"""What saves a map, which is named without what comes behind the dot."""
MAP_FILES = (".yaml", ".pgm", ".png", ".posegraph", ".data")
ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".7z", ".rar")


def pages_and_scripts(files: PackageFiles) -> tuple[str, ...]:
    """Return what they say."""
    return (*own_pages(files), *build_texts(files))


def own_pages(files: PackageFiles) -> tuple[str, ...]:
    paths = [path for path in files.paths if path.endswith(TEXTS) and not path.endswith("CMakeLists.txt")]
    return tuple(map(files.page_text, paths))


def pages_above(files: PackageFiles) -> tuple[str, ...]:
    """Return the texts that build the repository and are no pages of the package."""
    own = own_pages(files)
    return tuple(text for text in build_texts(files) if text not in own)


def texts_above(files: PackageFiles, endings: tuple[str, ...]) -> tuple[str, ...]:
    """Return the texts of the files with some suffixes that build the repository."""
    paths = ((whole, path) for whole, path in build_files(files) if path.endswith(endings))
    return tuple(whole.readable_text(path) for whole, path in paths if whole.has_file(path))


@dataclass(frozen=True)
class FetchedFiles:
    """Rule input: files that a page or a script of the package has fetched, unpacked or made."""

    files: PackageFiles

    def has(self, path: str) -> bool:
        """Return whether a line that fetches files names a missing one, its folder, or an archive of that name."""
        folder, name = posixpath.split(path)
        stem = name.partition(".")[0]
        if folder and self.has_folder(folder, path):
            return True
        packed = [f"{each}{suffix}" for each in {stem, posixpath.basename(folder)} if each for suffix in ARCHIVES]
        wanted = (name, *([f"{folder}/"] if folder else []), *packed)
        return any(each in line for line in self.lines for each in wanted)

    def has_folder(self, folder: str, path: str) -> bool:
        """Return whether a line copies the folder of a missing file, or fetches what is in it.

        The line names the folder by its path or by a word for its contents (`Download the meshes`), and git has no
        file of that kind in the folder.
        """
        last, end = posixpath.basename(folder), posixpath.splitext(path)[1]
        ends = r"(?=[/`\"'\s.,;:)]|$)"
        brought = re.compile(rf"[/`\"']{re.escape(folder)}{ends}")
        plain = re.compile(rf"(?i)(?<![\w-]){re.escape(last)}(?![\w-])") if PLAIN.fullmatch(last) else None
        is_lacking = not any(each.endswith(end) for each in self.files.below(folder))
        if is_lacking and any(brought.search(line) or (plain and plain.search(line)) for line in self.lines):
            return True
        copied = re.compile(COPIES.format(re.escape(last)))
        return any(copied.search(text) for text in self.texts)

    def has_itself(self, path: str) -> bool:
        """Return whether a line that fetches or makes files names a missing one itself, or a script writes it under a
        name from its variables.
        """
        name = posixpath.basename(path)
        stem, end = posixpath.splitext(name)
        whole = rf"(?<![\w.-]){re.escape(name)}(?![\w-])"
        patterns = [re.compile(MAKES.format(whole)), re.compile(MOUNTS.format(re.escape(name)))]
        patterns += [re.compile(MAPS.format(re.escape(stem)))] if end in MAP_FILES else []
        is_named = re.compile(whole)
        if any(is_named.search(line) for line in self.lines):
            return True
        if any(each.search(text) for text in self.texts for each in patterns):
            return True
        from .script_outputs import ScriptOutputs  # few files are missing

        return ScriptOutputs(self.files, frozenset({posixpath.basename(self.files.folder)} - {""})).has(path)

    def has_by_command(self, path: str) -> bool:
        """Return whether a line fetches a missing file by its name, or a command writes it."""
        whole = rf"(?<![\w.-]){re.escape(posixpath.basename(path))}(?![\w-])"
        written, named = re.compile(BY_COMMAND.format(whole)), re.compile(whole)
        return any(map(named.search, self.lines)) or any(map(written.search, self.texts))

    @cached_property
    def lines(self) -> tuple[str, ...]:
        return tuple(each.group() for text in self.texts for each in FETCHES.finditer(text))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        return pages_and_scripts(self.files)
