use contact_vv::case::suite;
fn main(){
  let filter=std::env::args().nth(1).unwrap_or_default();
  let mut fails=0; let mut all=vec![];
  for t in suite::all() { if !t.title().contains(&filter) {continue}
    let c=std::time::Instant::now();
    match t.run() { Err(e)=>{fails+=1; println!("{} ERROR {e}", t.title())}, Ok(f)=>{ all.push(f.clone());
      if let Some(r)=&f.run { println!("{:50} {} steps {} a {:.6} p {:.5}  {:.2}s {} dofs", t.title(), r.solution.outcome, r.solution.work.steps, r.measures.half_width, r.measures.peak.pressure, c.elapsed().as_secs_f64(), r.freedoms);} else {println!("{:50} {:.2}s", t.title(), c.elapsed().as_secs_f64());}
      for k in &f.checks { if k.verdict!=contact_vv::case::Verdict::Pass || k.reference.kind!=contact_vv::oracle::ReferenceKind::SelfConsistency { if k.verdict!=contact_vv::case::Verdict::Pass {fails+=1;} println!("     {:?} {} = {:.8} ref {:.8} err {:.2e} tol {:.1e} | {}", k.verdict, k.quantity, k.value, k.reference.value, k.error, k.tolerance, k.requirement); } }
    }}}
  println!("fails {fails}");
  for s in contact_vv::case::statements::judge(&all) { println!("{}\n    {}\n    {}", s.text, s.measured, s.judgement); }
}
