//! Bytes read as a program: which function comes next, and what it is given.

/// What is left of an input. Where nothing is left, zeros come.
pub(crate) struct Script<'a>(pub(crate) &'a [u8]);

impl<'a> Script<'a> {
    /// Whether anything is left.
    pub(crate) fn goes_on(&self) -> bool {
        !self.0.is_empty()
    }

    /// The next byte.
    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    /// Four bytes, the lowest first.
    pub(crate) fn word(&mut self) -> u32 {
        u32::from_le_bytes([self.byte(), self.byte(), self.byte(), self.byte()])
    }

    /// A number in the tens in steps of a quarter, or, one time in four, any bits at all.
    pub(crate) fn float(&mut self) -> f32 {
        let how = self.byte();
        if how % 4 == 3 { f32::from_bits(self.word()) } else { 0.25 * f32::from(how as i8) }
    }

    /// That many of them.
    pub(crate) fn floats(&mut self, n: usize) -> Vec<f32> {
        (0..n).map(|_| self.float()).collect()
    }

    /// Three of them.
    pub(crate) fn point(&mut self) -> [f32; 3] {
        [self.float(), self.float(), self.float()]
    }

    /// A part of the input, after two bytes that say how long it is.
    pub(crate) fn part(&mut self) -> &'a [u8] {
        let len = usize::from(self.byte()) | usize::from(self.byte()) << 8;
        let (part, rest) = self.0.split_at(len.min(self.0.len()));
        self.0 = rest;
        part
    }
}
