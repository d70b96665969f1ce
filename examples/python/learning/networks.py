"""Small networks of NumPy: a multilayer perceptron with its gradient, and Adam."""

import numpy as np


class Mlp:
    """Layers of tanh, the last one linear: y = W2 tanh(W1 tanh(W0 x + b0) + b1) + b2, in rows."""

    def __init__(self, sizes, random, last_scale=1.0, dtype=np.float32):
        """`sizes`: (inputs, hidden, ..., outputs). Weights are uniform with variance 1 / inputs of the layer (LeCun et al.,
        Efficient BackProp, 1998, equation 16); `last_scale` shrinks those of the last layer."""
        self.parameters = []  # W0 (inputs, outputs), b0 (outputs,), W1, ...
        for layer, (inputs, outputs) in enumerate(zip(sizes, sizes[1:], strict=False)):
            scale = np.sqrt(3 / inputs) * (last_scale if layer == len(sizes) - 2 else 1)
            self.parameters += [random.uniform(-scale, scale, (inputs, outputs)).astype(dtype), np.zeros(outputs, dtype)]

    def forward(self, x):
        """(n, outputs), and what backward() needs."""
        values = [x]
        last = len(self.parameters) - 2
        for layer in range(0, len(self.parameters), 2):
            x = x @ self.parameters[layer] + self.parameters[layer + 1]
            if layer < last:
                x = np.tanh(x)
                values.append(x)
        return x, values

    def __call__(self, x):
        return self.forward(x)[0]

    def backward(self, values, slope):
        """Gradients of the parameters, in their order, for `slope` (n, outputs): the loss's derivative by the outputs."""
        gradients = []
        for layer in range(len(self.parameters) - 2, -1, -2):
            x = values[layer // 2]
            gradients = [x.T @ slope, slope.sum(axis=0), *gradients]
            if layer:
                slope = (slope @ self.parameters[layer].T) * (1 - x**2)
        return gradients


class Adam:
    """Kingma and Ba, Adam: A Method for Stochastic Optimization, ICLR 2015, algorithm 1. Changes the arrays in place."""

    def __init__(self, parameters, rate):
        self.parameters, self.rate, self.count = parameters, rate, 0
        self.mean = [np.zeros_like(each) for each in parameters]
        self.square = [np.zeros_like(each) for each in parameters]

    def step(self, gradients, largest_norm=1.0):
        """`largest_norm`: of all gradients together, which are scaled down to it."""
        norm = np.sqrt(sum(float(np.sum(each**2)) for each in gradients))
        shrink = min(1.0, largest_norm / (norm + 1e-8))
        self.count += 1
        rate = self.rate * np.sqrt(1 - 0.999**self.count) / (1 - 0.9**self.count)
        for parameter, gradient, mean, square in zip(self.parameters, gradients, self.mean, self.square, strict=True):
            gradient = gradient * shrink
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (gradient**2 - square)
            parameter -= (rate * mean / (np.sqrt(square) + 1e-8)).astype(parameter.dtype)
