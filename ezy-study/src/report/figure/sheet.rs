//! What all parts of a picture have in common: its width, and its letters.

/// How wide a picture is, in points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Width {
    /// For a page, a slide, a paper.
    Wide,
    /// For the screen of a telephone.
    Narrow,
}

/// Size of the letters of labels.
pub(super) const LABEL_SIZE: f64 = 13.5;
/// Height of a line of text over the size of its letters.
pub(super) const LINE: f64 = 1.3;

impl Width {
    pub(super) fn points(self) -> f64 {
        match self {
            Self::Wide => 800.0,
            Self::Narrow => 390.0,
        }
    }
}
