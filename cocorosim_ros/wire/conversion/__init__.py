"""Other people's logs, tables or bags with other topics, as recordings of the contract."""
