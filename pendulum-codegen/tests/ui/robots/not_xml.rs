mechanism! {
    pub Arm {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/not_xml.urdf"),
    }
}

mechanism! {
    pub Unclosed {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/unclosed.urdf"),
    }
}

mechanism! {
    pub DocumentType {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/document_type.urdf"),
    }
}

mechanism! {
    pub Empty {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/empty.urdf"),
    }
}

mechanism! {
    pub NotUtf8 {
        gravity: [0, 0, -9.81],
        robot: urdf("tests/robots/not_utf8.urdf"),
    }
}
