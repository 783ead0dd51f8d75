//! Vehicles, one model a file.

pub mod chaplygin_sleigh;
pub mod differential_robot;
pub mod ezy_roller;
pub mod knife_edge;
pub mod road_train;
pub mod roller_racer;
pub mod single_track_car;
pub mod skateboard;
pub mod snakeboard;
pub mod tractor_trailers;
pub mod wheeled_snake;
