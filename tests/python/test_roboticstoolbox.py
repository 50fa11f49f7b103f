"""Kinematics of tables, as the Robotics Toolbox for Python and spatialmath have them, where they are installed."""

import numpy as np
import pytest
import roboticstoolbox as rtb
from spatialmath import SE3

from armtol import Arm

ROWS = np.array([[0.0, np.pi / 2, 0.4, 0.1], [0.3, 0, 0, -0.2], [0.02, -np.pi / 2, 0.05, 0], [0, 0, 0.06, 0.3]])


@pytest.mark.parametrize(("convention", "link"), [("standard", rtb.RevoluteDH), ("modified", rtb.RevoluteMDH)])
def test_tables(convention, link, random):
    other = rtb.DHRobot([link(a=a, alpha=alpha, d=d, offset=theta) for a, alpha, d, theta in ROWS])
    made = Arm.from_dh(ROWS, convention, unit="m")
    for q in random.uniform(-3, 3, (100, 4)):
        np.testing.assert_allclose(made.forward(q), other.fkine(q).A, atol=1e-14)


def test_motors_are_the_jacobian(random):
    other = rtb.DHRobot([rtb.RevoluteDH(a=a, alpha=alpha, d=d, offset=theta) for a, alpha, d, theta in ROWS])
    made = Arm.from_dh(ROWS, unit="m")
    motors = [k for k, x in enumerate(made.parameters) if x.role == "motor"]
    for q in random.uniform(-3, 3, (100, 4)):
        np.testing.assert_allclose(made.error_matrix(q)[:, motors], other.jacob0(q), atol=1e-14)


def test_a_chain_of_spatialmath_transforms(random):
    made = Arm.from_dh(ROWS, unit="m")
    for q in random.uniform(-3, 3, (20, 4)):
        frame = SE3()
        for (a, alpha, d, theta), value in zip(ROWS, q):
            frame = frame * SE3.Rz(theta + value) * SE3(a, 0, d) * SE3.Rx(alpha)
        np.testing.assert_allclose(made.forward(q), frame.A, atol=1e-14)
