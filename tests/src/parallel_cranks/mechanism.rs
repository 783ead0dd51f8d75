//! The mechanism: two to seven cranks, written out or counted.

// the rows that repeat others are the case
#![allow(deprecated)]

use crate::garage::set;
use ezy_core::model;
use ezy_core::model::Scene;

/// One crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crank {
    /// Where its foot stands along the ground, m; its head is as far along the coupler.
    pub at_m: f64,
    /// kg
    pub mass_kg: f64,
    /// From its foot to its centre of mass, m.
    pub centre_m: f64,
    /// About its centre of mass, kg·m².
    pub inertia_kg_m2: f64,
}

/// The cranks with their coupler.
#[derive(Debug, Clone, PartialEq)]
pub struct Cranks {
    /// Length of every crank, m.
    pub length_m: f64,
    /// Slope of the line of the feet.
    pub slope: f64,
    /// kg
    pub coupler_kg: f64,
    /// About its centre of mass, kg·m².
    pub coupler_kg_m2: f64,
    /// From the first pin to the coupler's centre of mass, m.
    pub behind_m: f64,
    /// Two to seven.
    pub cranks: Vec<Crank>,
    /// Whether the scene is that of a model with counts, whose cranks are alike but for their places.
    pub counted: bool,
}

/// Declares a scene with these cranks.
macro_rules! written_out {
    ($Model:ident $(#[$text:meta])*: $($crank:ident $foot:ident $head:ident $at:ident $mass:ident $centre:ident $inertia:ident),*) => {
        model! {
            $(#[$text])*
            pub model $Model {
                param l: m = 1.0;
                param slope = 0.0;
                param m_coupler: kg = 10.0;
                param i_coupler: kg*m^2 = 0.7;
                param behind: m = 0.0;
                body coupler { mass: m_coupler, inertia: i_coupler }
                $(
                    param $at: m = 0.0;
                    param $mass: kg = 1.0;
                    param $centre: m = 0.5;
                    param $inertia: kg*m^2 = 0.1;
                    body $crank { mass: $mass, inertia: $inertia }
                    hinge $foot: ground($at, slope*$at) ~ $crank(-$centre, 0);
                    hinge $head: $crank(l - $centre, 0) ~ coupler($at - behind, slope*$at);
                )*
                gravity (0, -9.81);
                start parallel { coupler angle 0 rate 0; at rest; }
                scene swing { start parallel; until 4 s; }
            }
        }
    };
}

written_out!(Two /** Full rank but for the level position. */: c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1);
written_out!(Three /** One redundant row. */:
    c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1, c2 f2 h2 at2 m2 e2 i2);
written_out!(Four /** Two redundant rows. */:
    c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1, c2 f2 h2 at2 m2 e2 i2, c3 f3 h3 at3 m3 e3 i3);
written_out!(Five /** Three redundant rows. */:
    c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1, c2 f2 h2 at2 m2 e2 i2, c3 f3 h3 at3 m3 e3 i3, c4 f4 h4 at4 m4 e4 i4);
written_out!(Six /** Four redundant rows. */:
    c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1, c2 f2 h2 at2 m2 e2 i2, c3 f3 h3 at3 m3 e3 i3, c4 f4 h4 at4 m4 e4 i4,
    c5 f5 h5 at5 m5 e5 i5);
written_out!(Seven /** Five redundant rows. */:
    c0 f0 h0 at0 m0 e0 i0, c1 f1 h1 at1 m1 e1 i1, c2 f2 h2 at2 m2 e2 i2, c3 f3 h3 at3 m3 e3 i3, c4 f4 h4 at4 m4 e4 i4,
    c5 f5 h5 at5 m5 e5 i5, c6 f6 h6 at6 m6 e6 i6);

model! {
    /// The same with a count: the sparse solver, and no elimination.
    pub model Counted {
        count n = 3;
        param l: m = 1.0;
        param slope = 0.0;
        param m_coupler: kg = 10.0;
        param i_coupler: kg*m^2 = 0.7;
        param behind: m = 0.0;
        /// from the first foot to the second
        param first: m = 1.0;
        /// by how much each further distance is longer
        param more: m = 0.0;
        param m: kg = 1.0;
        param centre: m = 0.5;
        param inertia: kg*m^2 = 0.1;
        body coupler { mass: m_coupler, inertia: i_coupler }
        body c[n] { mass: m, inertia: inertia }
        for i in 0..n {
            hinge foot[i]: ground(i*first + i*(i - 1)/2*more, slope*(i*first + i*(i - 1)/2*more)) ~ c[i](-centre, 0);
            hinge head[i]: c[i](l - centre, 0)
                ~ coupler(i*first + i*(i - 1)/2*more - behind, slope*(i*first + i*(i - 1)/2*more));
        }
        gravity (0, -9.81);
        start parallel { coupler angle 0 rate 0; at rest; }
        scene swing { start parallel; until 4 s; }
    }
}

/// Gravity of the models, m/s².
pub const GRAVITY: f64 = 9.81;

impl Cranks {
    /// The scene with these numbers.
    ///
    /// # Panics
    /// With fewer than two cranks or more than seven.
    pub fn scene(&self) -> Box<dyn Scene> {
        let mut scene: Box<dyn Scene> = match (self.counted, self.cranks.len()) {
            (true, n) => Box::new(counted::Swing { n, ..Default::default() }),
            (_, 2) => Box::new(two::Swing::default()),
            (_, 3) => Box::new(three::Swing::default()),
            (_, 4) => Box::new(four::Swing::default()),
            (_, 5) => Box::new(five::Swing::default()),
            (_, 6) => Box::new(six::Swing::default()),
            (_, 7) => Box::new(seven::Swing::default()),
            (_, n) => panic!("no scene with {n} cranks"),
        };
        set(
            &mut *scene,
            &[
                ("l", self.length_m),
                ("slope", self.slope),
                ("m_coupler", self.coupler_kg),
                ("i_coupler", self.coupler_kg_m2),
                ("behind", self.behind_m),
            ],
        );
        if self.counted {
            self.set_alike(&mut *scene);
        } else {
            self.set_each(&mut *scene);
        }
        scene
    }

    fn set_each(&self, scene: &mut dyn Scene) {
        for (k, crank) in self.cranks.iter().enumerate() {
            let Crank { at_m, mass_kg, centre_m, inertia_kg_m2 } = *crank;
            let values = [("at", at_m), ("m", mass_kg), ("e", centre_m), ("i", inertia_kg_m2)];
            values.iter().for_each(|(name, value)| set(scene, &[(&format!("{name}{k}"), *value)]));
        }
    }

    fn set_alike(&self, scene: &mut dyn Scene) {
        let Crank { mass_kg, centre_m, inertia_kg_m2, .. } = self.cranks[0];
        let gap = |k: usize| self.cranks.get(k + 1).map_or(0.0, |next| next.at_m - self.cranks[k].at_m);
        let more = if self.cranks.len() > 2 { gap(1) - gap(0) } else { 0.0 };
        set(
            scene,
            &[("m", mass_kg), ("centre", centre_m), ("inertia", inertia_kg_m2), ("first", gap(0)), ("more", more)],
        );
    }

    /// Number of cranks.
    pub fn n(&self) -> usize {
        self.cranks.len()
    }

    /// Name of body k in the scene.
    pub fn name(&self, k: usize) -> String {
        if self.counted { format!("c[{k}]") } else { format!("c{k}") }
    }

    /// Rows that repeat others for good: 4 n rows, 3 (n + 1) coordinates, one degree of freedom.
    pub fn n_redundant(&self) -> usize {
        4 * self.n() - (3 * (self.n() + 1) - 1)
    }
}
