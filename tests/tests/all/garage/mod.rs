//! Every model of the garage against a reference or a closed form, one model a file.

mod andrews;
mod chain;
mod chaplygin_sleigh;
mod differential_robot;
mod double_pendulum;
mod four_bar;
mod hanging_net;
mod knife_edge;
mod n_four_bar;
mod pendulum;
mod road_train;
mod roller_racer;
mod single_track_car;
mod skateboard;
mod slider_crank;
mod snakeboard;
mod tractor_trailers;
mod wheeled_snake;
