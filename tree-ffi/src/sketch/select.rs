//! Which template suits a drawing.
