//! Every model of the garage against a reference or a closed form, related models in one file.

mod andrews;
mod chain;
mod chaplygin_sleigh;
mod differential_robot;
mod double_pendulum;
mod four_bar;
mod knife_edge;
mod n_four_bar;
mod pendulum;
mod roller_racer;
mod single_track_car;
mod slider_crank;
mod snakeboard;
mod tractor_trailers;
mod wheeled_snake;
