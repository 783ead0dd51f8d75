"""Learns to ride the EzyRoller: a torque on the bar for what the rider sees, so that it goes as far as it can in eight seconds.

The policy has nine numbers. CMA-ES (the package `cma`) tries a generation of policies at once, as a batch of steppers on all cores:

    pip install cma
    python ride.py 30            # generations, 60 without
"""

import sys

import cma
import ezy
import numpy as np

STEP, EVERY, SECONDS, GENERATION = 2e-3, 0.05, 8.0, 48
LARGEST_TORQUE = 4.0  # N m


def torque(policies, batch, t):
    """What each policy does: odd functions of what it sees, and a rhythm of its own."""
    seen = np.stack([
        np.sin(batch["bar.phi"]), batch["bar.omega"] / 5, batch["seat.omega"],
        np.sin(2 * t * np.exp(policies[:, 7])), np.cos(2 * t * np.exp(policies[:, 7])),
        batch["seat.vx"] * np.sin(batch["bar.phi"]), np.sin(batch["seat.phi"]),
    ], axis=1)
    return LARGEST_TORQUE * np.tanh((policies[:, :7] * seen).sum(axis=1) * np.exp(policies[:, 8]))


def distances(policies):
    """How far each policy rides from a stand, m."""
    policies = np.atleast_2d(policies)
    batch = ezy.ezyroller.ridden().batch(
        len(policies), STEP, start={"seat.vx": 0.0, "bar.phi": 0.3, "seat.omega": 0.0, "bar.omega": 0.0}
    )
    for i in range(round(SECONDS / EVERY)):
        batch.step(round(EVERY / STEP), torque=torque(policies, batch, i * EVERY))
    return np.hypot(batch["seat.x"], batch["seat.y"])


def learn(generations):
    """The best policy found, and its distance, m."""
    search = cma.CMAEvolutionStrategy(
        np.zeros(9), 0.5, {"popsize": GENERATION, "seed": 1, "maxiter": generations, "verbose": -9}
    )
    while not search.stop():
        policies = search.ask()
        reached = distances(np.array(policies))
        search.tell(policies, list(-reached))
        if search.countiter % 10 == 0:
            print(f"generation {search.countiter}: {reached.max():.2f} m")
    return search.result.xbest, -search.result.fbest


if __name__ == "__main__":
    policy, distance = learn(int(sys.argv[1]) if len(sys.argv) > 1 else 60)
    print(f"rides {distance:.2f} m in {SECONDS:g} s with", np.round(policy, 2))
