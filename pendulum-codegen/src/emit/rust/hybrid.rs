//! Models with constraints: dry friction, stops and walls.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::block::Piece;
use super::lanes::inlined_into_lanes;
use super::routines::value;
use super::{Items, count};
use crate::program::{Constraint, LAW, Role, Routine, Shape, SlotKind};

impl Items<'_> {
    /// Implementations of `Plant` and `PlantJacobian`: the motion under given inputs and constraint forces.
    pub(super) fn plant(&self) -> Option<TokenStream> {
        let (inline, (given, name)) = (inlined_into_lanes(), self.acting()?);
        let eval = self.function(&format_ident!("eval"), self.program.with_role(Role::Rhs)?);
        let modes = self
            .program
            .with_role(Role::Response)
            .and_then(|response| self.modes(response));
        let freedom = self.freedom(modes.is_some());
        let functions = quote! {
            type Given = #given;
            #inline
            #eval
            #freedom
            #modes
        };
        let plant = self.implement(Some(self.named("Plant")), &functions);
        let jacobian = self.program.with_role(Role::Jacobian).map(|jacobian| {
            let both = self.function(&format_ident!("eval_with_jacobian"), jacobian);
            let vector = self.shape(jacobian.shapes[0]);
            let arguments = quote!(&self, t: T, x: &#vector, #name: &#given);
            let by_time = self.time_derivative("eval_time_derivative", &arguments);
            let of_modes = self.program.with_role(Role::ResponseDerivative);
            let of_modes = of_modes.and_then(|derivative| self.derivatives_of_modes(derivative));
            let functions = quote!(#inline #both #inline #by_time #of_modes);
            self.implement(Some(self.named("PlantJacobian")), &functions)
        });
        Some(quote!(#plant #jacobian))
    }

    /// Methods of `Plant` for the number of rates and the places of orientations, unless the defaults fit.
    fn freedom(&self, has_modes: bool) -> TokenStream {
        let layout = &self.program.layout;
        let oriented = layout.slots.iter().filter(|slot| slot.kind == SlotKind::Quaternion);
        let oriented: Vec<TokenStream> = oriented
            .filter(|_| has_modes)
            .map(|slot| {
                let [quaternion, turn] = [&slot.positions, &slot.rates].map(|places| count(places.start));
                quote!([#quaternion, #turn])
            })
            .collect();
        let dof = (layout.dof() != layout.len() / 2).then(|| {
            let dof = count(layout.dof());
            quote! {
                #[inline(always)]
                fn dof(&self) -> usize {
                    #dof
                }
            }
        });
        let orientations = (!oriented.is_empty()).then(|| {
            quote! {
                #[inline(always)]
                fn orientations(&self) -> &[[usize; 2]] {
                    &[#(#oriented),*]
                }
            }
        });
        quote!(#dof #orientations)
    }

    /// Implementations of `System` and `Jacobian` for a model with constraints and no inputs: friction follows the sign
    /// of each rate.
    pub(super) fn hybrid(&self) -> Option<TokenStream> {
        self.program.with_role(Role::Rhs)?;
        let (inline, length, labels) = (inlined_into_lanes(), self.length(), self.labels());
        let (core, assembly) = (quote!(::pendulum_core::hybrid), self.assembly());
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let system = quote! {
            #inline
            fn rhs(&self, t: T, x: &#vector) -> #vector {
                ::pendulum_core::Plant::eval(self, t, x, &#core::by_sign(self, t, x))
            }
            #labels
            #assembly
            #[inline]
            fn hybrid(&self) -> ::core::option::Option<&dyn #core::Hybrid<T, #length>> {
                Some(self)
            }
        };
        let system = self.implement(Some(self.named("System")), &system);
        let jacobian = self.program.with_role(Role::Jacobian).map(|jacobian| {
            let matrix = self.shape(jacobian.shapes[1]);
            let lanes = quote!(::pendulum_core::real::lanes::Lanes);
            let functions = quote! {
                #[inline]
                fn jacobian(&self, t: T, x: &#vector) -> #matrix {
                    self.rhs_and_jacobian(t, x).1
                }
                #[inline]
                fn rhs_and_jacobian(&self, t: T, x: &#vector) -> (#vector, #matrix) {
                    ::pendulum_core::PlantJacobian::eval_with_jacobian(self, t, x, &#core::by_sign(self, t, x))
                }
                #[inline]
                fn time_derivative(&self, t: T, x: &#vector) -> #vector
                where
                    T: #lanes,
                {
                    ::pendulum_core::PlantJacobian::eval_time_derivative(self, t, x, &#core::by_sign(self, t, x))
                }
                #[inline]
                fn hybrid_jacobian(&self) -> ::core::option::Option<&dyn #core::HybridJacobian<T, #length>> {
                    Some(self)
                }
            };
            self.implement(Some(self.named("Jacobian")), &functions)
        });
        Some(quote!(#system #jacobian))
    }

    /// Methods of `Plant` for the constraints and the response to forces along them.
    fn modes(&self, response: &Routine) -> Option<TokenStream> {
        let core = quote!(::pendulum_core::hybrid);
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let [constraints, laws, measures] = [self.constraint_list(), self.laws(), self.measures()?];
        let response = self.of_response(response, |values| self.response(values));
        Some(quote! {
            #[inline]
            fn constraints(&self) -> &[#core::Constraint<'_>] {
                const { &[#constraints] }
            }
            #[inline]
            fn laws(&self) -> [#core::Law<T>; #core::MAX_CONSTRAINTS] #laws
            #[inline]
            fn measures(&self, t: T, x: &#vector) -> [[T; 2]; #core::MAX_CONSTRAINTS] #measures
            #[inline]
            #response
        })
    }

    /// Methods of `PlantJacobian` for the derivatives of the constraints and of the response.
    fn derivatives_of_modes(&self, derivative: &Routine) -> Option<TokenStream> {
        let (core, length) = (quote!(::pendulum_core::hybrid), self.length());
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let derivative = self.of_response(derivative, |values| self.response_derivative(values));
        let of_measures = self.measure_derivatives()?;
        let of_measures = quote! {
            #[inline]
            fn measure_derivatives(&self, t: T, x: &#vector) -> #core::MeasureDerivatives<T, #length> #of_measures
        };
        Some(quote!(#[inline] #derivative #of_measures))
    }

    /// Implementations of `PlantCanonical` and `Canonical`, if the scene requests them.
    pub(super) fn hybrid_canonical(&self) -> Option<TokenStream> {
        let (core, length) = (quote!(::pendulum_core::hybrid), self.length());
        let vector = self.shape(Shape::Vector(self.program.layout.len()));
        let (given, _) = self.acting()?;
        let functions = [Role::Canonical, Role::CanonicalJacobian].map(|role| {
            let routine = self.program.with_role(role)?;
            let (name, eval) = (
                format_ident!("{}", routine.name),
                format_ident!("eval_{}", routine.name),
            );
            let [one, other] = [0, 1].map(|n| self.shape(routine.shapes[n]));
            let function = self.function(&eval, routine);
            let by_itself = quote! {
                #[inline]
                fn #name(&self, t: T, x: &#vector) -> (#one, #other) {
                    ::pendulum_core::PlantCanonical::#eval(self, t, x, &#core::by_sign(self, t, x))
                }
            };
            Some((quote!(#[inline] #function), by_itself))
        });
        let functions: Option<Vec<_>> = functions.into_iter().collect();
        let (of_plant, by_itself): (TokenStream, TokenStream) = functions?.into_iter().unzip();
        let of_plant = self.implement(Some(self.named("PlantCanonical")), &of_plant);
        let canonical = quote! {
            #by_itself
            #[inline]
            fn hybrid_canonical(
                &self,
            ) -> ::core::option::Option<&dyn ::pendulum_core::PlantCanonical<T, #length, Given = #given>> {
                Some(self)
            }
        };
        let canonical = self.implement(Some(self.named("Canonical")), &canonical);
        Some(quote!(#of_plant #canonical))
    }

    fn constraint_list(&self) -> TokenStream {
        let constraint = |Constraint { name, rate, .. }: &Constraint| {
            let rate = rate.iter().map(|&(component, sign)| {
                let (component, sign) = (count(component), Literal::i8_unsuffixed(sign));
                quote!((#component, #sign))
            });
            quote!(::pendulum_core::hybrid::Constraint { name: #name, rate: &[#(#rate),*] })
        };
        let constraints = self.program.constraints.iter().map(constraint);
        quote!(#(#constraints),*)
    }

    fn laws(&self) -> TokenStream {
        let constants = self.constants(&format_ident!("self"), &self.program.laws.reads());
        let code = self.names().code(&self.program.laws, |mut values| {
            let laws = self.program.constraints.iter().enumerate().map(|(n, constraint)| {
                let mut next = || {
                    let (first, rest) = values.split_first().expect("a number for each");
                    values = rest;
                    first.to_token_stream()
                };
                let [slipping, sticking, restitution, slow] = [(); LAW].map(|()| next());
                let [low, high] = [constraint.low, constraint.high].map(|is_limited| match is_limited {
                    true => {
                        let limit = next();
                        quote!(Some(#limit))
                    }
                    false => quote!(None),
                });
                let n = count(n);
                quote! {
                    laws[#n] = ::pendulum_core::hybrid::Law {
                        slipping: #slipping,
                        sticking: #sticking,
                        low: #low,
                        high: #high,
                        restitution: #restitution,
                        slow: #slow,
                    };
                }
            });
            let laws: TokenStream = laws.collect();
            quote! {
                let mut laws = [::pendulum_core::hybrid::Law::default(); ::pendulum_core::hybrid::MAX_CONSTRAINTS];
                #laws
                laws
            }
        });
        quote!({ #constants #code })
    }

    fn measures(&self) -> Option<TokenStream> {
        let routine = self.program.with_role(Role::Measures)?;
        Some(self.block(&routine.block, |values| {
            let (values, rates) = values.split_at(self.program.constraints.len());
            let number = (0..values.len()).map(count);
            quote! {
                let mut measures = [[T::from_f64(0.0); 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS];
                #(measures[#number] = [#values, #rates];)*
                measures
            }
        }))
    }

    fn measure_derivatives(&self) -> Option<TokenStream> {
        let routine = self.program.with_role(Role::MeasureDerivatives)?;
        Some(self.block(&routine.block, |entries| {
            let (length, rows) = (self.program.layout.len(), self.program.constraints.len());
            let (by_state, by_time) = entries.split_at(2 * length * rows);
            let gradients: Vec<TokenStream> = by_state.chunks(length).map(vector).collect();
            let rows = (0..rows).map(|n| {
                let [values, rates] = [0, 1].map(|which| &gradients[which * rows + n]);
                let [value, rate] = [0, 1].map(|which| &by_time[which * rows + n]);
                let n = count(n);
                quote! {
                    derivatives.by_state[#n] = [#values, #rates];
                    derivatives.by_time[#n] = [#value, #rate];
                }
            });
            let rows: TokenStream = rows.collect();
            let length = count(length);
            quote! {
                let zero = T::from_f64(0.0);
                let mut derivatives = ::pendulum_core::hybrid::MeasureDerivatives {
                    by_state: [[::pendulum_core::nalgebra::SVector::from([zero; #length]); 2];
                        ::pendulum_core::hybrid::MAX_CONSTRAINTS],
                    by_time: [[zero; 2]; ::pendulum_core::hybrid::MAX_CONSTRAINTS],
                };
                #rows
                derivatives
            }
        }))
    }

    /// Method that returns a response or its derivatives.
    fn of_response(&self, routine: &Routine, result: impl FnOnce(&[Piece]) -> TokenStream) -> TokenStream {
        let (arguments, length) = (self.arguments(routine), self.length());
        let core = quote!(::pendulum_core::hybrid);
        let output = match routine.role {
            Role::Response => quote!(#core::Response<T, #length>),
            _ => quote!(#core::ResponseDerivative<T, #length>),
        };
        let name = format_ident!("{}", routine.name);
        let block = self.body(routine, &output, result);
        quote!(fn #name(#arguments) -> #output #block)
    }

    /// Statements that assemble and return a response.
    fn response(&self, values: &[Piece]) -> TokenStream {
        let (length, rows) = (self.program.layout.len(), self.program.constraints.len());
        let (rates, values) = values.split_at(length);
        let (accelerations, values) = values.split_at(rows);
        let (columns, triangle) = values.split_at(length * rows);
        let rates = vector(rates);
        let (columns, number) = (columns.chunks(length).map(vector), (0..rows).map(count));
        let number = number.collect::<Vec<_>>();
        let places = (0..rows).flat_map(|i| (i..rows).map(move |j| (i, j)));
        let entries = places.zip(triangle).map(|((i, j), entry)| {
            let (row, column) = (count(i), count(j));
            if i == j {
                quote!(response.matrix[#row][#column] = #entry;)
            } else {
                quote! {
                    response.matrix[#row][#column] = #entry;
                    response.matrix[#column][#row] = response.matrix[#row][#column];
                }
            }
        });
        quote! {
            let mut response = ::pendulum_core::hybrid::Response::new(#rates);
            #(response.accelerations[#number] = #accelerations;)*
            #(response.columns[#number] = #columns;)*
            #(#entries)*
            response
        }
    }

    fn response_derivative(&self, values: &[Piece]) -> TokenStream {
        let (length, rows) = (self.program.layout.len(), self.program.constraints.len());
        let of_response = length + rows + length * rows + rows * (rows + 1) / 2;
        let (own, values) = values.split_at(of_response);
        let response = self.response(own);
        let (rates, values) = values.split_at(length * length);
        let (gradients, values) = values.split_at(length * rows);
        let (by_time, of_rows) = values.split_at(length);
        let rates = value(Shape::Matrix(length, length), rates);
        let (gradients, by_time) = (gradients.chunks(length).map(vector), vector(by_time));
        let number = (0..rows).map(count).collect::<Vec<_>>();
        let length = count(length);
        quote! {
            let response = { #response };
            let zero = T::from_f64(0.0);
            let mut accelerations =
                [::pendulum_core::nalgebra::SVector::from([zero; #length]); ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            #(accelerations[#number] = #gradients;)*
            let mut accelerations_by_time = [zero; ::pendulum_core::hybrid::MAX_CONSTRAINTS];
            #(accelerations_by_time[#number] = #of_rows;)*
            ::pendulum_core::hybrid::ResponseDerivative {
                response,
                rates: #rates,
                accelerations,
                rates_by_time: #by_time,
                accelerations_by_time,
            }
        }
    }
}

fn vector(values: &[Piece]) -> TokenStream {
    value(Shape::Vector(values.len()), values)
}
