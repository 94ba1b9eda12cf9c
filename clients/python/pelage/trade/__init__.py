"""`pelage trade`: what each quality costs on a server, and how far its pictures are from the truth."""
