#!/usr/bin/env python3
"""Compares what is in MCAP files with what the format's official reader and writer for Python say.

Usage: mcap_against_official.py <dump_mcap>
Exit: 0 all agree, 1 some differ, 77 the package mcap is not installed (test is skipped).

Files of ours are read by the official reader in both of its ways, by the summary and record by record with all checksums
checked; files of the official writer are read by ours. They hold random messages, attachments and metadata.
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import zlib

try:
    from mcap.data_stream import ReadDataStream
    from mcap.opcode import Opcode
    from mcap.reader import NonSeekingReader, SeekingReader
    from mcap.records import DataEnd, Footer
    from mcap.stream_reader import StreamReader
    from mcap.writer import CompressionType, Writer
except ImportError as missing:
    print(f"skipped: {missing}; pip install mcap")
    sys.exit(77)

FILES = 20


def ours(program, *words):
    """The lines of dump_mcap, decoded."""
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"dump_mcap {words}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]


def official(file, seeks):
    """The same lines by the official reader."""
    with open(file, "rb") as stream:
        reader = (SeekingReader if seeks else NonSeekingReader)(stream, validate_crcs=True)
        summary = reader.get_summary()
    lines = [["schema", s.id, s.name, s.encoding, s.data.hex()] for s in summary.schemas.values()]
    lines += [["channel", c.id, c.schema_id, c.topic, c.message_encoding, len(c.metadata)]
              for c in summary.channels.values()]
    with open(file, "rb") as stream:
        reader = (SeekingReader if seeks else NonSeekingReader)(stream, validate_crcs=True)
        lines += [["attachment", a.log_time, a.create_time, a.name, a.media_type, a.data.hex()]
                  for a in reader.iter_attachments()]
    with open(file, "rb") as stream:
        reader = (SeekingReader if seeks else NonSeekingReader)(stream, validate_crcs=True)
        lines += [["metadata", m.name, len(m.metadata)] for m in reader.iter_metadata()]
    with open(file, "rb") as stream:
        reader = (SeekingReader if seeks else NonSeekingReader)(stream, validate_crcs=True)
        lines += [["message", m.channel_id, m.sequence, m.log_time, m.data.hex()]
                  for _, _, m in reader.iter_messages(log_time_order=seeks)]
    return lines, summary.statistics


def check_sums(file):
    """Checksums and offsets that the reader does not look at: data section, summary, summary offsets, message indexes."""
    data = file.read_bytes()
    with open(file, "rb") as stream:
        records = list(StreamReader(stream, emit_chunks=True, validate_crcs=True).records)
    footer = next(r for r in records if isinstance(r, Footer))
    end = next(r for r in records if isinstance(r, DataEnd))
    data_end = footer.summary_start - 13
    assert data[data_end] == Opcode.DATA_END
    assert end.data_section_crc == zlib.crc32(data[:data_end]), "checksum of the data"
    assert footer.summary_crc == zlib.crc32(data[footer.summary_start:len(data) - 8 - 4]), "checksum of the summary"
    with open(file, "rb") as stream:
        summary = SeekingReader(stream).get_summary()
        for chunk in summary.chunk_indexes:
            for channel, offset in chunk.message_index_offsets.items():
                stream.seek(offset)
                assert ReadDataStream(stream).read1() == Opcode.MESSAGE_INDEX, (channel, offset)


def write_official(file, seed):
    """A file of random messages by the official writer."""
    rng = random.Random(seed)
    with open(file, "wb") as stream:
        compression = CompressionType.ZSTD if seed % 2 else CompressionType.NONE
        writer = Writer(stream, chunk_size=rng.randint(100, 20000), compression=compression)
        writer.start(profile="x", library="official")
        schema = writer.register_schema("Thing", "jsonschema", b"{}")
        channels = [writer.register_channel(f"/t{i}", "json", schema, {"a": "b"}) for i in range(3)]
        writer.add_metadata("run", {"seed": str(seed)})
        for i in range(rng.randint(1, 1000)):
            writer.add_message(rng.choice(channels), i * 10, rng.randbytes(rng.randint(0, 200)), i * 10, i)
        writer.add_attachment(5, 6, "name", "text/plain", rng.randbytes(300))
        writer.finish()


def main():
    program, wrong = sys.argv[1], 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(FILES):
            file = pathlib.Path(folder) / f"{seed}.mcap"
            expected = ours(program, "write", file, seed, "compressed" if seed % 2 else "plain")
            check_sums(file)
            for seeks in (True, False):
                found, statistics = official(file, seeks)
                messages = sum(line[0] == "message" for line in found)
                if found != expected or statistics.message_count != messages:
                    wrong += 1
                    print(f"file {seed} of ours differs by the reader {'with' if seeks else 'without'} seeking")
            write_official(file, seed)
            if official(file, True)[0] != ours(program, "read", file):
                wrong += 1
                print(f"file {seed} of the official writer differs")
    print(f"{2 * FILES} files, {wrong} differences")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
