"""The driven EzyRoller by heyoka (Taylor's method, compiled for this processor), as rows of the table of `docs/compared.md`.

    pip install heyoka
    python3 tests/compare/heyoka_driven.py

Equations by hand, reduced to two speeds by Kane's method: the speed of the rear wheel and the rate of the seat, then the angle of the bar
against the seat, and heading and place of the seat. Time is that of the processor, of the integration alone: heyoka compiles its integrator
once, which is left out.
"""

import json
import math
import pathlib
import time

import heyoka as hy

ERRORS = [1e-4, 1e-6, 1e-9, 1e-11, 1e-12]
ROUNDS = 25
ANSWERS = pathlib.Path(__file__).parents[1] / "answers" / "ezyroller_driven.json"

A, B, C, D = 0.2, 0.6, 0.1, 0.1  # lengths, m: models/src/vehicles/ezy_roller.rs
M1, I1, M2, I2 = 46.0, 10.0, 1.0, 0.005  # kg, kg m^2
M0, OMEGA = 2.0, math.pi  # N m, rad/s
UNTIL = 60.0


def equations():
    """Rates of [u, omega, beta, theta, x, y] as heyoka takes them."""
    u, omega, beta, theta, x, y = hy.make_vars("u", "omega", "beta", "theta", "x", "y")
    s, c = hy.sin(beta), hy.cos(beta)
    # from the hinge to either wheel
    rear, front = A + B, C + D
    torque = M0 * hy.cos(OMEGA * hy.time)
    bar_omega = (u * s - rear * omega * c) / front
    turning = bar_omega - omega
    # of the bar's centre along the bar; across it moves with -C bar_omega
    along = u * c + rear * omega * s
    about_wheel = M2 * C**2 + I2
    k = about_wheel / front**2
    m11 = M1 + M2 * c * c + k * s * s
    m12 = (M2 - k) * rear * s * c
    m22 = M1 * A**2 + I1 + rear**2 * (M2 * s * s + k * c * c)
    force = M2 * (C * bar_omega * bar_omega - turning * front * bar_omega)
    moment = torque + about_wheel * turning * along / front - M2 * C * along * bar_omega
    f1 = M1 * A * omega * omega - force * c - moment * s / front
    f2 = torque + moment * rear * c / front - M1 * A * u * omega - force * rear * s
    determinant = m11 * m22 - m12 * m12
    return [
        (u, (m22 * f1 - m12 * f2) / determinant),
        (omega, (m11 * f2 - m12 * f1) / determinant),
        (beta, turning),
        (theta, omega),
        (x, u * hy.cos(theta) - A * omega * hy.sin(theta)),
        (y, u * hy.sin(theta) + A * omega * hy.cos(theta)),
    ]


def coordinates(state):
    """Place and angle of the seat, then of the bar."""
    _, _, beta, theta, x, y = state
    psi = theta + beta
    bar_x = x + B * math.cos(theta) + D * math.cos(psi)
    return [x, y, theta, bar_x, y + B * math.sin(theta) + D * math.sin(psi), psi]


def end_of_reference():
    [end] = [state for state in states(json.loads(ANSWERS.read_text())) if float(state["t"]) == UNTIL]
    return [float(q) for q in end["q"]]


def states(answers):
    """Every state of the file that has time and coordinates."""
    if isinstance(answers, dict):
        if "q" in answers and "t" in answers:
            yield answers
        else:
            for value in answers.values():
                yield from states(value)
    elif isinstance(answers, list):
        for value in answers:
            yield from states(value)


def main():
    end = end_of_reference()
    rhs, points = equations(), []
    for half_decades in range(8, 31):
        integrator = hy.taylor_adaptive(rhs, [0.0] * 6, tol=10.0 ** (-half_decades / 2))
        fastest = math.inf
        for _ in range(ROUNDS):
            integrator.time = 0.0
            integrator.state[:] = [0.0, 0.0, math.pi, 0.0, 0.0, 0.0]
            began = time.process_time()
            integrator.propagate_until(UNTIL)
            fastest = min(fastest, time.process_time() - began)
        error = max(abs(found - exact) for found, exact in zip(coordinates(integrator.state), end, strict=True))
        points.append((error, fastest))
    columns = []
    for target in ERRORS:
        good = [fastest for error, fastest in points if error <= target]
        columns.append(f"{1e3 * min(good):10.3f}" if good else f"{'–':>10}")
    print(f"{'heyoka ' + hy.__version__:32}{'by hand':10}{''.join(columns)}{min(points)[0]:16.1e}")


if __name__ == "__main__":
    main()
