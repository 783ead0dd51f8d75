//! Laws without a derivative at a state, such as `norm(v)` at rest: for messages about runs that cannot be continued.

use super::MotionError;
use super::diagnosis::Diagnosis;
use crate::model::{Derived as _, Name, SceneInfo, SceneRef};

/// Functions of laws whose derivatives are not finite everywhere, as formulas print them.
const FUNCTIONS: [&str; 6] = ["sqrt(", "atan2(", "asin(", "acos(", "ln(", "pow("];

impl<P: SceneRef> Diagnosis<'_, P> {
    /// What to say when a motion cannot be continued from a state with accelerations `a` and multipliers `lambda`: where a force has no
    /// derivative, which one. A scene without Jacobians does not know.
    #[cold]
    pub(crate) fn without_derivative(
        &self,
        (t, q, v): (f64, &[f64], &[f64]),
        (a, lambda): (&[f64], &[f64]),
        cause: MotionError,
    ) -> MotionError {
        if !matches!(cause, MotionError::StepCollapsed { .. } | MotionError::NotFinite { .. }) {
            return cause;
        }
        let Some(places) = self.system.scene.jacobian_places() else { return cause };
        let [mut by_q, mut by_v] = [&places.by_q, &places.by_v].map(|places| vec![0.0; places.len()]);
        self.system.scene.jacobians(&self.system.fixed, t, q, v, a, lambda, &mut by_q, &mut by_v);
        let (coordinates, velocities) = (&self.system.info.coordinates, &self.system.info.velocities);
        let undefined = |places: &[(usize, usize)], entries: &[f64]| {
            let mut of_forces = places.iter().zip(entries).filter(|((row, _), _)| *row < velocities.len());
            of_forces.find(|(_, entry)| !entry.is_finite()).map(|(place, _)| *place)
        };
        let by_velocity = undefined(&places.by_v, &by_v).map(|(row, i)| (row, &velocities[i].name));
        let found = by_velocity.or(undefined(&places.by_q, &by_q).map(|(row, i)| (row, &coordinates[i].name)));
        let Some((row, by)) = found else { return cause };
        let (force_on, by, terms) = (coordinates[row].name.clone(), by.clone(), terms(&self.system.info, row, by));
        MotionError::NoDerivative { t, force_on, by, terms, cause: Box::new(cause) }
    }
}

/// The calls in the force on a coordinate, and in the values that it names, that may have no derivative by `by`. A scene with counts does not
/// print its forces as a whole.
fn terms(info: &SceneInfo, row: usize, by: &Name) -> Vec<String> {
    let Some(force) = info.force_entries.get(row) else { return Vec::new() };
    let named = info.abbreviations.iter().filter(|value| force.text.contains(value.symbol.text));
    let texts = std::iter::once(force.text).chain(named.map(|value| value.formula.text));
    let mut terms: Vec<String> = texts.flat_map(calls).filter(|call| call.contains(&**by)).map(str::to_owned).collect();
    terms.sort();
    terms.dedup();
    terms
}

/// `sqrt(x^2 + y^2)` of `3*sqrt(x^2 + y^2) + x`.
fn calls(text: &str) -> impl Iterator<Item = &str> {
    FUNCTIONS.iter().flat_map(move |function| {
        let begins = text.match_indices(function).map(|(at, _)| at);
        begins.filter(|at| !text[..*at].ends_with(char::is_alphanumeric)).map(move |at| {
            let mut open = 0;
            let end = text[at..].find(|sign| {
                open += i32::from(sign == '(') - i32::from(sign == ')');
                sign == ')' && open == 0
            });
            &text[at..end.map_or(text.len(), |end| at + end + 1)]
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_calls_are_found_to_their_closing_bracket() {
        let found = |text| calls(text).collect::<Vec<_>>();
        assert_eq!(found("3*sqrt((x + 1)^2 + y^2) + x*y"), ["sqrt((x + 1)^2 + y^2)"]);
        assert!(found("asin_of*vasin(x) + cos(y)").is_empty());
        assert_eq!(found("sqrt(a) - atan2(b, c)"), ["sqrt(a)", "atan2(b, c)"]);
    }
}
