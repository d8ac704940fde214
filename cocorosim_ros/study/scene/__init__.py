"""A recording in three dimensions: what is to be seen of it, and a Rerun recording that shows it."""
