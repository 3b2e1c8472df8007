"""What a name stands for in the files of a workspace, and what else becomes of it where it changes."""
