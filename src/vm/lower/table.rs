//! A number for some of many registers, quick to look up and quick to forget.

use crate::program::Reg;

pub struct Table {
    numbers: Vec<u32>,
    /// Those that may have one.
    filled: Vec<Reg>,
}

const NONE: u32 = u32::MAX;

impl Table {
    /// For registers below `end`.
    pub fn new(end: Reg) -> Self {
        Self { numbers: vec![NONE; end as usize], filled: vec![] }
    }

    pub fn get(&self, register: Reg) -> Option<u32> {
        Some(self.numbers[register as usize]).filter(|number| *number != NONE)
    }

    pub fn insert(&mut self, register: Reg, number: u32) {
        self.numbers[register as usize] = number;
        self.filled.push(register);
    }

    pub fn remove(&mut self, register: Reg) {
        self.numbers[register as usize] = NONE;
    }

    /// No register has that number any more.
    pub fn forget(&mut self, number: u32) {
        for register in &self.filled {
            let own = &mut self.numbers[*register as usize];
            if *own == number {
                *own = NONE;
            }
        }
    }

    pub fn clear(&mut self) {
        self.filled.drain(..).for_each(|register| self.numbers[register as usize] = NONE);
    }
}
