"""The command `cocorosim`: one sub-command per file."""
