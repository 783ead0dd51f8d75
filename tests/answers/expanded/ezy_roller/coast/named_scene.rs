#[automatically_derived]
impl ezy::NamedScene for self::Coast {
    type Bodies<'a> = names::Bodies;
    type Inputs = ezy::NoInputs;
    type Outputs<'a> = ezy::NoOutputs;
    fn bodies_by_name<'a>(&self, q: &'a [f64], v: &'a [f64]) -> names::Bodies {
        let mut bodies = ezy::BodyReader::new(q, v);
        names::Bodies {
            seat: bodies.body(),
            bar: bodies.body(),
        }
    }
    fn outputs_by_name<'a>(&self, values: &'a [f64]) -> ezy::NoOutputs {
        ezy::NoOutputs
    }
}
