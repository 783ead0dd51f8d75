//! What accuracy costs, as JSON.

use crate::accuracy::{Advice, Candidate, Comparison, Errors, Point, PointResult, Size, WorkPrecision, setting};

use super::json::Json;

/// The measurement as one object.
pub(super) fn accuracy_json(measured: &WorkPrecision) -> Json {
    let reference = &measured.reference;
    let second = match &reference.second {
        Ok(second) => Json::object([
            ("by", Json::text(&second.by)),
            ("difference", comparison(&second.difference)),
            ("own_difference", comparison(&second.own)),
        ]),
        Err(why) => Json::object([("missing", Json::text(why))]),
    };
    Json::object([
        ("model", Json::text(measured.info.model)),
        ("scene", Json::text(measured.info.name)),
        ("until", Json::Number(measured.until_s)),
        ("until_asked", Json::Number(measured.asked_until_s)),
        ("machine", Json::text(&measured.machine)),
        (
            "reference",
            Json::object([
                ("by", Json::text(&reference.by)),
                ("uncertainty", comparison(&reference.uncertainty)),
                ("second", second),
            ]),
        ),
        ("advice", Json::list(measured.advice().iter().map(advice))),
        ("points", Json::list(measured.points.iter().map(point))),
    ])
}

fn advice(advice: &Advice) -> Json {
    Json::object([
        ("target", Json::Number(advice.target)),
        ("use", advice.best.as_ref().map_or(Json::Null, candidate)),
        ("others", Json::list(advice.others.iter().map(candidate))),
        ("sentence", Json::text(advice.to_string())),
    ])
}

fn candidate(candidate: &Candidate) -> Json {
    Json::object([
        ("method", Json::text(candidate.method.name())),
        ("setting", Json::Number(setting(candidate.method))),
        ("error", Json::Number(candidate.error)),
        ("seconds", Json::Number(candidate.seconds)),
    ])
}

fn point(point: &Point) -> Json {
    let mut members = vec![
        ("method", Json::text(point.method.name())),
        ("setting", Json::Number(setting(point.method))),
        ("projection", Json::text(point.variant.name())),
    ];
    match &point.result {
        PointResult::NotRun => members.push(("outcome", Json::text("not run"))),
        PointResult::Stopped(reason) => members.push(("outcome", Json::text(reason))),
        PointResult::Measured(m) => members.extend([
            ("outcome", Json::text("measured")),
            ("error", comparison(&m.error)),
            (
                "residual",
                Json::object([
                    ("position", Json::Number(m.position_residual)),
                    ("velocity", Json::Number(m.velocity_residual)),
                ]),
            ),
            ("energy_balance", Json::Number(m.energy_balance)),
            (
                "cost",
                Json::object([
                    ("steps", Json::Count(m.cost.steps)),
                    ("rejected", Json::Count(m.cost.rejected)),
                    ("evaluations", Json::Count(m.cost.evaluations)),
                    ("factorizations", Json::Count(m.cost.factorizations)),
                    ("seconds_min", Json::Number(m.seconds_min)),
                    ("seconds_median", Json::Number(m.seconds_median)),
                    ("runs", Json::Count(m.n_timed as u64)),
                    ("seconds_on_grid", Json::Number(m.seconds_on_grid)),
                ]),
            ),
        ]),
    }
    Json::object(members)
}

fn comparison(comparison: &Comparison) -> Json {
    Json::object([("end", errors(&comparison.end)), ("largest", errors(&comparison.grid))])
}

fn errors(errors: &Errors) -> Json {
    let size =
        |size: &Size| Json::object([("absolute", Json::Number(size.absolute)), ("scaled", Json::Number(size.scaled))]);
    Json::object([
        ("position", size(&errors.position)),
        ("velocity", size(&errors.velocity)),
        ("reaction", size(&errors.reaction)),
    ])
}
