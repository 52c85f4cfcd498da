//! Methods that forward to a wrapped value.

/// Implements methods by forwarding to a wrapped value; `[mut]` stands before those that change it.
macro_rules! forward {
    ($self:ident => $wrapped:expr;
     $(
        $([$mut:tt])? $method:ident($($argument:ident: $kind:ty),*) $(-> $output:ty)?
        $(where $number:ident: $order:ident)?;
     )*) => {
        $(
            #[inline(always)]
            fn $method(&$($mut)? $self, $($argument: $kind),*) $(-> $output)?
            $(where $number: $order)?
            {
                $wrapped.$method($($argument),*)
            }
        )*
    };
}

/// Implements the methods of a [`System`](crate::System) other than its equations by forwarding to a wrapped system.
macro_rules! forward_state {
    ($self:ident => $wrapped:expr) => {
        $crate::forward::forward! { $self => $wrapped;
            active() -> usize;
            layout() -> Option<StateLayout<'_>>;
            is_autonomous() -> Option<bool>;
            project(t: T, x: &mut SVector<T, N>);
            margins(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 2]));
            gaps(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut([&str; 2], [T; 3]));
            each_output(t: T, x: &SVector<T, N>, tell: &mut dyn FnMut(&str, T));
        }
    };
}

/// Implements the methods of a [`System`](crate::System) by forwarding to a wrapped system, but for `rhs_into`.
macro_rules! forward_system {
    ($self:ident => $wrapped:expr) => {
        $crate::forward::forward_state!($self => $wrapped);
        $crate::forward::forward! { $self => $wrapped;
            rhs(t: T, x: &SVector<T, N>) -> SVector<T, N>;
            is_apart() -> bool;
            hybrid() -> Option<&dyn Hybrid<T, N>>;
        }
    };
}
pub(crate) use {forward, forward_state, forward_system};

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use crate::hybrid::{Hold, InMode};
    use crate::system::{Differences, System};

    /// Grows at a constant rate.
    struct Growing;

    impl System<f64, 1> for Growing {
        fn rhs(&self, _t: f64, _x: &SVector<f64, 1>) -> SVector<f64, 1> {
            SVector::from([1.0])
        }

        fn each_output(&self, _t: f64, x: &SVector<f64, 1>, tell: &mut dyn FnMut(&str, f64)) {
            tell("double", 2.0 * x[0]);
        }
    }

    fn sum_of_outputs(system: &impl System<f64, 1>) -> f64 {
        let mut sum = 0.0;
        system.each_output(0.0, &SVector::from([1.5]), &mut |_, output| sum += output);
        sum
    }

    #[test]
    fn wrapped_systems_have_their_outputs() {
        assert_eq!(sum_of_outputs(&&Growing), 3.0);
        assert_eq!(sum_of_outputs(&Differences(Growing)), 3.0);
        assert_eq!(sum_of_outputs(&InMode::new(&Growing, &Hold::default())), 3.0);
    }
}
