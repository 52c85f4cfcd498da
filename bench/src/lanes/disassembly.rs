//! Check that all intrinsics are inlined in our code for lanes: any other would be a call for every operation.

use std::path::Path;
use std::process::Command;

/// Returns a line of confirmation; an error if `objdump` is missing, or if an intrinsic is a separate function.
pub(crate) fn intrinsics_are_inlined(library: &Path) -> Result<String, String> {
    let output = Command::new("objdump")
        .args(["--disassemble", "--demangle=rust", "--no-show-raw-insn"])
        .arg(library)
        .output()
        .map_err(|_| "disassembly: there is no objdump; `sudo apt-get install binutils`".to_owned())?;
    let text = String::from_utf8_lossy(&output.stdout);
    let (mut inside, mut instructions) = (false, 0);
    for line in text.lines() {
        if let Some(name) = line.strip_suffix(">:") {
            if intrinsic(name) {
                return Err(format!(
                    "disassembly: {name} is a function of its own, which makes lanes slow"
                ));
            }
            // The functions in which the compiler may use the wider registers, with all code inlined into them.
            inside = name.contains("::enter::avx") && name.contains("inside");
        } else if inside {
            instructions += usize::from(line.contains("%ymm") || line.contains("%zmm"));
        }
    }
    if instructions == 0 {
        return Err("disassembly: no code for wider registers was found by its name".to_owned());
    }
    Ok(format!(
        "disassembly: {instructions} instructions on wider registers, and no intrinsic that is a function of its own"
    ))
}

/// True if a function is an intrinsic of the vector units.
fn intrinsic(name: &str) -> bool {
    name.contains("core_arch::x86") && name.contains("_mm")
}
