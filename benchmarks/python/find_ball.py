#!/usr/bin/env python3
"""Trains a small network to find the ball on pictures of a data set, and measures it on others (docs/dataset.md).

    murosimf render match --dataset train --frames 2000 --seed 1 --threads 2
    murosimf render match --dataset test --frames 500 --seed 2 --threads 2
    benchmarks/python/find_ball.py train test

Three convolutions and a layer over windows of 32 pixels in which a ball has 16, at many sizes: 39,988 numbers, trained
in NumPy, used by OpenCV. A find is right where its box and the ball's have at least half of their union in common. A second find
of the same ball is a wrong one. Balls smaller than --least pixels, balls of 400 pixels and more, and those of which less than
half is seen are left out: they are not asked for, and finds of them are neither right nor wrong.
"""
import argparse
import json
import pathlib
import time

import cv2
import numpy as np
import onnx
from onnx import helper, numpy_helper

WINDOW, BALL, LARGEST = 32, 16, 400  # [px]
LAYERS = ((5, 2, 3, 16), (3, 2, 16, 48), (3, 1, 48, 64), (4, 1, 64, 4))  # size, stride, channels in and out


class Net:
    """Of each window: a score, shift of the ball's middle [BALL], logarithm of its size [BALL]."""

    def __init__(self, random, layers=LAYERS):
        self.layers = layers
        self.weights = [random.normal(0, np.sqrt(2 / (k * k * i)), (k * k * i, o)).astype(np.float32) for k, _, i, o in layers]
        self.biases = [np.zeros(o, np.float32) for *_, o in layers]
        self.moments = [(np.zeros_like(p), np.zeros_like(p)) for p in self.parameters()]
        self.steps = 0

    def parameters(self):
        return [p for pair in zip(self.weights, self.biases, strict=True) for p in pair]

    def forward(self, x):
        self.columns, self.shapes = [], []
        for (k, stride, _, out), w, b in zip(self.layers, self.weights, self.biases, strict=True):
            view = np.lib.stride_tricks.sliding_window_view(x, (k, k), (1, 2))[:, ::stride, ::stride]
            n, rows, columns = view.shape[:3]
            flat = view.transpose(0, 1, 2, 4, 5, 3).reshape(n * rows * columns, -1)
            self.columns.append(flat)
            self.shapes.append(x.shape)
            x = (flat @ w + b).reshape(n, rows, columns, out)
            if out != 4:
                x = np.maximum(x, 0.1 * x)
            self.outputs = [*getattr(self, "outputs", [])[:len(self.columns) - 1], x]
        return x[:, 0, 0]

    def backward(self, gradient):
        gradients, g = [], gradient[:, None, None]
        for layer in reversed(range(len(self.layers))):
            k, stride, channels, out = self.layers[layer]
            if out != 4:
                g = np.where(self.outputs[layer] > 0, g, 0.1 * g)
            flat = g.reshape(-1, out)
            gradients[:0] = [self.columns[layer].T @ flat, flat.sum(0)]
            if layer == 0:
                break
            n, rows, columns = g.shape[:3]
            pieces = (flat @ self.weights[layer].T).reshape(n, rows, columns, k, k, channels)
            g = np.zeros(self.shapes[layer], np.float32)
            for i in range(k):
                for j in range(k):
                    g[:, i:i + stride * rows:stride, j:j + stride * columns:stride] += pieces[:, :, :, i, j]
        return gradients

    def learn(self, gradients, rate):
        """Adam."""
        self.steps += 1
        for p, g, (m, v) in zip(self.parameters(), gradients, self.moments, strict=True):
            m += 0.1 * (g - m)
            v += 0.001 * (g * g - v)
            p -= rate * m / (1 - 0.9**self.steps) / (np.sqrt(v / (1 - 0.999**self.steps)) + 1e-8)

    def in_opencv(self):
        nodes, values, name = [], [], "picture"
        for i, ((k, stride, channels, out), w, b) in enumerate(zip(self.layers, self.weights, self.biases, strict=True)):
            kernel = np.ascontiguousarray(w.reshape(k, k, channels, out).transpose(3, 2, 0, 1))
            values += [numpy_helper.from_array(kernel, f"w{i}"), numpy_helper.from_array(b, f"b{i}")]
            nodes.append(helper.make_node("Conv", [name, f"w{i}", f"b{i}"], [f"c{i}"], kernel_shape=[k, k],
                                          strides=[stride, stride], pads=[0, 0, 0, 0]))
            name = f"c{i}"
            if out != 4:
                nodes.append(helper.make_node("LeakyRelu", [name], [f"r{i}"], alpha=0.1))
                name = f"r{i}"
        kind = onnx.TensorProto.FLOAT
        graph = helper.make_graph(nodes, "ball", [helper.make_tensor_value_info("picture", kind, [1, 3, "h", "w"])],
                                  [helper.make_tensor_value_info(name, kind, [1, 4, "y", "x"])], values)
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 11)], ir_version=8)
        return cv2.dnn.readNetFromONNX(np.frombuffer(model.SerializeToString(), np.uint8))


