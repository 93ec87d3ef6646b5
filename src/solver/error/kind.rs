//! The few kinds of errors that code tells apart.

use super::Coordinate;

/// What an error is, where code does something else about it than to print it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Wrong input of any other kind.
    Input,
    /// A file that must be there is not.
    MissingFile,
    /// A cell turned inside out or of no area.
    DegenerateCell,
    /// A candidate stretch without an element of the first body.
    EmptyStretch,
    /// No spring is left to fix a body that only contact fixes.
    NoSpringLeft {
        /// Iterations made before.
        iterations: usize,
    },
    /// Initial springs that cannot be distinguished from the round-off of the stiffness they are added to.
    SpringsTooSoft,
    /// Nothing presses a body that only contact fixes.
    NothingPresses,
    /// Contact that reaches the end of the candidate surface.
    ContactBeyondCandidates {
        /// Contact coordinate of the last candidate.
        end: Coordinate,
        /// Contact coordinate of the deepest penetration beyond, and its depth \[mm\]; none where only the pressure, which
        /// rises towards the end, shows it.
        deepest: Option<(Coordinate, f64)>,
    },
    /// A mesh of more dofs than are allowed.
    TooManyDofs {
        /// Those it would have.
        dofs: usize,
    },
}
