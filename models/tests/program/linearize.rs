//! The command `linearize` on scenes of the crate, against closed forms.

use crate::run::{assert_wrong_use, directory, ezy, text};
use crate::{json, output};
use std::fs;

/// Of eigenvalues, as a share of themselves.
const EIGENVALUES: f64 = 1e-10;
/// Of critical values.
const CRITICAL: f64 = 1e-10;
/// Of values of a transfer function: what eigenvalues have, in a product of some of them.
const RESPONSE: f64 = 1e-9;
/// Of a gain by two steady motions with ±1e-3 N m: the third order of the steering leaves 5e-8 of it.
const BY_DIFFERENCES: f64 = 1e-7;
/// Decimals of 4 digits in a page.
const OF_A_PAGE: f64 = 1e-4;

/// ±i √(g/l) about the lower position.
#[test]
fn analytic_pendulum_swings_about_rest() {
    let hanging = json(&["linearize", "pendulum/swing", "--start", "bob.phi=-1.4", "--json"]);
    assert_eq!((hanging["steady"]["kind"].as_str(), hanging["verdict"].as_str()), (Some("rest"), Some("neutral")));
    let angle = hanging["steady"]["state"]["bob.phi"].as_f64().unwrap();
    assert!((angle + std::f64::consts::FRAC_PI_2).abs() <= 1e-12, "{angle}");
    let omega = hanging["eigenvalues"][0]["imaginary"].as_f64().unwrap();
    assert!((omega / 9.81f64.sqrt() - 1.0).abs() <= EIGENVALUES, "{omega}");
    let told = output(&["linearize", "pendulum/swing", "--start", "bob.phi=1.4"]);
    for part in ["Pendulum/swing: steady at rest", "unstable: 1 eigenvalue", "no eigenvalue is zero", "bob.phi"] {
        assert!(told.contains(part), "{part} in {told}");
    }
}

/// An oversteering car diverges above u = √(cf cr L² / (m (lf cf − lr cr))).
#[test]
fn analytic_car_has_its_critical_speed() {
    let (m, lf, lr, cf, cr) = (1500.0, 1.6, 1.1, 1e5, 8e4);
    let exact = f64::sqrt(cf * cr * (lf + lr) * (lf + lr) / (m * (lf * cf - lr * cr)));
    let folder = directory("linearize_vary");
    let [table, figure] = ["locus.csv", "locus.svg"].map(|name| folder.join(name).display().to_string());
    let vary = "linearize singletrackcar/cornering --set delta=0 --set lf=1.6 --set lr=1.1 --set cf=1e5 --set cr=8e4 \
                --vary u=10:60:10 --json";
    let arguments = vary.split(' ').chain(["--out", &table, "--plot", &figure]);
    let locus = json(&arguments.collect::<Vec<_>>());
    let [critical] = &locus["critical"].as_array().unwrap()[..] else { panic!("{locus}") };
    let value = critical["value"].as_f64().unwrap();
    assert!((value / exact - 1.0).abs() <= CRITICAL, "{value} for {exact}");
    assert_eq!((critical["kind"].as_str(), critical["unstable_above"].as_u64()), (Some("divergence"), Some(1)));
    let rows = fs::read_to_string(table).unwrap();
    assert!(rows.starts_with("u [m/s],real [1/s],imaginary [1/s]\n10,"), "{rows}");
    let n_eigenvalues: usize =
        locus["points"].as_array().unwrap().iter().map(|point| point["eigenvalues"].as_array().unwrap().len()).sum();
    assert_eq!(rows.lines().count(), 1 + n_eigenvalues);
    assert!(fs::read_to_string(figure).unwrap().contains("real part [1/s]"));
}

/// A pair of eigenvalues ±i times the turn rate is that of circles about other centres: no doubt about the stability of the circle.
#[test]
fn invariant_circle_is_stable_besides_its_centre() {
    let scene = "singletrackcar/cornering";
    let circle = json(&["linearize", scene, "--json"]);
    assert_eq!((circle["steady"]["kind"].as_str(), circle["verdict"].as_str()), (Some("circle"), Some("stable")));
    let turn_rate = circle["steady"]["turn_rate"].as_f64().unwrap();
    let of_centre = circle["eigenvalues"][0]["imaginary"].as_f64().unwrap();
    assert!((of_centre / turn_rate - 1.0).abs() <= EIGENVALUES, "{of_centre} for {turn_rate}");
    assert!(output(&["linearize", scene]).contains("circles about other centres"));
    let examples = output(&["linearize", "--help"]);
    let example = examples.lines().find_map(|line| line.trim().strip_prefix("ezy linearize")).expect("an example");
    let words = example.split("   ").next().unwrap_or_default().split_whitespace();
    output(&["linearize"].into_iter().chain(words).collect::<Vec<_>>());
}

/// The straight EzyRoller in the hands of its rider.
const RIDDEN: [&str; 4] = ["linearize", "ezyroller/ridden", "--start", "bar.phi=0"];

