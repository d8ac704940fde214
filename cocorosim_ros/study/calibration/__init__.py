"""From measurements to the numbers of a platform: the published ones of Lily, and those in a recording."""
