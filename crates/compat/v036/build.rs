//! Selects Rapier 0.36 in the source that the facades share. A feature could not: programs that disable the
//! default features would disable it.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(rapier036)");
    println!("cargo::rustc-cfg=rapier036");
}
