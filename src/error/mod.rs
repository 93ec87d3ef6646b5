//! What was wrong, with the numbers and the remedy.

pub mod coordinate;
pub mod located;

use std::path::PathBuf;

pub use coordinate::Coordinate;
pub use located::Located;

/// Wrong input or broken numerics; not converging is an [`Outcome`](crate::solution::Outcome), never an error.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A value outside its range.
    #[error("{place}: `{key}` = {found}, but {expected}; {remedy}")]
    Value {
        /// The scene, body or option the value belongs to.
        place: String,
        /// Its key.
        key: String,
        /// What was found.
        found: String,
        /// What would be accepted.
        expected: String,
        /// What to do.
        remedy: String,
    },

    /// A boundary, body or case that does not exist.
    #[error("{place}: there is no {kind} `{name}`; known: {known}")]
    Unknown {
        /// Where the name was used.
        place: String,
        /// What sort of thing was looked for.
        kind: &'static str,
        /// The name that was not found.
        name: String,
        /// The names that exist.
        known: String,
    },

    /// A cell turned inside out or of no area.
    #[error(
        "cell {cell} of `{body}` has Jacobian determinant {jacobian:.3e} at a quadrature point; make the grading gentler or the elements smaller"
    )]
    DegenerateCell {
        /// Index of the cell in the mesh.
        cell: usize,
        /// Name of the body.
        body: String,
        /// Determinant found \[mm²\].
        jacobian: f64,
    },

    /// A mesh that does not hang together.
    #[error(
        "the mesh of `{body}` does not hang together: {what}; let neighbouring cells share their nodes (Coherence in Gmsh, common curves of neighbouring surfaces, whole common sides of blocks)"
    )]
    LooseMesh {
        /// Name of the body.
        body: String,
        /// What is wrong, and where.
        what: String,
    },

    /// A face that stays flat with a node that cannot follow.
    #[error(
        "body `{body}`: node {node} of the rigid face `{boundary}` is held, or belongs to another rigid face, in the direction in which the face moves as one; hold the whole face, or none of it"
    )]
    HeldRigidFace {
        /// Name of the body.
        body: String,
        /// Boundary that stays flat.
        boundary: String,
        /// Node index.
        node: usize,
    },

    /// A body that its supports and the candidate contact nodes leave free to move.
    #[error(
        "body `{body}` is free to {motion} even when every contact node is held; add a support, on a boundary or at one node"
    )]
    FreeMotion {
        /// Name of the body.
        body: String,
        /// The free rigid motion.
        motion: String,
    },

    /// A stiffness that is not positive definite although every rigid motion is held.
    #[error(
        "stiffness of `{body}` is not positive definite (pivot {pivot}); check its material and the shape of its cells"
    )]
    SingularStiffness {
        /// Name of the body.
        body: String,
        /// Index of the pivot in the elimination order.
        pivot: usize,
    },

    /// A support in a direction that a contact node's normal or tangent does not have.
    #[error(
        "body `{body}`: the support `{component}` at node {node} is oblique to the contact normal there, or holds the very displacement along it that contact is to find; leave it out, or end the candidate stretch before that node"
    )]
    ObliqueSupport {
        /// Name of the body.
        body: String,
        /// Node index.
        node: usize,
        /// Component that was to be held.
        component: String,
    },

    /// A candidate stretch that holds no element of the first body.
    #[error(
        "{place}: `candidate stretch` is {stretch}: it must hold at least one element edge of `{body}`; lengthen it or refine the mesh"
    )]
    EmptyStretch {
        /// Index of the contact in the scene.
        contact: usize,
        /// Name of the scene, and of the contact where there are several.
        place: String,
        /// The candidate stretch.
        stretch: Coordinate,
        /// Body that carries the contact points.
        body: String,
    },

    /// A node that would be a candidate of two contacts.
    #[error(
        "body `{body}`: the node at {at} would be a candidate of two contacts, and has one normal displacement; shorten the candidate stretch of one of them"
    )]
    SharedCandidate {
        /// Index of the second of these contacts in the scene.
        contact: usize,
        /// Name of the body.
        body: String,
        /// Where the node lies.
        at: String,
    },

    /// A candidate that no edge of the other body faces.
    #[error(
        "contact of `{first}` and `{second}`: nothing of `{second}` faces the node of `{first}` at s = {at}, its contact side lies between {from} and {to}; shorten the candidate stretch, or make the sides begin together"
    )]
    NotFacing {
        /// Index of the contact in the scene.
        contact: usize,
        /// Body that carries the contact points.
        first: String,
        /// Facing body.
        second: String,
        /// Contact coordinate of the node.
        at: Coordinate,
        /// Where the facing edges begin.
        from: Coordinate,
        /// Where they end.
        to: Coordinate,
    },

    /// No spring is left to hold a body that only contact holds.
    #[error(
        "{bodies}: held by contact alone and no contact spring is left after {steps} steps; the load pulls the bodies apart, the start is too soft, or the contact is smaller than two elements: reverse the load, add a support, raise the initial stiffness or refine the mesh"
    )]
    NoSpringLeft {
        /// The bodies in contact.
        bodies: String,
        /// Steps made before.
        steps: usize,
    },

    /// Initial springs too soft to be told from the round-off of the stiffness they are added to.
    #[error(
        "{bodies}: held by contact alone, and the initial springs are lost in the round-off of the bodies' stiffness; raise `stiffness` {times:.0e} times"
    )]
    SpringsTooSoft {
        /// The bodies in contact.
        bodies: String,
        /// Factor on the initial stiffness that holds them, with two digits to spare.
        times: f64,
    },

    /// Nothing presses a body that only contact holds.
    #[error(
        "{bodies}: held by contact alone and nothing presses on: the pressure is zero and the position undetermined; apply a load or add a support"
    )]
    NothingPresses {
        /// The bodies in contact.
        bodies: String,
    },

    /// Contact that does not end where the candidates end.
    #[error(
        "{bodies}: contact goes on beyond the candidates, which end at s = {end}: at s = {position} the surfaces penetrate by {penetration:.3e} mm, and the pressure found is that of a shorter contact; widen the candidate stretch"
    )]
    ContactBeyondCandidates {
        /// Index of the contact in the scene.
        contact: usize,
        /// The bodies in contact.
        bodies: String,
        /// Contact coordinate of the last candidate.
        end: Coordinate,
        /// Contact coordinate of the deepest penetration.
        position: Coordinate,
        /// Penetration there \[mm\].
        penetration: f64,
    },

    /// Pressure that rises towards the last candidate although the surfaces go on.
    #[error(
        "{bodies}: the pressure rises towards the last candidate at s = {end} although the surfaces go on: the contact is cut short there, and the pressure found is that of a shorter one; widen the candidate stretch"
    )]
    ContactCutShort {
        /// Index of the contact in the scene.
        contact: usize,
        /// The bodies in contact.
        bodies: String,
        /// Contact coordinate of the last candidate.
        end: Coordinate,
    },

    /// A combination of element, algorithm, rule and scene that is not defined.
    #[error("{what}; {remedy}")]
    Combination {
        /// What does not go together.
        what: String,
        /// What to choose instead.
        remedy: String,
    },

    /// A file that could not be read or written.
    #[error("{path}: {reason}; {remedy}")]
    File {
        /// The file.
        path: PathBuf,
        /// What the system or the parser said.
        reason: String,
        /// What to do.
        remedy: String,
    },

    /// A file that must be there is not.
    #[error("`{}` is missing: {remedy}", file.display())]
    MissingFile {
        /// The file looked for.
        file: PathBuf,
        /// What to do.
        remedy: String,
    },
    /// A file is there but cannot be read or parsed.
    #[error("`{}` cannot be read: {found}; {remedy}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the reader met.
        found: String,
        /// What to do.
        remedy: String,
    },
    /// A key or column that must be there is not.
    #[error("`{}`: `{key}` is missing among {found}; {remedy}", file.display())]
    MissingKey {
        /// The file.
        file: PathBuf,
        /// The missing key or column.
        key: String,
        /// The keys or columns that are there.
        found: String,
        /// What to do.
        remedy: String,
    },
    /// A key, column or entry holds what cannot be accepted.
    #[error("`{}`: `{key}` is {found}; {remedy}", file.display())]
    Refused {
        /// The file.
        file: PathBuf,
        /// The key, column or entry.
        key: String,
        /// The value met.
        found: String,
        /// What to do.
        remedy: String,
    },

    /// Something wrong at a place in a file that a user wrote.
    #[error("{}", _0.in_one_line())]
    Located(Box<Located>),

    /// What the Python side of the oracles said.
    #[error("python oracles: {said}; {remedy}")]
    Python {
        /// The missing module, or the exception with its traceback.
        said: String,
        /// What to do.
        remedy: String,
    },

    /// A picture that could not be drawn.
    #[error("figure `{figure}`: {reason}")]
    Drawing {
        /// Name of the figure.
        figure: String,
        /// What the plotting library said.
        reason: String,
    },
}

impl Error {
    /// A value outside its range, from anything that prints.
    pub fn value(
        place: impl Into<String>,
        key: impl Into<String>,
        found: impl ToString,
        expected: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self::Value {
            place: place.into(),
            key: key.into(),
            found: found.to_string(),
            expected: expected.into(),
            remedy: remedy.into(),
        }
    }
}
