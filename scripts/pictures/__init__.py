"""What the scripts that make pictures of runs share."""
