"""`rospkg cache`: show and clear."""

from __future__ import annotations

import os

from ...cache.folder import cache_folder, is_safe
from ...cache.prune import clear as clear_folder
from ...cache.prune import kept_files
from ...control_characters import visible


def show() -> int:
    """Print the folder, the number of files and their size; return 0."""
    folder = cache_folder(os.environ)
    if not folder:
        print("There is no place for a cache: neither XDG_CACHE_HOME nor HOME is set.")
        return 0
    print(f"kept in   {visible(folder)}")
    if is_safe(folder):
        sizes = [size for _, size, _ in kept_files(folder)]
        print(f"files     {len(sizes):,}\nsize      {sum(sizes) / 1_000_000:,.1f} MB")
    elif os.path.lexists(folder):
        print("not used: it must be a folder of yours that no one else can write")
    else:
        print("nothing is kept yet")
    return 0


def clear() -> int:
    """Remove what is kept, and say how much that was; return 0."""
    folder = cache_folder(os.environ)
    size = clear_folder(folder) if folder and is_safe(folder) else 0
    print(f"{size / 1_000_000:,.1f} MB removed")
    return 0
