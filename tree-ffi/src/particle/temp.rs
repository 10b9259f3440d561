#![allow(missing_docs)]
use crate::border::Versioned;
use tree_model::particle::attractor::*;
macro_rules! temp {
    ($n:ident, $r:ident) => {
        /// Temporary.
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        pub struct $n {
            /// Size.
            pub struct_size: usize,
        }
        unsafe impl Versioned for $n {
            const NAME: &'static str = stringify!($n);
            const FIRST: usize = 8;
            fn default_value() -> Self {
                Self { struct_size: 8 }
            }
        }
        impl $n {
            pub fn of(_: &$r) -> Self {
                Self { struct_size: 8 }
            }
            pub fn rust(&self) -> $r {
                $r::default()
            }
        }
    };
}
temp!(tree_seed_params, SeedParams);
temp!(tree_livewire_params, LivewireParams);
temp!(tree_stroke_params, StrokeParams);
