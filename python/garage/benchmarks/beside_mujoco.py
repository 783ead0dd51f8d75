"""Steps a second, and errors at equal steps, of a double pendulum: EZY, MuJoCo, and NumPy with EZY's exported equations.

    pip install mujoco
    ezy export numpy doublependulum/swing --out doublependulum_swing.py
    python beside_mujoco.py

All take steps of the classical method of Runge and Kutta of order 4. Times are of the processor; those of many at once are of one thread.
"""

import time

import ezy
import mujoco
import mujoco.rollout
import numpy as np

import doublependulum_swing as exported

SECONDS, MANY = 4.0, 256
ROD = '<inertial pos="0.5 0 0" mass="1" diaginertia="1e-6 {0} {0}"/>'.format(1 / 12)
XML = f"""
<mujoco><option timestep="{{step}}" integrator="RK4" gravity="0 0 -9.81"><flag contact="disable"/></option><worldbody>
<body><joint name="upper" type="hinge" axis="0 -1 0"/>{ROD}
<body pos="1 0 0"><joint name="lower" type="hinge" axis="0 -1 0"/>{ROD}</body></body></worldbody></mujoco>
"""


def timed(work, n_steps):
    """Steps a second of a processor: the best of three."""
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        work()
        best = min(best, time.process_time() - start)
    return n_steps / best


def by_numpy(step, n_steps, start):
    """Angles at the end, of states that are columns."""
    c = exported.constants(exported.values(exported.PARAMETERS))
    n = len(start)

    def rates(t, y):
        return np.concatenate([y[n:], exported.accelerations(t, y[:n], y[n:], c)[0]])

    y, t = np.concatenate([start, np.zeros_like(start)]), 0.0
    for _ in range(n_steps):
        k1 = rates(t, y)
        k2 = rates(t + step / 2, y + step / 2 * k1)
        k3 = rates(t + step / 2, y + step / 2 * k2)
        k4 = rates(t + step, y + step * k3)
        y, t = y + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4), t + step
    return y[[2, 5]]


def main():
    scene = ezy.doublependulum.swing()
    exact = scene.run(until=SECONDS, rtol=1e-13)
    exact = np.array([exact["upper.phi"][-1], exact["lower.phi"][-1]])
    level = exported.values(exported.COORDINATES)
    print("step [s]  program           error [rad]  steps/s, one  steps/s, many")
    for step in (1e-2, 1e-3):
        n_steps = round(SECONDS / step)
        stepper = scene.stepper(step)

        def one_of_ezy():
            stepper.reset()
            for _ in range(n_steps):
                stepper.step(1)

        batch, lanes = (scene.batch(MANY, step, threads=1, lanes=lanes) for lanes in (False, True))

        def many_of_ezy(batch):
            batch.reset()
            for _ in range(n_steps):
                batch.step(1)

        def error(of):
            return max(np.max(abs(of["upper.phi"] - exact[0])), np.max(abs(of["lower.phi"] - exact[1])))

        speeds = [timed(one_of_ezy, n_steps), timed(lambda: many_of_ezy(batch), n_steps * MANY)]
        row(step, "EZY", error(stepper), speeds)
        speed = timed(lambda: many_of_ezy(lanes), n_steps * MANY)
        row(step, "EZY, in lanes", error(lanes), [speeds[0], speed])

        model = mujoco.MjModel.from_xml_string(XML.format(step=step))
        data = mujoco.MjData(model)

        def one_of_mujoco():
            mujoco.mj_resetData(model, data)
            for _ in range(n_steps):
                mujoco.mj_step(model, data)

        speed = timed(one_of_mujoco, n_steps)
        angles = np.array([data.qpos[0], data.qpos.sum()])
        size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        state = np.zeros(size)
        mujoco.mj_resetData(model, data)
        mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        states = np.tile(state, (MANY, 1))

        def many_of_mujoco():
            mujoco.rollout.rollout(model, [data], initial_state=states, nstep=n_steps)

        row(step, "MuJoCo", abs(angles - exact).max(), [speed, timed(many_of_mujoco, n_steps * MANY)])

        found = by_numpy(step, n_steps, level)
        fewer = n_steps // 10
        speeds = [
            timed(lambda: by_numpy(step, fewer, level), fewer),
            timed(lambda: by_numpy(step, fewer, np.tile(level[:, None], (1, MANY))), fewer * MANY),
        ]
        row(step, "exported to NumPy", abs(found - exact).max(), speeds)


def row(step, name, error, speeds):
    print(f"{step:8g}  {name:17} {error:11.1e}  {speeds[0]:12,.0f}  {speeds[1]:13,.0f}")


if __name__ == "__main__":
    main()
