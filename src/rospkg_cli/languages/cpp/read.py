"""Which files of a package are C++, and what each is there for."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput, read_each
from ...unreadable import Unreadable
from .file import CppFile, read_cpp

SUFFIXES = tuple(".c .cpp .cc .cxx .c++ .hpp .hh .hxx .h .ipp .tpp .inl .cu .cuh".split())


def read_cpp_files(reading: ReaderInput) -> Iterator[CppFile | Unreadable]:
    """Read every C++ file of a package; one in an encoding of its own is no fault, and is left out."""
    paths = [path for path in reading.files.paths if path.endswith(SUFFIXES)]
    return (file for file in read_each(reading.files, paths, read_cpp) if isinstance(file, CppFile))
