//! The models of EZY, one a file, and the studies made with them.
//!
//! The page of a file, such as [`vehicles::ezy_roller`], has the sketch of its model, coordinates, rows and sources; the module within, such as
//! [`ezy_roller`], its scenes.

pub mod mechanisms;
pub mod new;
pub mod registry;
pub mod study;
pub mod vehicles;

pub use mechanisms::{
    andrews::andrews, chain::chain, double_pendulum::double_pendulum, four_bar::four_bar, hanging_net::hanging_net,
    n_four_bar::n_four_bar, pendulum::pendulum, slider_crank::slider_crank,
};
pub use vehicles::{
    chaplygin_sleigh::chaplygin_sleigh, differential_robot::differential_robot, ezy_roller::ezy_roller,
    knife_edge::knife_edge, road_train::road_train, roller_racer::roller_racer, single_track_car::single_track_car,
    skateboard::skateboard, snakeboard::snakeboard, tractor_trailers::tractor_trailers, wheeled_snake::wheeled_snake,
};
