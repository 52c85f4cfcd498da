use super::Formula;
impl Formula {
    pub fn latex_equation(&self, _left: &Formula) -> String {
        String::new()
    }
}
