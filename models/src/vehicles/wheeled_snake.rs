//! The wheeled snake: ten links in a row, each on a wheel at its middle, bent by a wave that travels from head to tail.
//!
//! ```text
//!  (link10)─o─(link9)─o─ … ─o─(link2)─o─(link1) →        drawn straight, joint1 behind the head
//! ```
//!
//! Coordinates: x, y, φ of `link1` (the head) … `link10`; rows: `joint1` … `joint9` with two components each; on wheels:
//! `wheel1` … `wheel10`; with the wave prescribed: `bend1` … `bend9`.
//! Degrees of freedom: 12 at position level; 2 at velocity level on wheels, 3 with the wave prescribed.
//! With the wave prescribed and nothing to push against, linear and angular momentum stay zero.
//! Source: Hirose, "Biologically Inspired Robots" (1993), the active cord mechanism and its serpenoid wave; Liljebäck,
//! Pettersen, Stavdahl, Gravdahl, "Snake Robots" (2013), for the viscous friction. The numbers are our own.
//!
#![doc = include_str!("../../sketches/wheeledsnake.html")]

use ezy_core::model;

model! {
    /// Ten links on wheels that move by bending in a wave.
    pub model WheeledSnake {
        /// length of a link
        param l: m = 0.14;
        /// mass of a link
        param m: kg = 1.0;
        /// moment of inertia of a link
        param i: kg*m^2 = 0.0016;
        /// amplitude of the wave
        param amplitude: rad = 0.5;
        /// angular frequency of the wave
        param omega: rad/s = 2.0;
        /// phase from joint to joint
        param beta: rad = 0.7;

        body link1 { mass: m, inertia: i }
        body link2 { mass: m, inertia: i }
        body link3 { mass: m, inertia: i }
        body link4 { mass: m, inertia: i }
        body link5 { mass: m, inertia: i }
        body link6 { mass: m, inertia: i }
        body link7 { mass: m, inertia: i }
        body link8 { mass: m, inertia: i }
        body link9 { mass: m, inertia: i }
        body link10 { mass: m, inertia: i }

        hinge joint1: link1(-l/2, 0) ~ link2(l/2, 0);
        hinge joint2: link2(-l/2, 0) ~ link3(l/2, 0);
        hinge joint3: link3(-l/2, 0) ~ link4(l/2, 0);
        hinge joint4: link4(-l/2, 0) ~ link5(l/2, 0);
        hinge joint5: link5(-l/2, 0) ~ link6(l/2, 0);
        hinge joint6: link6(-l/2, 0) ~ link7(l/2, 0);
        hinge joint7: link7(-l/2, 0) ~ link8(l/2, 0);
        hinge joint8: link8(-l/2, 0) ~ link9(l/2, 0);
        hinge joint9: link9(-l/2, 0) ~ link10(l/2, 0);

        /// Wheels that do not slip sideways.
        effect wheels {
            skate wheel1: at link1(0, 0) along link1(1, 0);
            skate wheel2: at link2(0, 0) along link2(1, 0);
            skate wheel3: at link3(0, 0) along link3(1, 0);
            skate wheel4: at link4(0, 0) along link4(1, 0);
            skate wheel5: at link5(0, 0) along link5(1, 0);
            skate wheel6: at link6(0, 0) along link6(1, 0);
            skate wheel7: at link7(0, 0) along link7(1, 0);
            skate wheel8: at link8(0, 0) along link8(1, 0);
            skate wheel9: at link9(0, 0) along link9(1, 0);
            skate wheel10: at link10(0, 0) along link10(1, 0);
        }

        /// The angles of the joints are prescribed.
        effect wave {
            drive bend1: joint1.angle = amplitude*sin(omega*t);
            drive bend2: joint2.angle = amplitude*sin(omega*t - beta);
            drive bend3: joint3.angle = amplitude*sin(omega*t - 2*beta);
            drive bend4: joint4.angle = amplitude*sin(omega*t - 3*beta);
            drive bend5: joint5.angle = amplitude*sin(omega*t - 4*beta);
            drive bend6: joint6.angle = amplitude*sin(omega*t - 5*beta);
            drive bend7: joint7.angle = amplitude*sin(omega*t - 6*beta);
            drive bend8: joint8.angle = amplitude*sin(omega*t - 7*beta);
            drive bend9: joint9.angle = amplitude*sin(omega*t - 8*beta);
        }

        /// Springs with dampers whose rest follows the wave.
        effect muscles {
            /// stiffness
            param k: N*m = 2.0;
            /// damping
            param c: N*m*s = 0.05;
            torsion link1 ~ link2: stiffness k, angle amplitude*sin(omega*t), damping c;
            torsion link2 ~ link3: stiffness k, angle amplitude*sin(omega*t - beta), damping c;
            torsion link3 ~ link4: stiffness k, angle amplitude*sin(omega*t - 2*beta), damping c;
            torsion link4 ~ link5: stiffness k, angle amplitude*sin(omega*t - 3*beta), damping c;
            torsion link5 ~ link6: stiffness k, angle amplitude*sin(omega*t - 4*beta), damping c;
            torsion link6 ~ link7: stiffness k, angle amplitude*sin(omega*t - 5*beta), damping c;
            torsion link7 ~ link8: stiffness k, angle amplitude*sin(omega*t - 6*beta), damping c;
            torsion link8 ~ link9: stiffness k, angle amplitude*sin(omega*t - 7*beta), damping c;
            torsion link9 ~ link10: stiffness k, angle amplitude*sin(omega*t - 8*beta), damping c;
        }

        /// Wheels with viscous friction, small along and large across the link.
        effect viscous_ground {
            /// friction along the link
            param along: N*s/m = 0.5;
            /// friction across the link
            param across: N*s/m = 10.0;
            force at link1(0, 0) along link1(1, 0): -along * (link1.vx*cos(link1.phi) + link1.vy*sin(link1.phi));
            force at link1(0, 0) across link1(1, 0): -across * (link1.vy*cos(link1.phi) - link1.vx*sin(link1.phi));
            force at link2(0, 0) along link2(1, 0): -along * (link2.vx*cos(link2.phi) + link2.vy*sin(link2.phi));
            force at link2(0, 0) across link2(1, 0): -across * (link2.vy*cos(link2.phi) - link2.vx*sin(link2.phi));
            force at link3(0, 0) along link3(1, 0): -along * (link3.vx*cos(link3.phi) + link3.vy*sin(link3.phi));
            force at link3(0, 0) across link3(1, 0): -across * (link3.vy*cos(link3.phi) - link3.vx*sin(link3.phi));
            force at link4(0, 0) along link4(1, 0): -along * (link4.vx*cos(link4.phi) + link4.vy*sin(link4.phi));
            force at link4(0, 0) across link4(1, 0): -across * (link4.vy*cos(link4.phi) - link4.vx*sin(link4.phi));
            force at link5(0, 0) along link5(1, 0): -along * (link5.vx*cos(link5.phi) + link5.vy*sin(link5.phi));
            force at link5(0, 0) across link5(1, 0): -across * (link5.vy*cos(link5.phi) - link5.vx*sin(link5.phi));
            force at link6(0, 0) along link6(1, 0): -along * (link6.vx*cos(link6.phi) + link6.vy*sin(link6.phi));
            force at link6(0, 0) across link6(1, 0): -across * (link6.vy*cos(link6.phi) - link6.vx*sin(link6.phi));
            force at link7(0, 0) along link7(1, 0): -along * (link7.vx*cos(link7.phi) + link7.vy*sin(link7.phi));
            force at link7(0, 0) across link7(1, 0): -across * (link7.vy*cos(link7.phi) - link7.vx*sin(link7.phi));
            force at link8(0, 0) along link8(1, 0): -along * (link8.vx*cos(link8.phi) + link8.vy*sin(link8.phi));
            force at link8(0, 0) across link8(1, 0): -across * (link8.vy*cos(link8.phi) - link8.vx*sin(link8.phi));
            force at link9(0, 0) along link9(1, 0): -along * (link9.vx*cos(link9.phi) + link9.vy*sin(link9.phi));
            force at link9(0, 0) across link9(1, 0): -across * (link9.vy*cos(link9.phi) - link9.vx*sin(link9.phi));
            force at link10(0, 0) along link10(1, 0): -along * (link10.vx*cos(link10.phi) + link10.vy*sin(link10.phi));
            force at link10(0, 0) across link10(1, 0): -across * (link10.vy*cos(link10.phi) - link10.vx*sin(link10.phi));
        }

        start placed { link1 at (0, 0) angle 0; }
        start bent {
            link1 at (0, 0) angle 0;
            link2 angle 0;
            link3 angle -amplitude * sin(beta);
            link4 angle -amplitude * (sin(beta) + sin(2*beta));
            link5 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta));
            link6 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta) + sin(4*beta));
            link7 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta) + sin(4*beta) + sin(5*beta));
            link8 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta) + sin(4*beta) + sin(5*beta) + sin(6*beta));
            link9 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta) + sin(4*beta) + sin(5*beta) + sin(6*beta) + sin(7*beta));
            link10 angle -amplitude * (sin(beta) + sin(2*beta) + sin(3*beta) + sin(4*beta) + sin(5*beta) + sin(6*beta) + sin(7*beta) + sin(8*beta));
            at rest;
        }

        /// On wheels, bent by muscles.
        scene slithering { start bent; until 10 s; with wheels, muscles; }
        /// The wave prescribed, on viscous ground.
        scene crawling { start placed; until 10 s; with wave, viscous_ground; }
        /// The wave prescribed, with nothing to push against.
        scene floating { start placed; until 10 s; with wave; }
    }
}
