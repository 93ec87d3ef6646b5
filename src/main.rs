use contact_vv::formulation::*;
use contact_vv::mesh::*;
use contact_vv::scene::library::*;
fn main(){
  let n: usize = std::env::args().nth(1).map(|s| s.parse().unwrap()).unwrap_or(8);
  let ar: f64 = std::env::args().nth(2).map(|s| s.parse().unwrap()).unwrap_or(0.05);
  let c = Cylinder{a_over_r: ar, ..Default::default()};
  let a=c.half_width(); let p0=2.0*c.load()/(std::f64::consts::PI*a);
  let d = Discretisation::of(c.scene(), Resolution{elements:n,refinement:0,order:Order::Quadratic}).unwrap();
  println!("freedoms {} retained {} {:?}", d.system.freedoms(), d.condensed.retained(), d.seconds);
  for f in Formulation::nine().iter().chain([&Formulation::verification()]) {
    let t=std::time::Instant::now();
    match d.solve(f) {
      Ok(s)=>{
        let m0: f64 = s.points.iter().map(|p| p.weight*p.pressure).sum();
        let m2: f64 = s.points.iter().map(|p| p.weight*p.pressure*p.position.powi(2)).sum();
        println!("{} {:?} {:?} res {:.1e} load err {:.2e} a err {:.3}% p(0)err {:.3}%  {:.3}s", f.name(), s.outcome, s.work, s.residual(), m0/(c.load()/2.0)-1.0, (2.0*(m2/m0).sqrt()/a-1.0)*100.0, (s.points[0].pressure/p0-1.0)*100.0, t.elapsed().as_secs_f64());
      }
      Err(e)=>println!("{} {}", f.name(), e),
    }
  }
}
