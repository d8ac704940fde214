"""The topics of the contract: names, types, quality of service, and what is said on them."""
