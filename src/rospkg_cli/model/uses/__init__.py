"""What a package uses of others, wherever it says so: imports, launch files, CMake, interfaces, robots."""
