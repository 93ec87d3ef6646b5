//! Enums whose members are named once: for the command line, for scene files and for results.

/// Declares such an enum. From the one list come `ALL`, `NAMES`, `name()`, `named()` and the values of a command-line
/// option, whose help is the first line of each member's documentation: a member cannot be left out of any of them.
#[macro_export]
macro_rules! named_enum {
    (
        $(#[$outer:meta])*
        pub enum $choice:ident {
            $(#[doc = $help:literal] $(#[doc = $more:literal])* $member:ident = $name:literal,)+
        }
    ) => {
        $(#[$outer])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
        pub enum $choice {
            $(#[doc = $help] $(#[doc = $more])* #[serde(rename = $name)] $member,)+
        }

        impl $choice {
            /// All of them, in their order.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$member),+];

            /// Their names, in the same order.
            pub const NAMES: [&'static str; [$($name),+].len()] = [$($name),+];

            /// All of them with their names and the first lines of their documentation.
            pub const TOLD: &'static [(Self, &'static str, &'static str)] = &[$((Self::$member, $name, $help)),+];

            /// Name on the command line, in scene files and in results.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$member => $name,)+
                }
            }

            /// What it is: the first line of its documentation, without the full stop.
            pub fn title(self) -> &'static str {
                let help = match self {
                    $(Self::$member => $help,)+
                };
                help.trim().trim_end_matches('.')
            }

            /// The one of a name; none where it is no name of theirs.
            pub fn named(name: &str) -> Option<Self> {
                Self::ALL.into_iter().find(|member| member.name() == name)
            }
        }
    };
}

pub use named_enum;
