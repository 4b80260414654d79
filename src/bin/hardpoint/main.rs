//! The command line of hardpoint.

fn main() {}
