mechanism! {
    pub Statue {
        body a on ground { mass: 1 }
    }
}

mechanism! {
    pub Void {}
}

mechanism! {
    pub Headless
}
