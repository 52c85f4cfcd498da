//! Error codes: one for each kind of mistake, with a page of the book that explains it.

macro_rules! codes {
    ($($(#[$section:meta])* $name:ident $text:literal $title:literal,)*) => {
        /// Kind of a mistake in a declaration.
        ///
        /// Its text, such as `M203`, ends the first line of each message. The page `docs/src/errors/M203.md` of the
        /// book explains it, with a wrong and a correct example.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Code {
            $(#[doc = $title] $name,)*
        }

        impl Code {
            /// All codes, in numerical order.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Returns the text used in messages, such as `M203`.
            pub const fn text(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            /// Returns the title of the page in the book.
            pub const fn title(self) -> &'static str {
                match self {
                    $(Self::$name => $title,)*
                }
            }
        }
    };
}

codes! {
    // Reading the declaration.
    Syntax "M001" "A syntax error",
    UnknownWord "M002" "An unknown word",
    Misplaced "M003" "A field among the items, or an item among the fields",
    GivenTwice "M004" "A field, item or routine given twice",
    Arguments "M005" "Wrong arguments",
    NotInLanguage "M006" "Rust syntax that the language does not have",
    TooLong "M007" "A declaration beyond the limits of size",
    NoScene "M008" "A scene without a name or a body",
    // Names.
    UnknownName "M101" "An undeclared name",
    UnknownFunction "M102" "An unknown function",
    NameTaken "M103" "A name that is reserved or already declared",
    WrongKind "M104" "A name that stands for something else",
    Unused "M105" "A declaration without effect",
    Circle "M106" "A cycle of declarations, or a use before the definition",
    // Units and numbers.
    UnknownUnit "M201" "An unknown or malformed unit",
    MissingUnit "M202" "A parameter, input or state without a unit",
    UnitMismatch "M203" "Units that do not match",
    Degrees "M204" "An angle that looks like degrees",
    NumberRange "M205" "A number out of range",
    // Expressions.
    Undefined "M301" "An undefined value",
    Dependence "M302" "A dependence that is not allowed here",
    NotSmooth "M303" "A kink where the motion must be smooth",
    Exponent "M304" "An exponent that is not a small number",
    NoRate "M305" "A rate that is not available",
    // Bodies.
    MassProperties "M401" "Mass properties that do not belong together",
    OutOfBounds "M402" "A number that is physically impossible",
    NotARigidBody "M403" "An inertia that no rigid body has",
    SingularMassMatrix "M404" "A mass matrix that is singular in every state",
    JointCoordinate "M405" "A joint and a coordinate that do not fit",
    FreeRotation "M406" "A ball or free joint used like one with a single coordinate",
    Absolute "M407" "An angle that cannot be measured from ground",
    DegenerateSolid "M408" "A solid without length, area or inside",
    RefusedDefault "M409" "An invalid default",
    NothingMoves "M410" "A scene without a degree of freedom",
    // Forces, motions and what is generated.
    NoEffect "M501" "A force that cannot act",
    Motion "M502" "A motion that no joint can follow",
    NotGenerated "M503" "A routine that is not available for the scene",
    // Dry friction, stops and walls.
    Constraint "M601" "Dry friction, a stop or a wall that contradicts itself",
    TooManyConstraints "M602" "Too many constraints: dry friction, stops and walls",
    NoGap "M603" "A wall that nothing can open or close",
    NoConstraint "M604" "Dry friction, a stop or a wall where it is not supported",
    // Closed loops.
    LoopCount "M701" "Loops and dependent coordinates that do not match",
    OpenLoop "M702" "A loop that cannot be assembled",
    AmbiguousLoop "M703" "A loop that can be assembled in more than one way",
    SingularLoop "M704" "A loop that is singular where it is assembled",
    LoopJoint "M705" "A joint that cannot close a loop",
    // Robots from files.
    NoFile "M801" "A robot file that cannot be opened",
    NotUrdf "M802" "A robot file that is not URDF",
    FileElement "M803" "An unknown element or attribute",
    FileNumber "M804" "A value of a robot file that is wrong or missing",
    FileTree "M805" "Links that do not form a tree",
    FileInertia "M806" "An inertia in a robot file that no rigid body has",
    FileJoint "M807" "An unsupported joint in a robot file",
    FileNames "M808" "Names of a robot file that collide",
    FileChange "M809" "A change to a robot that is not possible",
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.text())
    }
}
