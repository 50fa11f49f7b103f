"""Exercise 10: the Adept's A for case 1 by differences. Run: python3 10.py 1e-3"""
import sys
from math import acos, atan2, cos, sin

THETA, A, D, ALPHA, BETA = range(5)

# The joint values that put the tool at (200, 200, 0), all digits of them
INNER, OUTER = 425, 375
ELBOW = acos((200 ** 2 + 200 ** 2 - INNER ** 2 - OUTER ** 2) / (2 * INNER * OUTER))
SHOULDER = atan2(200, 200) - atan2(OUTER * sin(ELBOW), INNER + OUTER * cos(ELBOW))

# theta, a, d, alpha, beta of each link, lengths in mm
ARM = [
    [0, 0, 203.2, 0, 0], [SHOULDER, INNER, 0, 0, 0], [ELBOW, OUTER, 0, 0, 0],
    [-SHOULDER - ELBOW, 0, 0, 0, 0], [0, 0, -203.2, 0, 0], [0, 0, 0, 0, 0],
]

# The parameters of each link in the order of adpta.1
PARAMETERS = [
    [THETA, D, A, ALPHA], [THETA, A, ALPHA, BETA], [THETA, A, ALPHA, BETA],
    [THETA, A, ALPHA, BETA], [D, THETA, A, ALPHA, BETA], [THETA, D, A, ALPHA],
]


def multiply(x, y):
    return [[sum(x[i][n] * y[n][j] for n in range(4)) for j in range(4)] for i in range(4)]


def link_of(theta, a, d, alpha, beta):
    """Eq. (4.1): Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta)"""
    ct, st, ca, sa, cb, sb = cos(theta), sin(theta), cos(alpha), sin(alpha), cos(beta), sin(beta)
    turn = [[ct, -st, 0, a * ct], [st, ct, 0, a * st], [0, 0, 1, d], [0, 0, 0, 1]]
    tilt = [[cb, 0, sb, 0], [sa * sb, ca, -sa * cb, 0], [-ca * sb, sa, ca * cb, 0], [0, 0, 0, 1]]
    return multiply(turn, tilt)


def tool(link, which, off):
    """The tool of the arm with one parameter off by so much: columns 0 to 2 the rotation, 3 the place"""
    t = [[float(i == j) for j in range(4)] for i in range(4)]
    for i, nominal in enumerate(ARM):
        t = multiply(t, link_of(*[p + (off if (i, j) == (link, which) else 0) for j, p in enumerate(nominal)]))
    return t


def column_of(link, which, step):
    """How far the tool moves along x, y, z and turns about x, y, z when this parameter is off by 1"""
    # begin: yours
    return [0, 0, 0, 0, 0, 0]
    # end: yours


def main():
    step = float(sys.argv[1]) if len(sys.argv) > 1 else 1e-3
    for link, parameters in enumerate(PARAMETERS):
        for which in parameters:
            print(" ".join("%11.6f" % x for x in column_of(link, which, step)))


main()
