"""Where a process has sockets, by /proc."""

import os
from pathlib import Path


def hex_address(text):
    """Of /proc/net: 0100007F:1CF2 is 127.0.0.1."""
    number = int(text.split(":")[0], 16)
    return ".".join(str(number >> shift & 255) for shift in (0, 8, 16, 24))


def socket_places(process):
    """["127.0.0.1:7410", ...] of the process of this number; sockets of IPv6 as "udp6:PORT"."""
    inodes = set()
    for link in Path(f"/proc/{process}/fd").iterdir():
        target = os.readlink(link) if link.is_symlink() else ""
        if target.startswith("socket:["):
            inodes.add(target[8:-1])
    places = []
    for table in ("udp", "tcp", "udp6", "tcp6"):
        for line in Path(f"/proc/{process}/net/{table}").read_text().splitlines()[1:]:
            fields = line.split()
            if fields[9] in inodes:
                place = table if table.endswith("6") else hex_address(fields[1])
                places.append(f"{place}:{int(fields[1].split(':')[1], 16)}")
    return places
