//! The arm of the guide's chapter on inverse dynamics, with the command line of a crate that `ezy new led_arm` wrote. Its numbers are our own.

use ezy_core::model;
use std::process::ExitCode;

model! {
    /// Two links that carry a tool, with a motor at the shoulder and one at the elbow.
    pub model LedArm {
        /// length and mass of the upper arm
        param l1: m = 0.5; param m1: kg = 3;
        /// length and mass of the forearm
        param l2: m = 0.4; param m2: kg = 2;
        /// mass of the tool
        param m_tool: kg = 1;
        /// damping of the elbow
        param c: N*m*s = 0.5;
        /// gravity, downwards
        param g: m/s^2 = 9.81;
        /// torques of the motors
        input shoulder: N*m = 0; input elbow: N*m = 0;

        body upper { mass: m1, inertia: m1*l1^2/12 }
        body fore { mass: m2, inertia: m2*l2^2/12 }
        body tool { mass: m_tool, inertia: 1e-3 }
        hinge S: ground(0, 0) ~ upper(-l1/2, 0);
        hinge E: upper(l1/2, 0) ~ fore(-l2/2, 0);
        weld W: fore(l2/2, 0) ~ tool(0, 0) angle 0;
        torque upper: shoulder;
        torque fore ~ upper: elbow;
        torsion upper ~ fore: stiffness 0, angle 0, damping c;
        gravity (0, -g);

        /// The tool goes once round a circle, from rest to rest.
        effect path {
            /// radius of the circle
            param r: m = 0.15;
            /// how long it takes
            param period: s = 1;
            drive across: tool.x = l1 - r + r*cos(2*pi*t/period - sin(2*pi*t/period));
            drive up: tool.y = l2 + r*sin(2*pi*t/period - sin(2*pi*t/period));
        }

        start bent { upper angle 0; fore angle pi/2; at rest; }
        /// The tool is led along the circle, whatever it takes.
        scene led { start bent; until 1 s; with path; }
        /// The motors alone move it.
        scene moved { start bent; until 1 s; }
    }
}

fn main() -> ExitCode {
    ezy_cli::main(&[&led_arm::MODEL])
}
