"""Kinematics, Jacobians and moments of a URDF, as Pinocchio has them."""

import numpy as np
import pinocchio
import pytest

from armtol import Arm


@pytest.fixture(params=[("panda.urdf", "panda_link7", 7), ("ur5e.urdf", "tool0", 6)])
def both(request, source):
    file, tip, n_joints = request.param
    path = source / "tests/armtol" / file
    model = pinocchio.buildModelFromUrdf(str(path))
    return Arm.from_urdf(path, tip=tip), model, model.getFrameId(tip), n_joints


def padded(model, q):
    full = pinocchio.neutral(model)
    full[: len(q)] = q
    return full


def test_where_the_tool_is(both, random):
    arm, model, frame, n_joints = both
    data = model.createData()
    q = random.uniform(-2, 2, (200, n_joints))
    for values, found in zip(q, arm.forward(q)):
        pinocchio.framesForwardKinematics(model, data, padded(model, values))
        np.testing.assert_allclose(found, data.oMf[frame].homogeneous, atol=1e-6)  # URDFs have few digits: snap


def test_columns_of_motors_are_the_jacobian(both, random):
    """A revolute joint's theta error moves the tool as the joint does."""
    arm, model, frame, n_joints = both
    data = model.createData()
    motors = [k for k, x in enumerate(arm.parameters) if x.role == "motor"]
    for values in random.uniform(-2, 2, (50, n_joints)):
        aligned = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        jacobian = pinocchio.computeFrameJacobian(model, data, padded(model, values), frame, aligned)[:, :n_joints]
        np.testing.assert_allclose(arm.error_matrix(values)[:, motors], jacobian, atol=2e-6)


def test_moments_of_a_held_mass(both, random):
    arm, model, frame, n_joints = both
    placed = model.frames[frame]
    held = pinocchio.Inertia(2.0, np.zeros(3), np.zeros((3, 3)))
    model.appendBodyToJoint(placed.parentJoint, held, placed.placement)
    model.gravity.linear = np.array([0, 0, -9.80665])
    data = model.createData()
    turning = [i for i, link in enumerate(arm.links) if link.joint == "revolute"]
    for values in random.uniform(-2, 2, (20, n_joints)):
        gravity = pinocchio.computeGeneralizedGravity(model, data, padded(model, values))[:n_joints]
        answer = arm.predict(values, np.zeros(arm.n_parameters), payloads=[2.0])
        np.testing.assert_allclose(answer.moments[0, 0, turning], -gravity, atol=1e-4)
