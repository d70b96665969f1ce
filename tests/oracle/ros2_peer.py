"""A program of ROS 2 without ROS, by Cyclone DDS: subscribers, publishers, service clients as rmw_cyclonedds makes them."""

import dataclasses
import os
import random
import time
import types

PEER = """<CycloneDDS><Domain><General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces>
<AllowMulticast>spdp</AllowMulticast><MaxMessageSize>65500B</MaxMessageSize><FragmentSize>60000B</FragmentSize></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer address="127.0.0.1"/></Peers></Discovery>
<Internal><SocketReceiveBufferSize min="default"/></Internal></Domain></CycloneDDS>"""
os.environ.setdefault("CYCLONEDDS_URI", PEER)

from cyclonedds.core import Policy, Qos  # noqa: E402
from cyclonedds.domain import DomainParticipant  # noqa: E402
from cyclonedds.idl import IdlStruct  # noqa: E402
from cyclonedds.idl.types import int64, uint64  # noqa: E402
from cyclonedds.pub import DataWriter  # noqa: E402
from cyclonedds.sub import DataReader  # noqa: E402
from cyclonedds.topic import Topic  # noqa: E402
from cyclonedds.util import duration  # noqa: E402

RELIABLE = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(10))
KEPT = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal, Policy.History.KeepLast(1))


class Node:
    def __init__(self, domain):
        self.participant = DomainParticipant(domain)

    def subscribe(self, topic, kind, qos=RELIABLE):
        return DataReader(self.participant, Topic(self.participant, "rt" + topic, kind), qos=qos)

    def publish(self, topic, kind):
        return DataWriter(self.participant, Topic(self.participant, "rt" + topic, kind), qos=RELIABLE)

    def client(self, name, kind, request, response):
        return Client(self.participant, name, kind, request, response)


def wait_for(condition, seconds=10.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.002)
    return None


def with_header(kind, typename):
    """The type with the 16 bytes that rmw_cyclonedds puts before requests and answers."""
    fields = [("client", uint64), ("number", int64)] + [(f.name, f.type) for f in dataclasses.fields(kind)]
    members = {"__annotations__": dict(fields), "__module__": kind.__module__}
    made = types.new_class(kind.__name__ + "WithHeader", (IdlStruct,), {"typename": typename}, lambda body: body.update(members))
    return dataclasses.dataclass(made)


class Client:
    def __init__(self, participant, name, kind, request, response):
        package, group, service = kind.split("/")
        typename = f"{package}::{group}::dds_::{service}"
        self.request = with_header(request, typename + "_Request_")
        self.number, self.id, self.name = 0, random.getrandbits(63), name
        self.writer = DataWriter(participant, Topic(participant, f"rq{name}Request", self.request), qos=RELIABLE)
        self.reader = DataReader(participant, Topic(participant, f"rr{name}Reply",
                                                    with_header(response, typename + "_Response_")), qos=RELIABLE)

    def wait(self, seconds=10.0):
        ready = wait_for(lambda: self.writer.get_publication_matched_status().current_count and
                         self.reader.get_subscription_matched_status().current_count, seconds)
        assert ready, f"no service {self.name}"

    def send(self, *values):
        self.number += 1
        self.writer.write(self.request(self.id, self.number, *values))
        return self.number

    def answer(self, number, seconds=10.0):
        def take():
            for sample in self.reader.take(N=10):
                if hasattr(sample, "client") and sample.client == self.id and sample.number == number:
                    return sample
            return None
        return wait_for(take, seconds)

    def call(self, *values, seconds=10.0):
        self.wait()
        return self.answer(self.send(*values), seconds)
