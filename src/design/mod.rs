//! What the designer asks for: hard points that give the wanted factors.

pub mod sqp;
