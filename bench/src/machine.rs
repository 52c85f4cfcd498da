//! Description of the machine of the measurements.

use std::fs;
use std::process::Command;

/// Header lines of every table.
pub(crate) fn describe() -> Vec<String> {
    vec![
        format!("date: {}", says("date", &["+%F"])),
        format!("processor: {}", processor()),
        format!("Rust: {}, release, {}", says("rustc", &["--version"]), wide()),
    ]
}

/// First line of the output of a program, or a note that it is missing.
pub(crate) fn says(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    text.ok()
        .and_then(|text| text.lines().next().map(str::to_owned))
        .unwrap_or_else(|| format!("no {program}"))
}

/// Version of a crate in the lock file of this program.
pub(crate) fn locked(name: &str) -> &'static str {
    let lock = include_str!("../Cargo.lock");
    let entry = lock
        .split("[[package]]")
        .find(|entry| entry.contains(&format!("name = \"{name}\"\n")));
    let version = entry.and_then(|entry| entry.split("version = \"").nth(1)?.split('"').next());
    version.unwrap_or("of no known version")
}

fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = info.lines().find(|line| line.starts_with(name))?;
        line.split_once(':').map(|(_, value)| value.trim().to_owned())
    };
    let family = field("cpu family").map_or(String::new(), |family| format!(", family {family}"));
    let name = field("model name").unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{name}{family}, {cores} cores in sight")
}

/// Widest instruction set that this program was compiled for.
fn wide() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "for this processor (AVX-512)"
    } else if cfg!(target_feature = "avx2") {
        "for this processor (AVX2)"
    } else {
        "for every processor of this kind"
    }
}
