"""What a package is: its files, manifest, build, launch files, parameters, and what others may know of it."""
