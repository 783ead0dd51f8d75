//! Derivatives of measured columns by the equations of the derivatives.

use super::Measured;
use crate::integrate::Method;
use crate::model::{Equations, Scene, Start};
use crate::record::find_name;
use crate::scalar::Dual;
use crate::simulate::{Sensitivities, SetupError};

/// Derivatives of the measured values by `N` parameters and given start values, for [`Fit::derivatives`](super::Fit::derivatives): one
/// column for each name. They have the error of the run, where differences lose a third of the digits.
///
/// Scenes and methods are those of [`Sensitivities`], the columns coordinates and velocities. Start values stay as they are when
/// a parameter changes: take differences where the start depends on a free parameter.
///
/// # Errors
/// [`SetupError`] when scene, start, names or method cannot be used, or a column is no coordinate or velocity.
pub fn sensitivities_at<S, const N: usize>(
    scene: &S,
    start: &Start,
    by: [&str; N],
    method: Method,
    data: &Measured,
) -> Result<Vec<Vec<f64>>, SetupError>
where
    S: Scene + Equations<Dual<N>>,
{
    let info = scene.info();
    let places = data.names().map(|name| {
        find_name("coordinate or velocity", name, info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name))
    });
    let places: Vec<usize> = places.collect::<Result<_, _>>()?;
    let mut order: Vec<usize> = (0..data.times().len()).collect();
    order.sort_by(|a, b| data.times()[*a].total_cmp(&data.times()[*b]));
    let mut run = Sensitivities::new(scene, start, by, method)?;
    // by time, column, name
    let mut all = vec![vec![[0.0; N]; places.len()]; order.len()];
    for i in order {
        run.advance(data.times()[i])?;
        let tangents = run.tangents();
        for (of_column, &place) in all[i].iter_mut().zip(&places) {
            *of_column = std::array::from_fn(|k| {
                let n_q = tangents[k].q.len();
                if place < n_q { tangents[k].q[place] } else { tangents[k].v[place - n_q] }
            });
        }
    }
    let of_name = |k: usize| {
        let of_column = |c: usize| {
            let all = &all;
            let measured = data.columns[c].values.iter().enumerate().filter(|(_, value)| !value.is_nan());
            measured.map(move |(i, _)| all[i][c][k])
        };
        (0..places.len()).flat_map(of_column).collect()
    };
    Ok((0..N).map(of_name).collect())
}
