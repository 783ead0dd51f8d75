//! The model of each word in `docs/language.md`, with a command line that draws them.
//!
//! `cargo run --example words -- sketch hinge/swing`

mod constraints;
mod forces;
mod items;
mod scenes;

use std::process::ExitCode;

fn main() -> ExitCode {
    ezy_cli::main(&[
        &items::param::MODEL,
        &items::named::MODEL,
        &items::count::MODEL,
        &items::input::MODEL,
        &items::state::MODEL,
        &items::output::MODEL,
        &items::body::MODEL,
        &items::point::MODEL,
        &items::repeated::MODEL,
        &constraints::hinge::MODEL,
        &constraints::weld::MODEL,
        &constraints::slider::MODEL,
        &constraints::slot::MODEL,
        &constraints::rod::MODEL,
        &constraints::gear::MODEL,
        &constraints::drive::MODEL,
        &constraints::constraint::MODEL,
        &constraints::skate::MODEL,
        &constraints::roll::MODEL,
        &constraints::velocity_constraint::MODEL,
        &forces::gravity::MODEL,
        &forces::force::MODEL,
        &forces::torque::MODEL,
        &forces::spring::MODEL,
        &forces::damper::MODEL,
        &forces::torsion::MODEL,
        &forces::drag::MODEL,
        &forces::friction::MODEL,
        &forces::tyre::MODEL,
        &scenes::effect::MODEL,
        &scenes::release::MODEL,
        &scenes::start::MODEL,
        &scenes::scene::MODEL,
        &scenes::event::MODEL,
        &scenes::stop::MODEL,
    ])
}
