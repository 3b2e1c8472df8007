"""Read the C++ files of a package."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput, read_each
from ...unreadable import Unreadable
from .file import CppFile, read_cpp

SUFFIXES = tuple(".c .cpp .cc .cxx .c++ .hpp .hh .hxx .h .ipp .tpp .inl .cu .cuh".split())


def read_cpp_files(reading: ReaderInput) -> Iterator[CppFile | Unreadable]:
    """Read every C++ file of a package; one that can't be decoded is left out without an error."""
    paths = [path for path in reading.files.paths if path.endswith(SUFFIXES)]
    return (file for file in read_each(reading.files, paths, read_cpp) if isinstance(file, CppFile))
