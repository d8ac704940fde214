"""The claims of the paper as data, and what tables of results say of them."""
