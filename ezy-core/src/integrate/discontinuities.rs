//! Discontinuities of a force or of its slope: a step that crosses one is repeated up to it.
//!
//! Across a discontinuity a method loses its order. Its error estimate may miss that, or shorten steps again and again. The scene
//! says by event functions whether a step crossed a discontinuity; the interpolant says where.
//!
//! A stage at the end of a step may be beyond the discontinuity by its own error and then sees the other law. DOP853 makes the last
//! part of the way a short step, and its error estimate controls the rest. Methods of lower order stop before the discontinuity, at a
//! distance above the uncertainty of its predicted time. That uncertainty shrinks with each step; the last step is a
//! very short one across the discontinuity.
//!
//! A smoothed law turns around within a layer. A step may pass over the layer, or begin in it and leave it, with hardly a stage in
//! it; DOP853 then judges it by its lower order.

use super::hermite::{Node, interpolate};
use super::root::{resolution_at, root, side_of};
use super::tolerances::discontinuities::{AT_END, BEHIND, CHATTERING_GUARD, CUT, TURNED, UNKNOWN};
use super::tolerances::steps::SHORTEST;
use crate::archive::Archive;
use crate::dynamics::{Rows, State, System};
use crate::model::{Equations as _, EventKind, SceneInfo, SceneRef};

/// A step that ends at a discontinuity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cut {
    /// Stop before the discontinuity, after this time, s.
    Before(f64),
    /// Stop just behind the discontinuity, after this time, s.
    Over(f64),
}

impl Cut {
    /// After a step of this length, s, from `t` that crossed the discontinuity before which it should have stopped.
    pub(crate) fn nearer(t: f64, length: f64) -> Self {
        let half = 0.5 * length;
        if half > AT_END * resolution_at(t) { Self::Before(half) } else { Self::Over(length) }
    }
}

/// What a step passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Passage {
    /// Nothing.
    Smooth,
    /// Most of the layer of a smoothed law.
    Layer,
    /// A discontinuity, so far from its start, s.
    Ends(f64),
}

