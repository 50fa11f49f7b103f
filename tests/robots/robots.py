"""robots.py ARMTOL FOLDER [--list]: every chain of every URDF and xacro file below FOLDER, read by armtol and by the
plain reader below, which multiplies matrices as the format's text says and knows nothing of armtol.

Printed for each package: files and chains read, those refused and why, the largest difference of the two forward
kinematics (also of the table in Craig's order), the chains that have a length beyond twice their reach, and those whose
tolerances change by more than 1 % when the angles of the file are rounded to ten digits. --list names these chains.
Exit status 1 where kinematics differ, or armtol ends by anything but an answer or a refusal.
"""

import collections
import csv
import io
import math
import os
import random
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

MOVES = ("revolute", "continuous", "prismatic")
POSES = 3
SAME = 1e-9  # of the reach, or of a metre where that is longer
ACCURACY = ".0005,.0005,.0005,.002,.002,.002"


# ---- matrices ----


def product(*matrices):
    result = matrices[0]
    for right in matrices[1:]:
        result = [[sum(result[i][k] * right[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
    return result


def move(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def turn(axis, angle):
    """Rodrigues' formula."""
    length = math.sqrt(sum(v * v for v in axis))
    x, y, z = (v / length for v in axis)
    c, s = math.cos(angle), math.sin(angle)
    t = 1 - c
    return [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0],
        [0, 0, 0, 1],
    ]


def inverse(matrix):
    rotation = [[matrix[j][i] for j in range(3)] for i in range(3)]
    position = [-sum(rotation[i][k] * matrix[k][3] for k in range(3)) for i in range(3)]
    return [rotation[i] + [position[i]] for i in range(3)] + [[0, 0, 0, 1]]


def difference(one, other):
    return max(abs(one[i][j] - other[i][j]) for i in range(3) for j in range(4))


# ---- the plain reader ----


def numbers(element, name, default):
    text = element.get(name) if element is not None else None
    return [float(word) for word in text.split()] if text is not None else list(default)


class Joint:
    def __init__(self, element):
        origin = element.find("origin")
        mimic = element.find("mimic")
        limit = element.find("limit")
        self.name = element.get("name")
        self.type = element.get("type")
        self.parent = element.find("parent").get("link")
        self.child = element.find("child").get("link")
        self.axis = numbers(element.find("axis"), "xyz", (1, 0, 0))
        self.xyz = numbers(origin, "xyz", (0, 0, 0))
        roll, pitch, yaw = numbers(origin, "rpy", (0, 0, 0))
        self.origin = product(move(*self.xyz), turn((0, 0, 1), yaw), turn((0, 1, 0), pitch), turn((1, 0, 0), roll))
        self.leader = mimic.get("joint") if mimic is not None else None
        self.multiplier = numbers(mimic, "multiplier", (1,))[0]
        self.offset = numbers(mimic, "offset", (0,))[0]
        self.limits = [numbers(limit, end, (0,))[0] for end in ("lower", "upper")]
        if limit is None or self.type == "continuous" or self.limits[0] >= self.limits[1]:
            self.limits = None

    def moves(self):
        return self.type in MOVES

    def transform(self, value):
        if self.type == "prismatic":
            length = math.sqrt(sum(v * v for v in self.axis))
            return product(self.origin, move(*(value * v / length for v in self.axis)))
        return product(self.origin, turn(self.axis, value)) if self.moves() else self.origin


class Robot:
    def __init__(self, root):
        self.joints = [Joint(element) for element in root.findall("joint")]
        self.above = {joint.child: joint for joint in self.joints}
        parents = {joint.parent for joint in self.joints}
        links = [element.get("name") for element in root.findall("link")]
        self.leaves = [link for link in links if link not in parents]

    def chain(self, leaf):
        """The joints from the root, or from below the last that floats, to the leaf; and the link they begin at."""
        joints = []
        link = leaf
        while link in self.above and self.above[link].type not in ("floating", "planar"):
            joints.insert(0, self.above[link])
            link = self.above[link].parent
        return link, joints

    def chains(self):
        """One for each leaf, and one from the first leaf to the last where both hang from the same link."""
        for leaf in self.leaves:
            base, joints = self.chain(leaf)
            if any(joint.moves() for joint in joints):
                yield base, leaf, [], joints
        if len(self.leaves) > 1:
            first, last = self.leaves[0], self.leaves[-1]
            one, other = self.chain(first), self.chain(last)
            if one[0] == other[0]:
                common = 0
                while common < min(len(one[1]), len(other[1])) and one[1][common] is other[1][common]:
                    common += 1
                up, down = one[1][common:][::-1], other[1][common:]
                if any(joint.moves() for joint in up + down):
                    yield first, last, up, down


def free_joints(chain):
    """Those that have a value of their own: the others follow one that is in the chain, at the end of their mimics."""
    by_name = {joint.name: joint for joint in chain if joint.moves()}
    return [joint for joint in chain if joint.moves() and leader_of(joint, by_name)[0] is joint]


def leader_of(joint, by_name):
    leader, multiplier, offset = joint, 1.0, 0.0
    while leader.leader in by_name:
        offset += multiplier * leader.offset
        multiplier *= leader.multiplier
        leader = by_name[leader.leader]
    return leader, multiplier, offset


def plain_kinematics(up, down, values):
    by_name = {joint.name: joint for joint in up + down if joint.moves()}
    result = move(0, 0, 0)
    for joint in up + down:
        leader, multiplier, offset = leader_of(joint, by_name)
        value = multiplier * values[leader.name] + offset if joint.moves() else 0
        step = joint.transform(value)
        result = product(result, inverse(step) if joint in up else step)
    return result


# ---- the tables that armtol makes ----


def table_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    rows = csv.DictReader(io.StringIO("\n".join(lines[lines.index("") + 1 :])), skipinitialspace=True)
    return [{key.strip(): value.strip() for key, value in row.items()} for row in rows]


def cell(row, name, default=0.0):
    return float(row[name]) if row.get(name, "-") != "-" else default


def table_kinematics(rows, values, craig):
    values = iter(values)
    own = [next(values) if row["joint"] != "fixed" and row.get("couple", "-") == "-" else None for row in rows]
    result = move(0, 0, 0)
    for i, row in enumerate(rows):
        value = 0.0
        if row["joint"] != "fixed":
            leader = int(cell(row, "couple", i))
            value = own[i] if leader == i else cell(row, "multiplier", 1) * own[leader] + cell(row, "offset")
            value *= cell(row, "sign", 1)
        theta = turn((0, 0, 1), cell(row, "theta") + (value if row["joint"] == "theta" else 0))
        d = move(0, 0, cell(row, "d") + (value if row["joint"] == "d" else 0))
        a = move(cell(row, "a"), 0, 0)
        alpha, beta = turn((1, 0, 0), cell(row, "alpha")), turn((0, 1, 0), cell(row, "beta"))
        steps = (alpha, a, beta, theta, d) if craig else (theta, d, a, alpha, beta)
        if craig and cell(row, "beta"):
            steps = (a, alpha, beta, theta, d)  # Trans(x) and Rot(x) may be exchanged, beta comes behind both
        result = product(result, *steps)
    return result


# ---- one chain ----


def run(armtol, *words):
    return subprocess.run([armtol, *words], capture_output=True, text=True, errors="replace", check=False)


def draw(joints, generator):
    """Values within limits, and within half a metre or half a turn: some files have limits of 1e16."""
    values = {}
    for joint in joints:
        most = 0.5 if joint.type == "prismatic" else math.pi
        low, high = (max(-most, min(most, end)) for end in joint.limits or (-most, most))
        values[joint.name] = generator.uniform(low, high)
    return values


def reason(text):
    """What a refusal says, without the names in it."""
    last = text.strip().splitlines()[-1] if text.strip() else "nothing said"
    last = last.split(": ", 2)[-1]
    words = [word if not word.startswith('"') else "..." for word in last.split()]
    return " ".join(words)[:110]


def tolerances(armtol, path, base, tip, joints, values):
    q = ",".join(repr(values[joint.name]) for joint in joints)
    ran = run(armtol, path, "--base", base, "--tip", tip, "--joints=" + q, "--accuracy", ACCURACY, "--ignore-limits",
              "--csv")
    if ran.returncode != 0:
        return None
    rows = csv.DictReader(io.StringIO(ran.stdout), skipinitialspace=True)
    return {(row["link"], row["kind"], row["parameter"]): float(row["tolerance"]) for row in rows}


def changed(one, other):
    """By how much tolerances differ, as a share; inf where there are others."""
    if one is None or other is None or one.keys() != other.keys():
        return 0.0 if one is None and other is None else math.inf
    most = 0.0
    for key, value in one.items():
        if value != other[key]:
            fine = math.isfinite(value + other[key]) and value > 0
            most = max(most, abs(other[key] / value - 1) if fine else math.inf)
    return most


def rounded(path):
    """The file with its angles rounded to ten digits, as a temporary one; None where none changes."""
    tree = ElementTree.parse(path)
    any_changed = False
    for origin in tree.getroot().iterfind("joint/origin"):
        text = origin.get("rpy")
        if text is not None:
            new = " ".join("%.10g" % float(word) for word in text.split())
            any_changed = any_changed or [float(w) for w in new.split()] != [float(w) for w in text.split()]
            origin.set("rpy", new)
    if not any_changed:
        return None
    with tempfile.NamedTemporaryFile("wb", suffix=".urdf", delete=False) as stream:
        tree.write(stream)
    return stream.name


class Tally:
    def __init__(self):
        self.files = self.files_read = self.chains = self.read = self.moved = 0
        self.refused = collections.Counter()
        self.worst = 0.0
        self.wrong, self.long, self.turned = [], [], []


def length_of(up, down):
    return sum(math.sqrt(sum(v * v for v in joint.xyz)) for joint in up + down)


def exact_words(armtol):
    """What keeps armtol from taking axes that nearly meet for meeting, where it does."""
    words = ("--snap", "0")
    return words if run(armtol, "ur5e", "--show", *words).returncode == 0 else ()


def try_chain(armtol, path, chain, other_path, tally, generator):
    base, tip, up, down = chain
    name = f"{path} from {base} to {tip}"
    words = (path, "--base", base, "--tip", tip, "--show")
    tally.chains += 1
    exact = exact_words(armtol)
    shown, craig, usual = run(armtol, *words, *exact), run(armtol, *words, *exact, "--craig"), run(armtol, *words)
    if shown.returncode != 0:
        tally.refused[reason(shown.stderr)] += 1
        if shown.returncode != 2:
            tally.wrong.append(f"{name}: status {shown.returncode}")
        return
    tally.read += 1
    rows, craig_rows = table_of(shown.stdout), table_of(craig.stdout)
    joints = free_joints(up + down)
    reach = max(length_of(up, down), 1e-9)
    for _ in range(POSES):
        values = draw(joints, generator)
        q = [values[joint.name] for joint in joints]
        meant = plain_kinematics(up, down, values)
        off = max(difference(meant, table_kinematics(rows, q, False)),
                  difference(meant, table_kinematics(craig_rows, q, True)))
        tally.worst = max(tally.worst, off / max(reach, 1))
        if not off <= SAME * max(reach, 1):
            tally.wrong.append(f"{name}: the tool is off by {off:g}")
    longest = max(max(abs(cell(row, "a")), abs(cell(row, "d"))) for row in table_of(usual.stdout))
    if longest > 2 * reach:
        tally.long.append(f"{name}: {longest:g} for a reach of {reach:g}")
    if other_path is not None:
        one = tolerances(armtol, path, base, tip, joints, values)
        other = tolerances(armtol, other_path, base, tip, joints, values)
        tally.moved += one is not None or other is not None
        share = changed(one, other)
        if share > 0.01:
            tally.turned.append(f"{name}: {100 * share:.3g} %")


def try_file(armtol, path, tally, generator):
    expanded = None
    if path.endswith(".xacro"):
        ran = subprocess.run(["xacro", path], capture_output=True, check=False)
        by_armtol = run(armtol, path, "--links")
        if ran.returncode != 0 or by_armtol.returncode != 0:
            tally.files += 1
            tally.refused[f"a xacro file: {reason(by_armtol.stderr)}"] += 1
            return
        with tempfile.NamedTemporaryFile("wb", suffix=".urdf", delete=False) as stream:
            stream.write(ran.stdout)
        expanded = path = stream.name
    tally.files += 1
    try:
        root = ElementTree.parse(path).getroot()
        robot = Robot(root)
        chains = list(robot.chains())
    except (ElementTree.ParseError, AttributeError, ValueError, TypeError) as error:
        ran = run(armtol, path, "--links")
        tally.refused[f"whole file: {reason(ran.stderr) if ran.returncode != 0 else error}"] += 1
        return
    other_path = rounded(path)
    before = tally.read
    for chain in chains:
        try_chain(armtol, path, chain, other_path, tally, generator)
    if not chains:
        tally.refused["no joint that moves"] += 1
    tally.files_read += tally.read > before
    for name in filter(None, (other_path, expanded)):
        os.unlink(name)


def find_files(folder):
    for where, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            if name.endswith((".urdf", ".urdf.xacro")):
                yield os.path.join(where, name)


def package_of(path):
    for name in ("example-robot-data", "rtbdata", "pybullet_data"):
        if name in path:
            return name
    return "others"


def print_tally(name, tally, names):
    print(f"{name}: {tally.files} files, {tally.files_read} read; {tally.chains} chains, {tally.read} read")
    print(f"  forward kinematics differ by {tally.worst:.2g} of the reach at most; {len(tally.wrong)} wrong")
    print(f"  {len(tally.long)} chains with a length beyond twice their reach")
    print(f"  {len(tally.turned)} of {tally.moved} chains change by more than 1 % with angles of ten digits")
    for why, count in tally.refused.most_common():
        print(f"  refused {count:4}: {why}")
    for line in tally.wrong + (tally.long + tally.turned if names else []):
        print(f"  {line}")


def main():
    armtol, folder = sys.argv[1:3]
    tallies = collections.defaultdict(Tally)
    for path in find_files(folder):
        try_file(armtol, path, tallies[package_of(path)], random.Random(1987))
    for name, tally in sorted(tallies.items()):
        print_tally(name, tally, "--list" in sys.argv)
    if not tallies:
        print("no URDF found")
    return 1 if not tallies or any(tally.wrong for tally in tallies.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
