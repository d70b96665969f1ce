"""What scripts of the oracle note as wrong, and how they end."""
import sys

errors = []


def check(good, text):
    """Notes what is wrong."""
    if not good:
        errors.append(text)


def end(what=""):
    """Says what was found, after what was looked at; exit code 0 if nothing is wrong."""
    for error in errors[:20]:
        print(error)
    print(f"{what}{len(errors)} errors")
    sys.exit(1 if errors else 0)
