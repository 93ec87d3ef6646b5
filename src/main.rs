use contact_vv::formulation::*;
use contact_vv::mesh::*;
use contact_vv::scene::library::*;
fn main(){
  for n in [8,12,16,24,32] {
  for (d,name) in [(Discretisation::of(PinRod::default().scene(), Resolution{elements:n,refinement:0,order:Order::Quadratic}).unwrap(),"pin"), (Discretisation::of(Cylinder::default().scene(), Resolution{elements:n,refinement:0,order:Order::Quadratic}).unwrap(),"cyl")] {
  let mut reference: Vec<f64> = vec![];
  let mut areas: Vec<f64> = vec![];
  let mut fs=vec![Formulation::new(Element::Node,Iteration::Kinematic)]; for e in [Element::Line,Element::Layer] { for k in [100.0,300.0,1e3,2e3,1e4,1e5] { fs.push(Formulation{stiffness:k,..Formulation::new(e,Iteration::Kinematic)}); } }
  for (i,f) in fs.iter().enumerate() {
  let s=d.solve(f).unwrap();
  if i==0 { areas = s.points.iter().map(|p| p.weight).collect(); }
  let p: Vec<f64> = areas.iter().enumerate().map(|(j,a)| -s.contact_force[d.interface.stations[j].freedoms[0]]/a).collect();
  if i==0 { reference=p.clone(); }
  let l2=(areas.iter().zip(&p).zip(&reference).map(|((a,p),r)| a*(p-r).powi(2)).sum::<f64>()/areas.iter().zip(&reference).map(|(a,r)| a*r*r).sum::<f64>()).sqrt();
  let m=p.iter().cloned().fold(0.0,f64::max);
  let mom=|p:&Vec<f64>| { let m0:f64=areas.iter().zip(p).map(|(a,p)|a*p).sum(); let m2:f64=areas.iter().zip(p).zip(&d.interface.stations).map(|((a,p),s)|a*p*s.coordinate.powi(2)).sum(); (m2/m0).sqrt()};
  let raw=s.points.windows(2).take(16).map(|w|(w[0].pressure-w[1].pressure).abs()).fold(0.0,f64::max)/m; println!("{n} {name} {} {} raw {raw:.4} res {:.1e} steps {} peak {:.4} angle {:.4}% l2 {:.3}%  min {:.3}", f.name(), f.stiffness, s.residual(), s.work.steps, m, (mom(&p)/mom(&reference)-1.0)*100.0, l2*100.0, p.iter().cloned().fold(9.,f64::min)/m);
  if n==16 && name=="pin" && f.name()=="line.kinematic" { for j in 0..p.len() { print!("{:.2} ", p[j]-reference[j]);} println!(); }
  }}}
}