/// What a method has to be told of the motion that it steps along.
pub(crate) trait Discontinuities<D, T = f64> {
    /// What the step from `from` to `end` passes; its length ends at the first discontinuity.
    fn passage(&mut self, system: &mut D, from: Node<'_, T>, end: &State<T>) -> Passage;

    /// Whether there are smoothed laws.
    fn has_layers(&self) -> bool;

    /// Whether the share of a smoothed law changes by more than `by` between two states.
    fn turns(&mut self, system: &mut D, from: &State<T>, to: &State<T>, by: f64) -> bool;

    /// The step from `from` to the first discontinuity; none when the step to `ends`, its end and other stages, crosses none. `whole_s` is
    /// the usual step length.
    fn cut(&mut self, system: &mut D, from: Node<'_, T>, ends: &[&State<T>], whole_s: f64) -> Option<Cut>;

    /// Whether a step crosses a discontinuity, at its end or at one of the other stages in `ends`.
    fn are_crossed(&mut self, system: &mut D, from: &State<T>, ends: &[&State<T>]) -> bool;

    /// Nothing was cut before.
    fn restart(&mut self);

    /// A step of fixed length was completed.
    fn rest(&mut self);
}

/// A motion without discontinuities.
pub(crate) struct Smooth;

impl<D, T> Discontinuities<D, T> for Smooth {
    fn passage(&mut self, _system: &mut D, _from: Node<'_, T>, _end: &State<T>) -> Passage {
        Passage::Smooth
    }

    fn has_layers(&self) -> bool {
        false
    }

    fn turns(&mut self, _system: &mut D, _from: &State<T>, _to: &State<T>, _by: f64) -> bool {
        false
    }

    fn cut(&mut self, _system: &mut D, _from: Node<'_, T>, _ends: &[&State<T>], _whole_s: f64) -> Option<Cut> {
        None
    }

    fn are_crossed(&mut self, _system: &mut D, _from: &State<T>, _ends: &[&State<T>]) -> bool {
        false
    }

    fn restart(&mut self) {}

    fn rest(&mut self) {}
}

/// The discontinuities and layers of a scene, with buffers.
pub(crate) struct EventDiscontinuities {
    /// Indices into the events.
    places: Vec<usize>,
    /// The same of layers.
    layers: Vec<usize>,
    /// Values at the start of the step, at its end, and between.
    values: [Vec<f64>; 3],
    q_rate: Vec<f64>,
    a: Vec<f64>,
    rate: Vec<f64>,
    lambda: Vec<f64>,
    between: State,
    /// Guard against chattering, see [`CHATTERING_GUARD`].
    chattering: u32,
}

impl EventDiscontinuities {
    pub(crate) fn new(info: &SceneInfo) -> Self {
        let of_kind = |kind: EventKind| (0..info.events.len()).filter(|&i| info.events[i].kind == kind).collect();
        let [places, layers]: [Vec<usize>; 2] = [EventKind::Discontinuity, EventKind::Layer].map(of_kind);
        // without them there is nothing to look for
        let is_smooth = places.is_empty() && layers.is_empty();
        let [n_s, n_q, n_v, n_z, n_c] =
            [info.events.len(), info.n_coordinates(), info.n_velocities(), info.n_states(), info.n_rows()]
                .map(|n| if is_smooth { 0 } else { n });
        let zeros = |n: usize| vec![0.0; n];
        Self {
            places,
            layers,
            values: [zeros(n_s), zeros(n_s), zeros(n_s)],
            q_rate: zeros(n_q),
            a: zeros(n_v),
            rate: zeros(n_z),
            lambda: zeros(n_c),
            between: State::zeros([n_q, n_v], n_z, 0),
            chattering: 0,
        }
    }

    /// Nothing was cut before.
    pub(crate) fn restart(&mut self) {
        self.chattering = 0;
    }

    /// Writes what steps take from those before, or reads it.
    pub(crate) fn remember(&mut self, archive: &mut Archive) {
        archive.count_of_few(&mut self.chattering);
    }

    /// A step of fixed length was completed.
    fn rest(&mut self) {
        self.chattering = self.chattering.saturating_sub(1);
    }

    /// Length of the step from `from` to the first discontinuity, s; none when the step to `end` crosses none.
    fn up_to<P: SceneRef>(&mut self, system: &mut System<P>, from: Node<'_>, end: &State) -> Option<f64> {
        if !self.are_crossed(system, from.state, &[end]) {
            return None;
        }
        let Self { places, values: [before, after, inside], q_rate, a, rate, lambda, between, .. } = self;
        system.place_states(&end.z);
        system.at_with(end.t, &end.q, Rows::Held).accelerations(&end.v, a, lambda).ok()?;
        system.state_rates(end.t, &end.q, &end.v, rate);
        system.position_rates(&end.q, &end.v, q_rate);
        let (start, last) = (from.state.t, end.t);
        // works do not matter here
        let to = Node { state: end, q_rate, a, rate, power: from.power };
        let resolution = resolution_at(last);
        let mut first = last;
        for &i in places.iter().filter(|&&i| changes(before[i], after[i])) {
            let Ok(t) = root((start, before[i]), (last, after[i]), resolution, |t| {
                interpolate(from, to, t, between);
                events(system, between, inside);
                Ok::<f64, std::convert::Infallible>(inside[i])
            });
            first = first.min(t);
        }
        let near = AT_END * resolution;
        let length = first - start;
        (length > near && last - first > near).then_some(length + BEHIND * resolution)
    }
}

impl<P: SceneRef> Discontinuities<System<P>> for EventDiscontinuities {
    fn passage(&mut self, system: &mut System<P>, from: Node<'_>, end: &State) -> Passage {
        if let Some(length) = self.up_to(system, from, end) {
            return Passage::Ends(length);
        }
        if self.turns(system, from.state, end, TURNED) { Passage::Layer } else { Passage::Smooth }
    }

    fn has_layers(&self) -> bool {
        !self.layers.is_empty()
    }

    fn turns(&mut self, system: &mut System<P>, from: &State, to: &State, by: f64) -> bool {
        if self.layers.is_empty() {
            return false;
        }
        let Self { layers, values: [before, after, _], .. } = self;
        events(system, from, before);
        events(system, to, after);
        layers.iter().any(|&i| (after[i] - before[i]).abs() > by)
    }

    fn cut(&mut self, system: &mut System<P>, from: Node<'_>, ends: &[&State], whole_s: f64) -> Option<Cut> {
        let end_s = ends.first()?.t;
        if self.chattering >= CHATTERING_GUARD {
            return None;
        }
        let is_crossed = self.are_crossed(system, from.state, ends);
        let Self { places, values: [before, after, inside], between, .. } = self;
        let (start, h) = (from.state.t, end_s - from.state.t);
        let resolution = resolution_at(end_s);
        let shortest_crossing = BEHIND * resolution.max(SHORTEST * start.abs());
        // a start on the discontinuity belongs to neither side
        if places.iter().any(|&i| before[i] == 0.0 && after[i] != 0.0) && h > shortest_crossing {
            self.chattering += CUT;
            return Some(Cut::Over(shortest_crossing));
        }
        if !is_crossed {
            return None;
        }
        let mut length = h;
        for &i in places.iter().filter(|&&i| changes(before[i], after[i])) {
            let mut value = |t: f64| {
                follow(from, t, between);
                events(system, between, inside);
                Ok::<f64, std::convert::Infallible>(inside[i])
            };
            let Ok(last) = value(h);
            let Ok(t) = if changes(before[i], last) {
                root((0.0, before[i]), (h, last), resolution, value)
            } else {
                // the parabola misses the discontinuity: half the way is predicted better
                Ok(0.5 * h)
            };
            length = length.min(t);
        }
        let near = AT_END * resolution;
        if h - length <= near {
            return None;
        }
        self.chattering += CUT;
        Some(if length > near {
            Cut::Before(length * (1.0 - UNKNOWN * length / whole_s))
        } else {
            Cut::Over(length + shortest_crossing)
        })
    }

    /// Keeps the values at the start and beyond the discontinuity.
    fn are_crossed(&mut self, system: &mut System<P>, from: &State, ends: &[&State]) -> bool {
        let Self { places, values: [before, after, inside], .. } = self;
        if places.is_empty() {
            return false;
        }
        events(system, from, before);
        after.copy_from_slice(before);
        let mut are_crossed = false;
        for end in ends {
            events(system, end, inside);
            for &i in &*places {
                if !changes(before[i], after[i]) {
                    after[i] = inside[i];
                    are_crossed |= changes(before[i], after[i]);
                }
            }
        }
        are_crossed
    }

    fn restart(&mut self) {
        self.restart();
    }

    fn rest(&mut self) {
        self.rest();
    }
}

/// Whether a value changes its sign.
fn changes(before: f64, after: f64) -> bool {
    side_of(before) * side_of(after) < 0.0
}

/// The state after the time `t` with the accelerations at its start; works are left out.
fn follow(from: Node<'_>, t: f64, out: &mut State) {
    let State { q, v, .. } = from.state;
    let is_planar = q.len() == v.len();
    for (i, a) in from.a.iter().enumerate() {
        if is_planar {
            out.q[i] = q[i] + t * (v[i] + 0.5 * t * a);
        }
        out.v[i] = v[i] + t * a;
    }
    if !is_planar {
        out.q.iter_mut().zip(q).zip(from.q_rate).for_each(|((out, q), rate)| *out = q + t * rate);
    }
    for (i, rate) in from.rate.iter().enumerate() {
        out.z[i] = from.state.z[i] + t * rate;
    }
    out.t = from.state.t + t;
}

/// Event functions at a state.
fn events<P: SceneRef>(system: &mut System<P>, at: &State, out: &mut [f64]) {
    system.place_states(&at.z);
    system.scene().events(system.fixed(), at.t, &at.q, &at.v, out);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::integrate::step_limit::is_too_short;
    use crate::linalg::Backend;

    crate::model! {
        /// A puck that a spring pushes from x = 0 on, and from x = 4 m on another one.
        pub model Buffer {
            param k: N/m = 16;
            body puck { mass: 1, inertia: 1 }
            effect wall { force at puck(0, 0): (-k * max(puck.x, 0) - k * max(puck.x - 4, 0), 0); }
            start near { puck at (-1, 0) angle 0; at rest; }
            scene bounces { start near; until 1 s; with wall; }
        }
    }

    /// At 3 s, with this place, velocity and acceleration.
    struct At {
        state: State,
        a: [f64; 3],
    }

    impl At {
        fn new(x: f64, v: f64, a: f64) -> Self {
            let mut state = State::zero(3, 0);
            (state.t, state.q[0], state.v[0]) = (3.0, x, v);
            Self { state, a: [a, 0.0, 0.0] }
        }

        /// Where it is after `h`.
        fn after(&self, h: f64) -> State {
            let mut out = State::zero(3, 0);
            follow(self.node(), h, &mut out);
            out.t = self.state.t + h;
            out
        }

        fn node(&self) -> Node<'_> {
            Node { state: &self.state, q_rate: &self.state.v, a: &self.a, rate: &[], power: &[] }
        }
    }

    /// Roots are located to 1e-12 s and more of the time.
    const LOCATED: f64 = 1e-11;

    /// Zero is on neither side.
    #[test]
    fn analytic_a_value_changes_sign_between_two_sides() {
        for (before, after, expected) in
            [(-1.0, 2.0, true), (1.0, -2.0, true), (1.0, 2.0, false), (-1.0, 0.0, false), (0.0, -1.0, false)]
        {
            assert_eq!(changes(before, after), expected, "{before} to {after}");
        }
    }

    #[test]
    fn analytic_states_ahead_lie_on_a_parabola() {
        let found = At::new(-1.0, 2.0, 6.0).after(0.5);
        assert_eq!((found.q[0], found.v[0]), (-1.0 + 1.0 + 0.75, 5.0));
    }

    /// From −1 m at 1 m/s the discontinuity at 0 is 1 s away: steps of a lower order stop before it by 1/32 of that part of the usual step.
    #[test]
    fn analytic_fixed_steps_stop_before_a_discontinuity() {
        let scene = buffer::Bounces::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let from = At::new(-1.0, 1.0, 0.0);
        for (h, whole) in [(1.5, 1.5), (2.0, 4.0)] {
            let mut discontinuities = EventDiscontinuities::new(system.info());
            let cut = discontinuities.cut(&mut system, from.node(), &[&from.after(h)], whole);
            let Some(Cut::Before(length)) = cut else { panic!("{cut:?}") };
            assert!((length - (1.0 - 1.0 / 32.0 / whole)).abs() <= LOCATED, "{length}");
            assert_eq!(discontinuities.chattering, CUT);
        }
        let mut discontinuities = EventDiscontinuities::new(system.info());
        assert_eq!(discontinuities.cut(&mut system, from.node(), &[&from.after(0.9)], 1.0), None);
        // the first one of two, 1 s and 5 s away
        let cut = discontinuities.cut(&mut system, from.node(), &[&from.after(6.0)], 6.0);
        let Some(Cut::Before(length)) = cut else { panic!("{cut:?}") };
        assert!((length - (1.0 - 1.0 / 192.0)).abs() <= LOCATED, "{length}");
        // just before it, over it: within ten times what is located
        let from = At::new(-5e-12, 1.0, 0.0);
        let cut = discontinuities.cut(&mut system, from.node(), &[&from.after(0.5)], 0.5);
        assert!(matches!(cut, Some(Cut::Over(length)) if length > 5e-12 && length < 2e-11), "{cut:?}");
        // on it, to the side to which it moves
        let from = At::new(0.0, 1.0, 0.0);
        let cut = discontinuities.cut(&mut system, from.node(), &[&from.after(0.5)], 0.5);
        assert!(matches!(cut, Some(Cut::Over(length)) if length > 0.0 && length < 1e-11), "{cut:?}");
        // by a step that changes the time, whenever that is
        for t in [0.0, 1e5] {
            let mut from = At::new(0.0, 1.0, 0.0);
            from.state.t = t;
            let cut = discontinuities.cut(&mut system, from.node(), &[&from.after(0.5)], 0.5);
            assert!(
                matches!(cut, Some(Cut::Over(length)) if !is_too_short(t, length) && length < 1e-11 * t.max(1.0)),
                "{cut:?}"
            );
        }
        // who chatters is not cut any more
        discontinuities.chattering = CHATTERING_GUARD;
        assert_eq!(discontinuities.cut(&mut system, from.node(), &[&from.after(0.5)], 0.5), None);
        discontinuities.rest();
        assert_eq!(discontinuities.chattering, CHATTERING_GUARD - 1);
        discontinuities.restart();
        discontinuities.rest();
        assert_eq!(discontinuities.chattering, 0);
    }

    /// A stage beyond the discontinuity counts, also where the end of the step is not; the parabola then misses it, and half of the step is taken.
    #[test]
    fn invariant_stages_beyond_a_discontinuity_cut_a_step() {
        let scene = buffer::Bounces::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let from = At::new(-1.0, 1.0, 0.0);
        let (end, stage) = (from.after(0.8), from.after(1.2));
        let mut discontinuities = EventDiscontinuities::new(system.info());
        assert!(discontinuities.are_crossed(&mut system, &from.state, &[&end, &stage]));
        assert!(!discontinuities.are_crossed(&mut system, &from.state, &[&end]));
        let cut = discontinuities.cut(&mut system, from.node(), &[&end, &stage], 0.8);
        let Some(Cut::Before(length)) = cut else { panic!("{cut:?}") };
        assert!((length - 0.4 * (1.0 - 0.5 / 32.0)).abs() <= LOCATED, "{length}");
    }

    /// A step of high order ends just behind the first discontinuity, which its interpolant locates.
    #[test]
    fn analytic_steps_of_high_order_end_behind_a_discontinuity() {
        let scene = buffer::Bounces::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut discontinuities = EventDiscontinuities::new(system.info());
        let from = At::new(-1.0, 1.0, 0.0);
        let length = |passage| if let Passage::Ends(length) = passage { length } else { f64::NAN };
        // no force up to the wall, where the end is taken from: the interpolant is that of the force at the end
        let mut end = from.after(1.0 + 1e-6);
        let found = length(discontinuities.passage(&mut system, from.node(), &end));
        assert!((found - 1.0).abs() <= 1e-9 && found > 1.0, "{found}");
        assert_eq!(discontinuities.passage(&mut system, from.node(), &from.after(0.9)), Passage::Smooth);
        // an end so near behind it that nothing is gained
        end = from.after(1.0 + 2e-12);
        assert_eq!(discontinuities.passage(&mut system, from.node(), &end), Passage::Smooth);
    }

    #[test]
    fn analytic_a_step_that_still_crosses_is_halved_as_long_as_halves_are_located() {
        assert_eq!(Cut::nearer(1.0, 0.5), Cut::Before(0.25));
        assert_eq!(Cut::nearer(0.0, 1.9e-11), Cut::Over(1.9e-11));
        assert_eq!(Cut::nearer(0.0, 2.1e-11), Cut::Before(0.5 * 2.1e-11));
    }
}
