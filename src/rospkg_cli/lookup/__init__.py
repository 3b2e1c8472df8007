"""What stands at a place of a file, and where it comes from: for editors."""
