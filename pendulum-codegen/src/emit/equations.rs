//! The equations of motion as text.

use std::collections::HashMap;

use crate::dynamics::Dynamics;
use crate::expr::{Expr, ExprId, Graph, Level, Printer};
use crate::model::Model;

/// Text for people: mass matrix, bias and forces. `flat` says that the entries are short enough to stand for themselves;
/// elsewhere shared parts get names.
pub(crate) fn equations(model: &Model<'_>, dynamics: &Dynamics<'_>, flat: bool) -> String {
    let names = model.coordinate_names();
    let n = names.len();
    let mut rows: Vec<(String, Expr<'_>)> = Vec::new();
    for i in 0..n {
        for j in i..n {
            rows.push((format!("A[{}, {}]", names[i], names[j]), dynamics.mass_matrix[i][j]));
        }
    }
    rows.extend((0..n).map(|i| (format!("b[{}]", names[i]), dynamics.bias[i])));
    rows.extend((0..n).map(|i| (format!("Q[{}]", names[i]), dynamics.force[i])));
    let mut printer = Printer::new(model.graph);
    let mut text = String::from(
        "A qdd + b = Q, where A is symmetric, b holds velocity terms and gravity, Q the forces of the joints\n\n",
    );
    if !flat {
        let roots: Vec<Expr<'_>> = rows.iter().map(|(_, x)| *x).collect();
        for (count, id) in shared(model.graph, &roots).into_iter().enumerate() {
            let name = format!("t{count}");
            text.push_str(&format!("{name} = {}\n", printer.definition(id)));
            printer.name(id, name);
        }
        text.push('\n');
    }
    for (name, x) in rows {
        if !x.is_zero() {
            text.push_str(&format!("{name} = {}\n", printer.print(x.id())));
        }
    }
    text
}

/// Operations that are used more than once.
fn shared(g: &Graph, roots: &[Expr<'_>]) -> Vec<ExprId> {
    let mut uses: HashMap<ExprId, usize> = HashMap::new();
    let reachable = g.reachable(roots);
    for &id in &reachable {
        for operand in g.operands(id) {
            *uses.entry(operand).or_default() += 1;
        }
    }
    let is_shared = |id: &ExprId| {
        uses.get(id).is_some_and(|&n| n > 1) && g.operands(*id).next().is_some() && g.level(*id) == Level::State
    };
    reachable.into_iter().filter(is_shared).collect()
}
