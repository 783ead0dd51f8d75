//! Every model of the garage against a reference or a closed form, one model a file.

mod chaplygin_sleigh;
mod double_pendulum;
mod four_bar;
mod knife_edge;
mod pendulum;
mod slider_crank;
