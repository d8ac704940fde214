"""What keys, metrics, effects and topics mean, put together from the tables and files that define them."""
