"""A policy as an ONNX file, and the small part of ONNX that plays it: Sub, Mul, Clip, Gemm, Tanh, one after the other."""

import numpy as np


def write_onnx(policy, file):
    """Input "observation" (n, observations) float32, output "action" (n, actions): (observation - mean) * scale, clipped to
    +-10, then layers of tanh. Needs the package onnx."""
    import onnx
    from onnx import TensorProto, helper, numpy_helper

    constants, nodes = {}, []

    def add(kind, output, *inputs, **settings):
        nodes.append(helper.make_node(kind, inputs, [output], **settings))
        return output

    def constant(name, value):
        constants[name] = np.asarray(value, np.float32)
        return name

    now = add("Sub", "centered", "observation", constant("mean", policy.scale.mean))
    now = add("Mul", "scaled", now, constant("scale", 1 / np.sqrt(policy.scale.square + 1e-4)))
    now = add("Clip", "clipped", now, constant("lower", -10), constant("upper", 10))
    layers = len(policy.actor.parameters) // 2
    for layer in range(layers):
        weight, bias = policy.actor.parameters[2 * layer: 2 * layer + 2]
        last = layer == layers - 1
        now = add("Gemm", "action" if last else f"sum{layer}", now, constant(f"weight{layer}", weight),
                  constant(f"bias{layer}", bias))
        if not last:
            now = add("Tanh", f"layer{layer}", now)
    ends = [helper.make_tensor_value_info(name, TensorProto.FLOAT, ["n", size])
            for name, size in (("observation", len(policy.scale.mean)), ("action", len(policy.log_deviation)))]
    graph = helper.make_graph(nodes, "policy", ends[:1], ends[1:],
                              [numpy_helper.from_array(value, name) for name, value in constants.items()])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], producer_name="murosimf", ir_version=8)
    onnx.checker.check_model(model)
    onnx.save(model, str(file))


class OnnxPolicy:
    """Plays a file of write_onnx, or of other tools with these operations alone. Raises ValueError for others."""

    operations = {
        "Sub": lambda a, b: a - b,
        "Mul": lambda a, b: a * b,
        "Clip": lambda a, lower, upper: np.clip(a, lower, upper),
        "Gemm": lambda a, b, c: a @ b + c,
        "Tanh": np.tanh,
    }

    def __init__(self, file):
        import onnx
        from onnx import numpy_helper

        graph = onnx.load(str(file)).graph
        self.constants = {each.name: numpy_helper.to_array(each) for each in graph.initializer}
        self.input, self.output = graph.input[0].name, graph.output[0].name
        self.nodes = [(node.op_type, list(node.input), node.output[0]) for node in graph.node]
        for node in graph.node:
            if node.op_type not in self.operations or node.attribute:
                raise ValueError(f"{file}: node '{node.name or node.output[0]}' is a {node.op_type} that is not played here; "
                                 f"known, without attributes: {', '.join(self.operations)}")

    def __call__(self, observations):
        """(n, actions) of (n, observations)."""
        values = {**self.constants, self.input: np.asarray(observations, np.float32)}
        for kind, inputs, output in self.nodes:
            values[output] = self.operations[kind](*(values[name] for name in inputs))
        return values[self.output]
