"""Rules of CMakeLists.txt (CMK)."""
