"""The wire as the product's headers lay it out, read for the tools: bus/shark/fields.hpp says where each bit lives,
bus/shark/packet_table.hpp who sends which type and how long it is. Nothing here knows a bit by itself.
"""
import os
import re

FIELDS = "bus/shark/fields.hpp"
PACKETS = "bus/shark/packet_table.hpp"
FRAME = "bus/shark/frame.hpp"

# Between the module that a packet_table row names and the lifeline that it has in a diagram.
SENDERS = {"remote": ("SR",), "attendant": ("SACU",), "remote_or_attendant": ("SR", "SACU"), "tester": ("tester",),
           "power_module": ("SPM",), "nobody": ()}

TYPE = re.compile(r"^// Type ([0-9A-F]{2}) .*\(SB-.*\)\s*$")
FIELD = re.compile(r"^constexpr base::Field (\w+)\{(\d), (\d), (\d)\};")
PACKET = re.compile(r"^\s*row\(Type::(\w+),\s*Sender::(\w+),\s*(\w+),\s*(\w+)\),")
TYPE_NUMBER = re.compile(r"^\s*(\w+) = 0x([0-9A-F]),")

PARTS = ("_high", "_middle", "_low")


class Broken(Exception):
    """What is read is not what it should be."""


class Field:
    def __init__(self, type_, name, byte, high, low, line):
        self.type, self.name, self.byte, self.high, self.low, self.line = type_, name, byte, high, low, line

    def bits(self):
        return "%d" % self.high if self.high == self.low else "%d-%d" % (self.high, self.low)

    # As a test names it: 01.3.6, or 01.0.4-0.
    def tag(self):
        return "%s.%d.%s" % (self.type, self.byte, self.bits())

    def width(self):
        return self.high - self.low + 1

    # Of data bytes with or without their markers.
    def of(self, data):
        return data[self.byte] >> self.low & (1 << self.width()) - 1 if self.byte < len(data) else 0

    # What a number in several fields is called as a whole: "speed" of speed_high; None for a whole field.
    def whole(self):
        return next((self.name[:-len(part)] for part in PARTS if self.name.endswith(part)), None)


class Packet:
    def __init__(self, type_, name, sender, least_heard, most_said):
        self.type, self.name, self.sender = type_, name, sender
        self.least_heard, self.most_said = least_heard, most_said
        self.fields = []


def lines_of(root, file):
    with open(os.path.join(root, file), encoding="utf-8") as stream:
        return stream.read().splitlines()


def read_fields(root):
    """Every field, in the order of the file."""
    fields, type_ = [], None
    for number, line in enumerate(lines_of(root, FIELDS), 1):
        if line.startswith("}"):
            type_ = None
        match = TYPE.match(line)
        if match:
            type_ = match.group(1)
        match = FIELD.match(line)
        if match:
            if type_ is None:
                raise Broken("%s:%d: the field %s stands below no '// Type NN name (ids)'"
                             % (FIELDS, number, match.group(1)))
            fields.append(Field(type_, match.group(1), *(int(part) for part in match.groups()[1:]), number))
        elif "base::Field" in line:
            raise Broken("%s:%d: is no field as the tools read it" % (FIELDS, number))
    return fields


def read_packets(root):
    """Every type that is not reserved, by its two digits, with its fields."""
    numbers = {}
    for line in lines_of(root, FRAME):
        match = TYPE_NUMBER.match(line)
        if match:
            numbers[match.group(1)] = "0" + match.group(2)
    longest = next(int(number) for line in lines_of(root, FRAME)
                   for number in re.findall(r"longest_data = (\d+);", line))
    packets = {}
    for line in lines_of(root, PACKETS):
        match = PACKET.match(line)
        if match:
            name, sender, heard, said = match.groups()
            said = longest if said == "longest_data" else int(said)
            packets[numbers[name]] = Packet(numbers[name], name, sender, int(heard), said)
    for field in read_fields(root):
        packets[field.type].fields.append(field)
    return packets


# ---- bytes as they stand on the wire, checked against section 2 of the requirements, not against the product

TF = 0x0F


def checksum(start_and_data):
    return 0x80 | 0x7F - (sum(start_and_data) & 0x7F)  # SB-2.5


def split_turn(turn):
    """The packets of a turn's bytes, and whether TF ends it; Broken if they are no sound packets."""
    packets, at = [], 0
    while at < len(turn):
        start = turn[at]
        if start == TF:
            if at + 1 != len(turn):
                raise Broken("something follows TF")
            return packets, True
        if start >= 0x80:
            raise Broken("%02X is no start byte, its bit 7 is set" % start)
        packet = turn[at:at + (start >> 4) + 3]
        if len(packet) < (start >> 4) + 3:
            raise Broken("a packet that begins with %02X has %d bytes, and here are %d"
                         % (start, (start >> 4) + 3, len(packet)))
        for byte in packet[1:]:
            if byte < 0x80:
                raise Broken("%02X inside a packet has bit 7 clear" % byte)
        if packet[-1] != checksum(packet[:-1]):
            raise Broken("the checksum of %s is %02X"
                         % (" ".join("%02X" % byte for byte in packet), checksum(packet[:-1])))
        packets.append(packet)
        at += len(packet)
    return packets, False
