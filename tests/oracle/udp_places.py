"""Where a process listens over UDP, by /proc."""

import os
from pathlib import Path


def udp_places(process):
    """["127.0.0.1:7410", ...] of the process of this number; sockets of IPv6 as "udp6"."""
    inodes = set()
    for link in Path(f"/proc/{process}/fd").iterdir():
        target = os.readlink(link) if link.is_symlink() else ""
        if target.startswith("socket:["):
            inodes.add(target[8:-1])
    places = []
    for table in ("udp", "udp6"):
        for line in Path(f"/proc/{process}/net/{table}").read_text().splitlines()[1:]:
            fields = line.split()
            if fields[9] not in inodes:
                continue
            address, port = fields[1].split(":")
            number = int(address, 16) if table == "udp" else 0
            text = ".".join(str(number >> shift & 255) for shift in (0, 8, 16, 24)) if table == "udp" else table
            places.append(f"{text}:{int(port, 16)}")
    return places
