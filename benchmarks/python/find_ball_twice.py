#!/usr/bin/env python3
"""Trains two networks to find the ball on pictures of a data set, faster than find_ball.py, by whose measure (docs/dataset.md).

    benchmarks/python/find_ball_twice.py train test

The first network looks everywhere, at many sizes, and proposes windows; the second sees each of these, moves the box, and says
whether a ball is in it. It learns from what the first one proposes in the same pictures, so from its mistakes. Windows are
mirrored while they learn, and changed in nothing else. With --held-out, pictures of the first folder are kept from training, to
choose by.
"""
import argparse
import pathlib
import time

import cv2
import numpy as np
from find_ball import Net, Pictures, as_input, average_precision, crop, overlap, train


class Kind:
    """A network for windows in which a ball has so many pixels; layers are size, stride, channels in and out."""

    def __init__(self, window, ball, layers):
        self.window, self.ball, self.layers = window, ball, layers


PROPOSES = Kind(32, 16, ((5, 2, 3, 16), (3, 2, 16, 32), (3, 1, 32, 48), (4, 1, 48, 4)))
DECIDES = Kind(40, 16, ((5, 2, 3, 16), (3, 2, 16, 32), (3, 1, 32, 48), (3, 1, 48, 64), (4, 1, 64, 64), (1, 1, 64, 4)))
PROPOSALS = 30  # of a picture


def crop_for(kind, picture, middle, size):
    """In which something of that size is as large as a ball is for the network."""
    return crop(picture, middle, size * kind.window / kind.ball, kind.window)


class Samples:
    """Windows with their targets: 1 and where the ball is, or 0."""

    def __init__(self, kind):
        self.kind, self.windows, self.targets = kind, [], []

    def add(self, picture, box, ball):
        """`box`: where it looks; `ball`: the ball's box, or none."""
        box = np.array(box)
        middle, size = box[:2] + box[2:] / 2, max(box[2:])
        self.windows.append(crop_for(self.kind, picture, middle, size))
        if ball is None:
            self.targets.append([0, 0, 0, 0])
        else:
            self.targets.append([1, *((ball[:2] + ball[2:] / 2 - middle) / size), np.log(max(ball[2:]) / size)])

    def add_ball(self, picture, ball, random, spread, count):
        for _ in range(count):
            size = max(ball[2:]) * np.exp(random.uniform(-spread, spread))
            middle = ball[:2] + ball[2:] / 2 + random.uniform(-spread, spread, 2) * size
            self.add(picture, [*(middle - size / 2), size, size], ball)

    def all(self):
        return np.array(self.windows), np.array(self.targets, np.float32)


def samples_everywhere(pictures, random, positives=8, negatives=24):
    samples = Samples(PROPOSES)
    for i in range(len(pictures)):
        picture, ball, asked = pictures.read(i)
        h, w = picture.shape[:2]
        if asked:
            samples.add_ball(picture, ball, random, 0.2, positives)
        for _ in range(negatives):
            size = np.exp(random.uniform(np.log(8), np.log(300)))
            box = [*(random.uniform(0, 1, 2) * [w, h] - size / 2), size, size]
            if ball is None or overlap(box, ball) <= 0.1:
                samples.add(picture, box, None)
    return samples.all()


def samples_proposed(network, pictures, least, random, searched, positives=8, negatives=0.6):
    """What the first network takes for balls, in the first `searched` pictures: windows that hit well enough are to be moved; of
    those without a ball that share is learned from."""
    samples = Samples(DECIDES)
    for i in range(len(pictures)):
        picture, ball, asked = pictures.read(i)
        if asked:
            samples.add_ball(picture, ball, random, 0.25, positives)
        for box in propose(network, picture, least) if i < searched else []:
            common = 0 if ball is None else overlap(box, ball)
            if common >= 0.45 and asked:
                samples.add(picture, box, ball)
            elif common < 0.3 and random.random() < negatives:
                samples.add(picture, box, None)
    return samples.all()


def overlaps(a, boxes):
    """Of one box with each of others."""
    w = np.minimum(a[0] + a[2], boxes[:, 0] + boxes[:, 2]) - np.maximum(a[0], boxes[:, 0])
    h = np.minimum(a[1] + a[3], boxes[:, 1] + boxes[:, 3]) - np.maximum(a[1], boxes[:, 1])
    common = np.maximum(0, w) * np.maximum(0, h)
    return common / (a[2] * a[3] + boxes[:, 2] * boxes[:, 3] - common)


def share_of(score):
    return 1 / (1 + np.exp(-score))


