"""`pelage trade`: measures the cost and the error of each quality on a server."""
