"""Other people's logs, CSV files or bags with other topics, as recordings of the contract."""
