//! Trees of least-cost paths in a rough volume (Xu & Mould 2012).
