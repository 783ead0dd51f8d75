//! The slider-crank: a crank on a bearing, a rod on its pin, the rod's far end on a straight guide.
//!
//! ```text
//!            pin
//!             o
//!     crank ╱   ╲ rod
//!         ╱       ╲
//!  bearing o ─ ─ ─ ─ o ─ ─ ─ guide ─ ─
//!                  slider
//! ```
//!
//! Coordinates: `crank.x crank.y crank.phi rod.x rod.y rod.phi`; rows: `bearing.x bearing.y pin.x pin.y guide`.
//! Degrees of freedom: 1 at position level, 1 at velocity level. Slider at x = r cos φ1 + l cos φ2 with r sin φ1 + l sin φ2 = 0.
//! The default centres of mass lie on the bearing and on the slider; a slider that does not turn is a point mass, part of
//! the rod. Where crank and rod are equally long the rows lose a rank when both stand upright.
//! Source: example idaSlCrank of SUNDIALS 7.5 (spring with damper between the middles, force on the rod's tip).
//!
#![doc = include_str!("../../sketches/slidercrank.html")]

use ezy_core::model;

model! {
    /// A crank and a rod whose end is led along a straight line.
    pub model SliderCrank {
        /// crank, from bearing to pin
        param r: m = 0.5;
        /// rod, from pin to slider
        param l: m = 1.0;
        /// crank's centre of mass, from the bearing
        param r_centre: m = 0.0;
        /// rod's centre of mass, from the pin
        param l_centre: m = 1.0;
        /// mass of the crank
        param m1: kg = 1.0;
        /// moment of inertia of the crank
        param i1: kg*m^2 = 1.0;
        /// mass of the rod
        param m2: kg = 1.0;
        /// moment of inertia of the rod
        param i2: kg*m^2 = 2.0;

        body crank { mass: m1, inertia: i1 }
        body rod { mass: m2, inertia: i2 }
        point slider = rod(l - l_centre, 0);

        hinge bearing: ground(0, 0) ~ crank(-r_centre, 0);
        hinge pin: crank(r - r_centre, 0) ~ rod(-l_centre, 0);
        slot guide: ground(0, 0) ~ slider along ground(1, 0);

        /// A spring with a damper between the middles of crank and rod.
        effect strut {
            /// stiffness
            param k: N/m = 1.0;
            /// length without force
            param l0: m = 1.0;
            /// damping
            param c: N*s/m = 1.0;
            spring crank(r/2 - r_centre, 0) ~ rod(l/2 - l_centre, 0): stiffness k, length l0, damping c;
        }

        /// A steady force along the guide, on the tip of the rod.
        effect push {
            /// force
            param f: N = 1.0;
            /// tip of the rod, beyond the slider
            param tip: m = 1.0;
            force at rod(l - l_centre + tip, 0): (f, 0);
        }

        /// The guide is level.
        effect weight {
            /// gravity, downwards
            param g: m/s^2 = 9.81;
            gravity (0, -g);
        }

        start upright { crank angle pi/2; rod near angle -pi/6; at rest; }

        /// From rest, with the crank upright.
        scene pushed { start upright; until 10 s; with strut, push; }
        /// Under its weight alone.
        scene falling { start upright; until 1 s; with weight; }
    }
}
