//! How much memory the machine has left.

/// Up to this many bytes no machine is asked.
const SMALL: u64 = 100_000_000;

/// What the machine has left, bytes, where that is less than `needed`.
pub(crate) fn too_little_for(needed: u64) -> Option<u64> {
    if needed <= SMALL { None } else { less_than(needed, available()) }
}

/// `available`, where it is known and less than `needed`.
fn less_than(needed: u64, available: Option<u64>) -> Option<u64> {
    available.filter(|available| *available < needed)
}

/// Bytes that programs can still have, where the system tells it in a file.
fn available() -> Option<u64> {
    available_in(&std::fs::read_to_string("/proc/meminfo").ok()?)
}

fn available_in(meminfo: &str) -> Option<u64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib.saturating_mul(1024))
}

/// A number of bytes as it is read: `1.2 GB`, `34 MB`.
pub(crate) fn readable(bytes: u64) -> String {
    let bytes = bytes as f64;
    if bytes >= 1e9 { format!("{:.1} GB", bytes / 1e9) } else { format!("{:.0} MB", bytes / 1e6) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_available_memory_is_read_in_kibibytes() {
        let text = "MemTotal:       24737380 kB\nMemFree:         1000000 kB\nMemAvailable:   23000000 kB\n";
        assert_eq!(available_in(text), Some(23_552_000_000));
        assert_eq!(available_in("MemFree: 5 kB\n"), None);
        assert_eq!([1_150_000_000, 34_400_000].map(readable), ["1.1 GB", "34 MB"]);
    }

    #[test]
    fn analytic_need_is_compared_with_what_is_known() {
        assert_eq!(less_than(2_000, Some(1_000)), Some(1_000));
        assert_eq!([less_than(500, Some(1_000)), less_than(500, None)], [None; 2]);
        assert_eq!(too_little_for(SMALL), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn invariant_a_machine_has_some_megabytes() {
        let left = too_little_for(u64::MAX);
        assert!(left.is_some_and(|bytes| bytes > 1_000_000), "{left:?}");
    }
}