class Pictures:
    """Pictures with the box of their ball, and whether it is asked for."""

    def __init__(self, folder, least, most=None):
        coco = json.loads((folder / "annotations.json").read_text())
        ball = next(c["id"] for c in coco["categories"] if c["name"] == "ball")
        balls = {a["image_id"]: a for a in coco["annotations"] if a["category_id"] == ball}
        self.items = []
        for image in coco["images"][:most]:
            one = balls.get(image["id"])
            box = np.array(one["bbox_full"] or one["bbox"]) if one else None
            size = max(box[2:]) if one else 0
            asked = bool(one) and min(box[2:]) >= least and one["area"] > 0.5 * np.pi / 4 * box[2] * box[3] and size < LARGEST
            self.items.append((folder / image["file_name"], box, asked))

    def __len__(self):
        return len(self.items)

    def read(self, i):
        file, box, asked = self.items[i]
        return cv2.imread(str(file)), box, asked


def crop(picture, middle, side, window=WINDOW):
    """A square, grown at the borders, as window x window."""
    x, y = np.round(np.array(middle) - side / 2).astype(int)
    n = max(2, round(side))
    h, w = picture.shape[:2]
    rows, columns = np.clip(np.arange(y, y + n), 0, h - 1), np.clip(np.arange(x, x + n), 0, w - 1)
    how = cv2.INTER_AREA if n > window else cv2.INTER_LINEAR
    return cv2.resize(picture[np.ix_(rows, columns)], (window, window), interpolation=how)


def samples(pictures, random, positives=8, negatives=24):
    """Windows with their targets: 1 and where the ball is, or 0."""
    windows, targets = [], []
    for i in range(len(pictures)):
        picture, box, asked = pictures.read(i)
        h, w = picture.shape[:2]
        if asked:
            middle, size = box[:2] + box[2:] / 2, max(box[2:])
            for _ in range(positives):
                scale = np.exp(random.uniform(-0.18, 0.18))
                shift = random.uniform(-0.2, 0.2, 2)
                side = size * scale * WINDOW / BALL
                windows.append(crop(picture, middle - shift * side * BALL / WINDOW, side))
                targets.append([1, *shift, -np.log(scale)])
        for _ in range(negatives):
            side = WINDOW / BALL * np.exp(random.uniform(np.log(8), np.log(160)))
            middle = random.uniform(0, 1, 2) * [w, h]
            if box is not None and overlap([*(middle - side / 4), side / 2, side / 2], box) > 0.1:
                continue
            windows.append(crop(picture, middle, side))
            targets.append([0, 0, 0, 0])
    return np.array(windows), np.array(targets, np.float32)


def overlap(a, b):
    """Intersection over union of boxes [x, y, w, h]."""
    w = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    h = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    common = max(0, w) * max(0, h)
    return common / (a[2] * a[3] + b[2] * b[3] - common)


def as_input(windows):
    return windows.astype(np.float32) / 127.5 - 1


