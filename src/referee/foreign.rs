//! Files that hold no answer, or one in a coding that is not read: what they are, and what to hand in instead.

use std::path::Path;

use crate::error::Error;
use crate::referee::table::comment;

/// What CalculiX is to write.
const OF_CALCULIX: &str =
    "write *CONTACT FILE with CDIS and CSTR, with OUTPUT=3D of plane elements, and hand in the .frd";
/// What Abaqus is to write.
const OF_ABAQUS: &str = "write COORD and CPRESS of the nodes of the contact side as a report (.rpt), and hand that in";
/// What ParaView is to write.
const OF_PARAVIEW: &str = "open it in ParaView, and save the data as one .vtu";
/// What a run is to write.
const OF_RUN: &str = "hand in what the run wrote of the contact side: the .frd of CalculiX, a report (.rpt) of Abaqus \
    with COORD and CPRESS, or a .csv";

/// A kind of file: what it is, and what to do.
type Kind = (&'static str, &'static str);

/// Kinds by their endings.
const ENDINGS: [(&[&str], Kind); 11] = [
    (&["sta", "cvg"], ("it records increments and iterations, and no pressures", OF_RUN)),
    (&["log", "msg", "out", "err", "mntr"], ("it is the log of a run", OF_RUN)),
    (&["inp", "cdb", "geo", "bdf"], ("it is the input of a run, and no answer", OF_RUN)),
    (&["odb", "fil", "sim"], ("it is a database of Abaqus, whose coding is its own", OF_ABAQUS)),
    (
        &["rst", "rth", "db", "dbb"],
        (
            "it is a database of Ansys, whose coding is its own",
            "export the contact pressure with the places of its nodes as .txt",
        ),
    ),
    (&["e", "exo", "ex2"], ("it is a file of Exodus", OF_PARAVIEW)),
    (&["xdmf", "xmf", "h5", "hdf5", "vtkhdf"], ("it is a file of XDMF or HDF5", OF_PARAVIEW)),
    (&["pvtu", "vtp", "vtm", "vtr", "vts", "vti"], ("it is no unstructured grid in one file", OF_PARAVIEW)),
    (
        &["med", "rmed", "resu"],
        (
            "it is a file of Salome or code_aster",
            "save the field as .vtu by ParaViS, or print it as a table by IMPR_TABLE",
        ),
    ),
    (&["xlsx", "xls", "ods"], ("it is a workbook", "save the sheet with the answer as .csv")),
    (
        &["msh", "unv", "pos"],
        ("it is a file of Gmsh or I-deas", "hand in the grid with its fields as .vtu or .vtk, or a .csv"),
    ),
];

/// Kinds by what stands in them.
const TEXTS: [(&str, Kind); 9] = [
    (
        "(slave node,",
        (
            "it is what *CONTACT PRINT of CalculiX writes: numbers of slave nodes that are pressed, and no places",
            OF_CALCULIX,
        ),
    ),
    (
        "(slave element+face,",
        (
            "it is what *CONTACT PRINT of CalculiX writes: faces of slave elements, whose points have no places",
            OF_CALCULIX,
        ),
    ),
    ("SUMMARY OF JOB INFORMATION", ENDINGS[0].1),
    ("NVERGENCE INFORMATION", ENDINGS[0].1),
    ("CalculiX Version", ENDINGS[1].1),
    ("The Abaqus Software is a product of", ("it is the listing (.dat) of a run of Abaqus", OF_ABAQUS)),
    ("A B A Q U S", ("it is the listing (.dat) of a run of Abaqus", OF_ABAQUS)),
    (
        " for set ",
        ("it is what *NODE PRINT, *EL PRINT or *SECTION PRINT of CalculiX write, and not of our deck", OF_CALCULIX),
    ),
    ("S T E P", ("it is the listing of a run", OF_RUN)),
];

/// What a file is by its ending; none of one that may be read, or is not known.
pub fn by_ending(file: &Path, ending: &str) -> Option<Error> {
    let (_, (what, remedy)) = ENDINGS.iter().find(|(endings, _)| endings.contains(&ending))?;
    Some(Error::file(file, *what, *remedy))
}

/// What a text is that is no table.
pub fn by_text(file: &Path, text: &str) -> Option<Error> {
    let has = |mark: &str| text.lines().any(|line| line.contains(mark) && comment(line).is_none());
    let (_, (what, remedy)) = TEXTS.iter().find(|(mark, _)| has(mark))?;
    Some(Error::file(file, *what, *remedy))
}