def best_apart(boxes, scores, most, common=0.3):
    """Numbers of the boxes with the best scores, of which no two have more than that in common."""
    kept, order = [], np.argsort(scores)[::-1]
    boxes = np.array(boxes).reshape(-1, 4)
    while len(order) and len(kept) < most:
        kept.append(int(order[0]))
        order = order[overlaps(boxes[order[0]], boxes[order]) < common]
    return kept


def propose(network, picture, least, threshold=0.01):
    """Boxes in which the first network sees a ball, the best first."""
    boxes, scores = [], []
    ball, window = PROPOSES.ball, PROPOSES.window
    scale = ball / least
    while min(picture.shape[:2]) * scale >= window / 2:
        level = cv2.resize(picture, None, fx=scale, fy=scale,
                           interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
        level = cv2.copyMakeBorder(level, *4 * [window // 2], cv2.BORDER_REPLICATE)
        network.setInput(as_input(level).transpose(2, 0, 1)[None].copy())
        out = network.forward()[0]
        share = share_of(out[0])
        y, x = np.nonzero(share > threshold)
        size = ball * np.exp(np.clip(out[3, y, x], -1, 1)) / scale
        left, top = ((4.0 * at + ball * shift) / scale - size / 2 for at, shift in ((x, out[1, y, x]), (y, out[2, y, x])))
        boxes.append(np.stack([left, top, size, size], 1))
        scores.append(share[y, x])
        scale /= 1.3
    boxes, scores = np.concatenate(boxes), np.concatenate(scores)
    return [list(boxes[i]) for i in best_apart(boxes, scores, PROPOSALS, 0.4)]


class Detector:
    def __init__(self, proposes, decides, least):
        self.proposes, self.decides, self.least = proposes.in_opencv(), decides, least

    def find(self, picture):
        """Boxes with scores. The second network looks twice: at what was proposed, and at where it has moved that."""
        boxes = propose(self.proposes, picture, self.least)
        if not boxes:
            return [], []
        for _ in range(2):
            windows = [crop_for(DECIDES, picture, np.array(box[:2]) + box[2] / 2, box[2]) for box in boxes]
            out = self.decides.forward(as_input(np.array(windows)))
            for box, (_, x, y, grows) in zip(boxes, out, strict=True):
                middle, size = np.array(box[:2]) + box[2] * (0.5 + np.array([x, y])), box[2] * np.exp(np.clip(grows, -1, 1))
                box[:] = [*(middle - size / 2), size, size]
        scores = [float(score) for score in share_of(out[:, 0])]
        kept = best_apart(boxes, scores, 10)
        return [boxes[i] for i in kept], [scores[i] for i in kept]


def trained(folder, options):
    """A detector that has seen these pictures."""
    random = np.random.default_rng(options.seed)
    pictures = Pictures(folder, options.least, options.most)
    windows, targets = samples_everywhere(pictures, random)
    print(f"{len(pictures)} pictures, {len(windows)} windows", flush=True)
    proposes, decides = Net(random, PROPOSES.layers), Net(random, DECIDES.layers)
    train(proposes, windows, targets, random, 3, 2e-3)
    windows, targets = samples_proposed(proposes.in_opencv(), pictures, options.least, random, options.searched)
    print(f"{len(windows)} windows to decide, in {int(targets[:, 0].sum())} of them a ball", flush=True)
    train(decides, windows, targets, random, options.epochs, 1.5e-3)
    return Detector(proposes, decides, options.least)


def add_options(parser):
    parser.add_argument("--least", type=float, default=12, help="diameter of the smallest balls that are asked for [px]")
    parser.add_argument("--most", type=int, help="pictures to train with")
    parser.add_argument("--searched", type=int, default=1000, help="pictures in which the second network learns from the first")
    parser.add_argument("--epochs", type=int, default=5, help="of the second network")
    parser.add_argument("--seed", type=int, default=1, help="of weights, windows and their order")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("train", type=pathlib.Path)
    parser.add_argument("test", type=pathlib.Path, nargs="*")
    parser.add_argument("--held-out", type=int, default=0, help="last pictures of `train`, which are only looked at")
    add_options(parser)
    options = parser.parse_args()
    begin = time.monotonic()
    if options.held_out:
        options.most = len(Pictures(options.train, options.least)) - options.held_out
    detector = trained(options.train, options)
    print(f"trained in {time.monotonic() - begin:.0f} s", flush=True)
    tests = [(str(folder), Pictures(folder, options.least)) for folder in options.test]
    if options.held_out:
        held_out = Pictures(options.train, options.least)
        held_out.items = held_out.items[options.most:]
        tests.append(("held out", held_out))
    for name, pictures in tests:
        precision, recall, balls = average_precision(detector.find, pictures)
        print(f"{name}: average precision {precision:.3f}, recall {recall:.3f} of {balls} balls", flush=True)


if __name__ == "__main__":
    main()
