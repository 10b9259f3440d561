//! The particles and their traces (Neubert 2012, section 3.4).
