//! The machine on which times are measured.

/// Processor, target and kind of build.
pub(super) fn machine() -> String {
    let build = if cfg!(debug_assertions) { "debug build, whose times mean nothing" } else { "release build" };
    let target = format!("{} {}", std::env::consts::ARCH, std::env::consts::OS);
    let wide = if cfg!(target_feature = "avx2") { " with AVX2" } else { "" };
    let processor = processor().map(|name| format!("{name}, ")).unwrap_or_default();
    format!("{processor}{target}{wide}, {build}, one core")
}

/// The processor's name, where the system tells it in a file.
fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