def train(net, windows, targets, random, epochs, rate):
    for epoch in range(epochs):
        order, total = random.permutation(len(windows)), 0
        for k, begin in enumerate(range(0, len(order) - 127, 128)):
            rows = order[begin:begin + 128]
            x, t = as_input(windows[rows]), targets[rows]
            flip = random.random(len(rows)) < 0.5
            x[flip] = x[flip, :, ::-1]
            t = t.copy()
            t[flip, 1] *= -1
            out = net.forward(x)
            share = 1 / (1 + np.exp(-out[:, 0]))
            g = np.zeros_like(out)
            g[:, 0] = share - t[:, 0]
            g[:, 1:] = 2 * t[:, :1] * np.clip(out[:, 1:] - t[:, 1:], -0.3, 0.3)
            net.learn(net.backward(g / len(rows)), rate * (1 - (epoch + k / (len(order) // 128)) / epochs) + 1e-5)
            total += -np.log(np.where(t[:, 0] > 0, share, 1 - share) + 1e-9).mean()
        print(f"  epoch {epoch + 1}: loss {total / max(1, len(order) // 128):.4f}", flush=True)


def find(network, picture, least, threshold=0.05):
    """Boxes with scores, the best first."""
    boxes, scores = [], []
    scale = BALL / (0.85 * least)
    while min(picture.shape[:2]) * scale >= WINDOW / 2:
        level = cv2.resize(picture, None, fx=scale, fy=scale,
                           interpolation=cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR)
        level = cv2.copyMakeBorder(level, *4 * [WINDOW // 2], cv2.BORDER_REPLICATE)
        network.setInput(as_input(level).transpose(2, 0, 1)[None].copy())
        out = network.forward()[0]
        share = 1 / (1 + np.exp(-out[0]))
        for y, x in np.argwhere(share > threshold):
            size = BALL * np.exp(out[3, y, x]) / scale
            middle = (np.array([4.0 * x, 4.0 * y]) + BALL * out[1:3, y, x]) / scale
            boxes.append([*(middle - size / 2), size, size])
            scores.append(float(share[y, x]))
        scale /= 1.25
    kept = []
    for i in np.argsort(scores)[::-1]:
        if all(overlap(boxes[i], boxes[k]) < 0.3 for k in kept):
            kept.append(i)
        if len(kept) == 10:
            break
    return [boxes[i] for i in kept], [scores[i] for i in kept]


def hard_negatives(network, pictures, least, most):
    """Windows that were taken for balls, in the first `most` pictures."""
    windows = []
    for i in range(min(most, len(pictures))):
        picture, box, _ = pictures.read(i)
        for found, _ in zip(*find(network, picture, least, 0.15), strict=True):
            if box is None or overlap(found, box) < 0.1:
                windows.append(crop(picture, np.array(found[:2]) + found[2] / 2, found[2] * WINDOW / BALL))
    return np.array(windows).reshape(-1, WINDOW, WINDOW, 3)


def average_precision(find, pictures):
    """Of `find`, which says boxes and scores of a picture: area under precision over recall, each precision the best at that
    recall or above; recall; and the number of balls.

    Without balls or finds both are 0."""
    finds, balls = [], 0
    for i in range(len(pictures)):
        picture, box, asked = pictures.read(i)
        balls += int(asked)
        right = False
        for found, score in zip(*find(picture), strict=True):
            hit = box is not None and overlap(found, box) >= 0.5
            if hit and not asked:
                continue
            finds.append((score, hit and not right))
            right = right or hit
    if not finds or not balls:
        return 0.0, 0.0, balls
    finds.sort(reverse=True)
    hits = np.cumsum([hit for _, hit in finds])
    precision = np.maximum.accumulate((hits / np.arange(1, len(finds) + 1))[::-1])[::-1]
    recall = hits / balls
    return float(np.sum(np.diff(recall, prepend=0) * precision)), float(recall[-1]), balls


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("train", type=pathlib.Path)
    parser.add_argument("test", type=pathlib.Path, nargs="+")
    parser.add_argument("--least", type=float, default=12, help="diameter of the smallest balls that are asked for [px]")
    parser.add_argument("--most", type=int, help="pictures to train with")
    parser.add_argument("--searched", type=int, default=2000, help="pictures in which it looks for its own mistakes")
    parser.add_argument("--rounds", type=int, default=2, help="searches for them, each of which it learns from")
    parser.add_argument("--epochs", type=int, default=4)
    options = parser.parse_args()
    random, begin = np.random.default_rng(1), time.monotonic()
    pictures, net = Pictures(options.train, options.least, options.most), Net(random)
    windows, targets = samples(pictures, random)
    print(f"{len(pictures)} pictures, {len(windows)} windows", flush=True)
    train(net, windows, targets, random, options.epochs, 2e-3)
    for _ in range(options.rounds):
        hard = hard_negatives(net.in_opencv(), pictures, options.least, options.searched)
        print(f"{len(hard)} windows were taken for balls", flush=True)
        windows = np.concatenate([windows, hard])
        targets = np.concatenate([targets, np.zeros((len(hard), 4), np.float32)])
        train(net, windows, targets, random, options.epochs, 1e-3)
    print(f"trained in {time.monotonic() - begin:.0f} s")
    network = net.in_opencv()
    for folder in options.test:
        pictures = Pictures(folder, options.least)
        precision, recall, balls = average_precision(lambda picture: find(network, picture, options.least), pictures)
        print(f"{folder}: average precision {precision:.3f}, recall {recall:.3f} of {balls} balls")


if __name__ == "__main__":
    main()
