"""Robot descriptions: links, joints, and the files that they refer to."""
