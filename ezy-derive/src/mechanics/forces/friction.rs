//! `friction at P: force f, speed u`, the same `along d` with `tread w`, `friction a ~ b: torque m, rate w`: dry friction, smoothed.
//!
//! The law f v/√(v² + u²) goes through zero: it reaches 0.7 of f at the speed u and f far above it (Andersson, Söderberg,
//! Björklund, Tribology International 40 (2007) compare such laws). Its share v/√(v² + u²) of f tells steps where it turns around.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;
use crate::symbolic::SumId;

pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let (largest, knee) = (writer.setting(of, 0), writer.setting(of, 1));
    let Some(place) = of.places.first() else {
        let turned = writer.turned_by(of.bodies[0], of.bodies[1], None);
        let rate = writer.time_derivative(turned);
        let square = writer.algebra.mul(rate, rate);
        let root = smoothed(writer, square, knee);
        add_layer(writer, rate, root);
        let factor = factor(writer, largest, root);
        let torque = writer.algebra.mul(factor, rate);
        load.couple(writer, &of.bodies, torque);
        return;
    };
    let velocity = writer.velocity(place);
    if let Some(direction) = of.directions.first() {
        let along = writer.unit_direction(direction);
        let (speed, tread) = (writer.dot(velocity, along), writer.setting(of, 2));
        let slip = writer.algebra.sub(speed, tread);
        let square = writer.algebra.mul(slip, slip);
        let root = smoothed(writer, square, knee);
        add_layer(writer, slip, root);
        let factor = factor(writer, largest, root);
        let force = along.map(|x| {
            let velocity = writer.algebra.mul(slip, x);
            writer.algebra.mul(factor, velocity)
        });
        load.at(writer, place, force);
        let lengthwise = writer.algebra.mul(factor, slip);
        load.on_tread(writer, tread, lengthwise);
        return;
    }
    let square = writer.dot(velocity, velocity);
    let root = smoothed(writer, square, knee);
    velocity.into_iter().for_each(|component| add_layer(writer, component, root));
    let factor = factor(writer, largest, root);
    let force = velocity.map(|v| writer.algebra.mul(factor, v));
    load.at(writer, place, force);
}

/// √(v² + u²)
fn smoothed(writer: &mut Writer<'_>, square: SumId, knee: SumId) -> SumId {
    let knee_square = writer.algebra.mul(knee, knee);
    let sum = writer.algebra.add(square, knee_square);
    let sum = writer.at_least_something(sum);
    let half = writer.algebra.number(0.5);
    writer.algebra.pow(sum, half)
}

/// −f/√(v² + u²)
fn factor(writer: &mut Writer<'_>, largest: SumId, root: SumId) -> SumId {
    let ratio = writer.algebra.div(largest, root);
    writer.algebra.neg(ratio)
}

fn add_layer(writer: &mut Writer<'_>, velocity: SumId, root: SumId) {
    let share = writer.algebra.div(velocity, root);
    writer.layers.push(share);
}
