"""The library: a folder of thousands of clips, scans that are killed, and what the database holds afterwards."""
