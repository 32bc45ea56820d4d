"""What happens on a railway without its controller: while it is dark, or vehicles are moved under local rules."""

from __future__ import annotations

from typing import TYPE_CHECKING

from interlock.simulate.track import NONE

if TYPE_CHECKING:
    from interlock.simulate.world import World


def power_cut(world: World) -> None:
    """The controller has gone dark: whoever stands needs a new call; points may be cranked, devices open.  It forgets
    which were trailed: whoever releases sections afterwards has looked at their points first (R10, R16)."""
    for t in world.trains:
        if t.speed == 0.0:
            t.driver.called = t.driver.accepted = t.driver.expects = False
            world.traffic.waits_on(t)
    world.machines.contacts.lost.clear()
    world.machines.driven.clear()
    for m in tuple(world.machines.damaged):
        world.machines.put_right(m)


def run_through(world: World, m: int) -> None:
    """A vehicle runs through points under local rules, where no train is called over them."""
    machines, position = world.machines, world.machines.position[m]
    if m not in machines.driven or machines.hand[m] or position == NONE or m in machines.damaged:
        return
    contact = machines.contacts.names[m][position]
    if not all(past["VALID"] and past[contact] for past, _ in world.reports.past):
        return
    if any((t.speed or t.driver.accepted) and world.sight.meets(t, m, 1500.0) for t in world.trains):
        return
    if world.watch.under_train(world, m) is None:
        machines.damage(m, world.rng.uniform(6.0, 20.0))


def cranked(world: World) -> None:
    """While everything stands without power points are cranked and devices open, but no point under a train."""
    for m in range(len(world.machines.names)):
        if world.rng.random() < 0.3 and not world.watch.under_train(world, m):
            p = world.rng.randrange(2)
            world.machines.position[m] = world.machines.target[m] = p
            world.machines.left[m] = 0.0
            world.machines.lay(m, p)
