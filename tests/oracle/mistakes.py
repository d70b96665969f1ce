"""What scripts of the oracle note as wrong, and how they end."""
import sys

mistakes = []


def check(good, text):
    """Notes what is wrong."""
    if not good:
        mistakes.append(text)


def end(what=""):
    """Says what was found, after what was looked at; exit code 0 if nothing is wrong."""
    for mistake in mistakes[:20]:
        print(mistake)
    print(f"{what}{len(mistakes)} mistakes")
    sys.exit(1 if mistakes else 0)
