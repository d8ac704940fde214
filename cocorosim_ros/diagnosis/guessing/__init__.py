"""A map for a log that no map is written for: what its columns and messages most probably are, and what is doubtful."""