fn ridden(more: &[&'static str]) -> Vec<&'static str> {
    [&RIDDEN, more].concat()
}

/// k/((s − p)(s − q)) with the eigenvalues p and q of the scene; its static gain is that of two circles; the speed does not respond.
#[test]
fn cross_response_is_that_of_eigenvalues_and_of_steady_circles() {
    let linear = json(&ridden(&["--json"]));
    let eigenvalues = linear["eigenvalues"].as_array().unwrap().iter().map(|s| s["real"].as_f64().unwrap());
    let [p, q] = eigenvalues.collect::<Vec<_>>()[..] else { panic!("{linear}") };
    let found = json(&ridden(&["--response", "torque:steering,torque:speed", "--json"]));
    let [steering, speed] = &found["responses"].as_array().unwrap()[..] else { panic!("{found}") };
    let number = |name: &str| steering[name].as_f64().unwrap();
    let (k, gain) = (number("gain"), number("static_gain"));
    assert_eq!((steering["relative_degree"].as_u64(), steering["not_seen"].as_u64()), (Some(2), Some(4)));
    assert_eq!((steering["unit"].as_str(), speed["gain"].as_f64()), (Some("deg per N*m"), Some(0.0)));
    assert!((gain * p * q / k - 1.0).abs() <= RESPONSE, "{gain} for {k}/({p} {q})");
    let angle = |torque: &'static str| {
        let circle = json(&ridden(&["--input", torque, "--json"]));
        assert_eq!(circle["steady"]["kind"].as_str(), Some("circle"));
        let [bar, seat] = ["bar.phi", "seat.phi"].map(|name| circle["steady"]["state"][name].as_f64().unwrap());
        (bar - seat).to_degrees()
    };
    let by_circles = (angle("torque=1e-3") - angle("torque=-1e-3")) / 2e-3;
    assert!((gain / by_circles - 1.0).abs() <= BY_DIFFERENCES, "{gain} for {by_circles}");

    let folder = directory("linearize_response");
    let [table, figure] = ["bode.csv", "bode.svg"].map(|name| folder.join(name).display().to_string());
    let files = ["--response", "torque:steering", "--frequencies", "1e-3:1e3", "--out", &table, "--plot", &figure];
    let told = output(&[&RIDDEN, &files[..]].concat());
    for part in ["torque → steering: 2 poles, 0 zeros", "(the response does not settle", "the loop is unstable", &table]
    {
        assert!(told.contains(part), "{part} in {told}");
    }
    let rows = fs::read_to_string(table).unwrap();
    let (head, rows) = rows.split_once('\n').expect("a head");
    assert_eq!(head, "input,output,frequency [rad/s],magnitude,unit,magnitude [dB],phase [deg]");
    for row in rows.lines() {
        let cells: Vec<&str> = row.split(',').collect();
        assert_eq!((cells[0], cells[1], cells[4]), ("torque", "steering", "deg per N*m"));
        let [omega, magnitude, decibels, phase] = [2, 3, 5, 6].map(|i| cells[i].parse::<f64>().unwrap());
        let exact = k.abs() / omega.hypot(p) / omega.hypot(q);
        assert!((magnitude / exact - 1.0).abs() <= RESPONSE, "{magnitude} for {exact}");
        assert!((decibels - 20.0 * exact.log10()).abs() <= RESPONSE * decibels.abs().max(1.0), "{decibels}");
        // half a turn at first, since one pole is on the other side
        let turned = 180.0 + (omega / p).atan().to_degrees() + (omega / q).atan().to_degrees();
        assert!((phase - turned).abs() <= RESPONSE * 180.0, "{phase} for {turned} at {omega}");
    }
    assert!(fs::read_to_string(figure).unwrap().contains("phase [deg]"));
}

#[test]
fn invariant_responses_that_are_none_say_why() {
    let wrong = |more: &[&'static str], message: &str| assert_wrong_use(&ridden(more), message);
    wrong(&["--response", "torqe:steering"], "did you mean `torque`?");
    wrong(&["--response", "torque:sped"], "did you mean `speed`?");
    wrong(&["--response", "torque"], "write INPUT:OUTPUT");
    wrong(&["--response", "torque:speed", "--vary", "a=0.1:0.2:0.1"], "--response is that of one steady motion");
    wrong(&["--response", "torque:speed", "--frequencies", "1:10"], "--frequencies are those of files");
    assert_wrong_use(&["linearize", "pendulum/swing", "--response", "a:b"], "has no input; declare one");
}

/// A pendulum in its only mode: its angle is ± the amplitude over its length, over a period of 2π √(l/g), and it ends as it begins.
#[test]
fn analytic_pendulum_swings_in_its_mode() {
    let folder = directory("linearize_mode");
    let file = |name: &str| folder.join(name).display().to_string();
    let hanging =
        ["linearize", "pendulum/swing", "--start", "bob.phi=-1.4", "--set", "l=2", "--mode", "1", "--animate"];
    let (page, picture, gif) = (file("mode.html"), file("mode.svg"), file("mode.gif"));
    let told = output(&[&hanging, &[&*page, "--amplitude", "0.3"][..]].concat());
    assert!(told.contains("mode 1: 0.000000 ± 2.214723i 1/s") && told.contains("without growth or decay"), "{told}");
    assert!(told.contains("bob.x deviates by 0.3 m") && told.ends_with(&format!("The page: {page}\n")), "{told}");
    let content = fs::read_to_string(page).unwrap();
    assert!(content.contains("<p class=\"note\">mode 1:"));
    let (_, data) = content.split_once("<script type=\"application/json\" id=\"data\">").expect("data");
    let data: serde_json::Value = serde_json::from_str(data.split_once("</script>").expect("an end").0).unwrap();
    let list =
        |of: &serde_json::Value| -> Vec<f64> { of.as_array().unwrap().iter().filter_map(|x| x.as_f64()).collect() };
    let (times, pose) = (list(&data["t"]), [0, 2].map(|i| list(&data["poses"][0][i])));
    let period = std::f64::consts::TAU * (2.0_f64 / 9.81).sqrt();
    assert!((times[times.len() - 1] / period - 1.0).abs() <= EIGENVALUES && data["repeats"] == true);
    for (i, t) in times.iter().enumerate() {
        let x = 0.3 * (std::f64::consts::TAU * t / period).cos();
        let angle = 0.5 * x - std::f64::consts::FRAC_PI_2;
        assert!((pose[0][i] - x).abs() <= OF_A_PAGE && (pose[1][i] - angle).abs() <= OF_A_PAGE, "{t}");
    }
    // a tenth of the two metres, since that is less than 0.2 rad
    let found = json(&[&hanging, &[&*picture, "--json"][..]].concat());
    let animation = &found["animation"];
    assert!((animation["amplitude"].as_f64().unwrap() / 0.2 - 1.0).abs() <= EIGENVALUES, "{animation}");
    assert!((animation["period"].as_f64().unwrap() / period - 1.0).abs() <= EIGENVALUES, "{animation}");
    assert!(fs::read_to_string(picture).unwrap().contains("<title>Pendulum, scene swing, mode 1</title>"));
    output(&[&hanging, &[&*gif][..]].concat());
    assert!(fs::read(gif).unwrap().starts_with(b"GIF89a"));
}

/// A mode without oscillation goes out and back once, and the vehicle does not travel away.
#[test]
fn invariant_mode_is_seen_from_the_frame_of_the_motion() {
    let picture = directory("linearize_frame").join("mode.svg");
    let file = picture.to_str().expect("a name");
    let told = output(&[&RIDDEN, &["--mode", "1", "--animate", file][..]].concat());
    assert!(told.contains("without oscillation: out and back once"), "{told}");
    assert!(told.contains("frame of the steady motion, straight at 1 m/s"), "{told}");
    let svg = fs::read_to_string(&picture).unwrap();
    assert!(!svg.contains("@keyframes camera"));
    for keys in svg.split("@keyframes ").skip(1) {
        let at = |percent: &str| {
            let (_, key) = keys.split_once(&format!("{percent}%{{transform:")).expect("a key");
            key.split_once('}').expect("its end").0
        };
        let (first, middle, last) = (at(" 0"), at("}50"), at("}100"));
        assert!(first == last && first != middle, "{first}, {middle}, {last}");
    }
    let wrong = |more: &[&'static str], message: &str| assert_wrong_use(&ridden(more), message);
    wrong(&["--mode", "3", "--animate", "mode.svg"], "the table has 2 modes; give a number from 1 to 2");
    wrong(&["--mode", "0", "--animate", "mode.svg"], "the table has 2 modes");
    wrong(&["--mode", "1", "--animate", "mode.png"], "give --animate such a file");
    wrong(&["--mode", "1", "--animate", "mode.svg", "--amplitude", "0"], "above zero");
    wrong(&["--mode", "1"], "--animate");
    wrong(&["--mode", "1", "--animate", "mode.svg", "--vary", "a=0.1:0.2:0.1"], "cannot be used with");
}

#[test]
fn invariant_what_is_not_linearized_says_why() {
    assert_wrong_use(&["linearize", "ezyroller/coast", "--hold", "seat.fi"], "did you mean `seat.phi`?");
    assert_wrong_use(&["linearize", "pendulum/swing", "--hold", "bob.omega"], "cannot be held");
    assert_wrong_use(&["linearize", "ezyroller/coast", "--vary", "method=rk4"], "a linearization has no method");
    assert_wrong_use(&["linearize", "ezyroller/coast", "--out", "a.csv"], "--vary");
    // a torque that nothing balances
    let done = ezy(&["linearize", "ezyroller/driven"]);
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stdout));
    assert!(text(&done.stderr).contains("no steady motion was found near the start"), "{}", text(&done.stderr));
}
