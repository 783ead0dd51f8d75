//! Models that are hard on purpose: that they are what their references say, and what they reach.

mod blocks;
mod bounds;
mod naive;
mod symptoms;
