"""Which common reading of all that the paper leaves open gives back most of its figure 4, by a designed experiment."""
