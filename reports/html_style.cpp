// The fixed text of every page: its style sheet and its one small script.
#include "reports/html_style.hpp"

#include <fmt/format.h>

#include <iterator>

#include "reports/palette.hpp"

namespace odemark {
namespace {

constexpr std::string_view light_and_layout = R"css(
:root{color-scheme:light dark;--paper:#fff;--ink:#1b1f24;--muted:#57606a;--line:#dfe3e8;--soft:#f5f7f9;
--link:#0a5ea8;--ok:#116b3c;--ok-soft:#e6f5ec;--fail:#b3261e;--fail-soft:#fdecea;--warn:#875400;--warn-soft:#fdf3dd;
--note:#0a5ea8;--note-soft:#e8f2fb}
*{box-sizing:border-box}
html{scroll-padding-top:4rem;-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,'Segoe UI',Roboto,'Helvetica Neue',Arial,sans-serif}
header,main,footer{max-width:67rem;margin:0 auto;padding:0 1.25rem}
a{color:var(--link);text-underline-offset:.15em}
a:focus-visible,summary:focus-visible,button:focus-visible,input:focus-visible,.scroll:focus-visible{
outline:2px solid var(--link);outline-offset:2px}
.skip{position:absolute;left:-999rem;top:0;padding:.5rem 1rem;background:var(--paper);z-index:3}
.skip:focus{left:0}
header{padding-top:1.75rem}
h1{font-size:1.8rem;line-height:1.2;margin:0;letter-spacing:-.015em}
h2{font-size:1.35rem;line-height:1.3;margin:3rem 0 .75rem;letter-spacing:-.01em}
h3{font-size:1.05rem;line-height:1.35;margin:0 0 .6rem}
p{margin:.5rem 0;max-width:46rem}
.subtitle,.muted,footer,.tablenote{color:var(--muted)}
.subtitle{margin:.35rem 0 0}
.anchor{color:inherit;text-decoration:none}
.anchor:hover{text-decoration:underline}
.badges{display:flex;flex-wrap:wrap;gap:.4rem;margin:.9rem 0 0;padding:0;list-style:none}
.badges li{font-size:.85rem;line-height:1.3;padding:.2rem .65rem;border-radius:1rem;background:var(--soft);
border:1px solid var(--line)}
.verdict{margin:1.1rem 0 0;padding:.75rem 1rem;border-radius:.4rem;background:var(--soft);
border-left:.3rem solid var(--muted)}
.verdict p{margin:0;max-width:none}.verdict strong{font-size:1.1rem}
.verdict ul{margin:.35rem 0 0;padding-left:1.2rem}
.callout{padding:.6rem .9rem;border-left:.25rem solid var(--muted);background:var(--soft);border-radius:.3rem}
.ok{color:var(--ok)}.fail{color:var(--fail)}.warn{color:var(--warn)}.note{color:var(--note)}
.fail{font-weight:600}
td.ok::before,.badges .ok::before,.verdict.ok strong::before{content:"\2713\00a0"}
td.fail::before,.badges .fail::before,.verdict.fail strong::before{content:"\2717\00a0"}
td.warn::before,.badges .warn::before,.verdict.warn strong::before{content:"!\00a0"}
.badges .ok,.verdict.ok{background:var(--ok-soft);border-color:var(--ok)}
.badges .fail,.verdict.fail{background:var(--fail-soft);border-color:var(--fail)}
.badges .warn,.verdict.warn,.callout.warn{background:var(--warn-soft);border-color:var(--warn)}
.badges .note,.verdict.note,.callout.note{background:var(--note-soft);border-color:var(--note)}
.callout.ok{background:var(--ok-soft);border-color:var(--ok)}
.callout.fail{background:var(--fail-soft);border-color:var(--fail)}
.verdict,.callout{color:var(--ink)!important;font-weight:400}
nav{position:sticky;top:0;z-index:2;background:var(--paper);border-bottom:1px solid var(--line);margin-top:1.25rem}
nav ul{display:flex;gap:1.4rem;max-width:67rem;margin:0 auto;padding:0 1.25rem;list-style:none;overflow-x:auto}
nav a{display:block;padding:.7rem 0;white-space:nowrap;text-decoration:none;color:var(--muted);font-size:.95rem}
nav a:hover{color:var(--ink);box-shadow:inset 0 -2px var(--link)}
figure{margin:1.5rem 0 2.25rem;padding:1.25rem;border:1px solid var(--line);border-radius:.5rem}
.chart{display:flex;flex-wrap:wrap;gap:.5rem 1.5rem;align-items:flex-start}
.plot{flex:3 1 30rem;max-width:45rem;min-width:0}
.plot svg{display:block;width:100%;height:auto}
.legend,.legend ul{list-style:none;margin:0;padding:0}
.legend{flex:1 1 11rem;font-size:.9rem;line-height:1.5;display:grid;align-content:start;
grid-template-columns:repeat(auto-fill,minmax(min(10.5rem,100%),1fr));gap:.1rem 1rem;padding-top:.25rem}
.legend .family{margin-bottom:.5rem}
.legend>li{align-self:start}
.legend.many{flex-basis:100%}
.legend b{color:var(--muted);font-weight:600;font-size:.85rem}
.legend li li,.legend>li[data-series]{display:flex;align-items:center;gap:.5rem}
.legend svg{flex:none;overflow:visible}
.legend li span{min-width:0;overflow-wrap:anywhere}
figcaption p{margin:.6rem 0 0}
figcaption .muted,.tablenote{font-size:.9rem}
details{margin-top:.75rem}
summary{cursor:pointer;color:var(--link);font-size:.9rem;width:fit-content}
.table{margin:1.25rem 0}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:.4rem;max-height:40rem;overflow-y:auto}
table{border-collapse:collapse;width:100%;font-size:.9rem;font-variant-numeric:tabular-nums}
caption{text-align:left;font-weight:600;padding:.6rem .75rem}
th,td{padding:.35rem .75rem;text-align:left;white-space:nowrap;border-top:1px solid var(--line)}
thead th,thead td{position:sticky;top:0;background:var(--soft);font-weight:600}
.rows{color:var(--muted);font-weight:400;padding-left:.5rem}
.unit{color:var(--muted);font-weight:400}
.right{text-align:right}.centre{text-align:center}
td.muted{color:var(--muted)}
tbody tr:hover td{background:var(--soft)}
th button{all:unset;cursor:pointer;font:inherit}
th button::after{content:"\2195";color:var(--muted);font-weight:400;padding-left:.3rem;opacity:.55}
th[aria-sort=ascending] button::after{content:"\2191";opacity:1}
th[aria-sort=descending] button::after{content:"\2193";opacity:1}
.filter{font:inherit;font-size:.9rem;padding:.3rem .6rem;margin:0 0 .5rem;width:16rem;max-width:100%;color:inherit;
background:var(--paper);border:1px solid var(--line);border-radius:.3rem}
pre{overflow-x:auto;padding:.8rem 1rem;background:var(--soft);border-radius:.4rem;font-size:.85rem;line-height:1.45}
footer{margin-top:4rem;padding-top:1rem;padding-bottom:2rem;font-size:.9rem;border-top:1px solid var(--line)}
@media (max-width:34rem){header,main,footer{padding-left:.9rem;padding-right:.9rem}h1{font-size:1.5rem}
figure{margin-left:-.9rem;margin-right:-.9rem;padding:1rem .9rem;border-width:1px 0;border-radius:0}
nav ul{padding:0 .9rem}.plot{flex-basis:100%}}
@media print{nav,.skip,.filter,details:not([open]){display:none}.scroll{max-height:none;overflow:visible;border:0}
figure,table,tr{break-inside:avoid}h2,h3{break-after:avoid}body{font-size:10.5pt}th button::after{content:""}}
)css";

constexpr std::string_view dark =
    R"css(--paper:#0f1318;--ink:#e8ecf1;--muted:#a0a9b4;--line:#2a313a;--soft:#171c23;
--link:#6cb6ff;--ok:#56c98a;--ok-soft:#10281c;--fail:#ff8a80;--fail-soft:#34181a;--warn:#eab54e;--warn-soft:#2e2410;
--note:#6cb6ff;--note-soft:#12253a)css";

constexpr std::string_view script = R"js(
document.querySelectorAll('table').forEach(t=>{const b=t.tBodies[0];if(!b||b.rows.length<2)return;
const heads=[...t.tHead.rows[0].cells];
if(heads.every(h=>h.textContent))heads.forEach((h,i)=>{const k=document.createElement('button');k.type='button';k.append(...h.childNodes);h.append(k);
k.onclick=()=>{const up=h.getAttribute('aria-sort')!=='ascending';heads.forEach(o=>o.removeAttribute('aria-sort'));
h.setAttribute('aria-sort',up?'ascending':'descending');
const key=r=>r.cells[i].dataset.sort??r.cells[i].textContent;
const low=(x,y)=>x!==''&&y!==''&&!isNaN(x)&&!isNaN(y)?x-y:x.localeCompare(y,'en',{numeric:true});
const last=r=>{const s=key(r);return s===''||s==='\u2013'?1:0};
[...b.rows].sort((p,q)=>last(p)-last(q)||(up?1:-1)*low(key(p),key(q))).forEach(r=>b.append(r))}});
if(b.rows.length>12&&!t.closest('details')){const f=document.createElement('input');f.type='search';f.className='filter';
f.placeholder='Filter rows';f.setAttribute('aria-label','Filter rows of '+(t.caption?t.caption.textContent:'table'));
const n=t.querySelector('.rows');
f.oninput=()=>{const w=f.value.toLowerCase();let seen=0;
for(const r of b.rows){r.hidden=!r.textContent.toLowerCase().includes(w);if(!r.hidden)++seen}
if(n)n.textContent=(seen<b.rows.length?seen+' of ':'')+b.rows.length+' rows'};
t.closest('.table').prepend(f)}})
)js";

}  // namespace

std::string page_style() {
  std::string css(light_and_layout);
  fmt::format_to(std::back_inserter(css), "@media screen and (prefers-color-scheme:dark){{:root{{{}}}\n",
                 dark);
  // Swatches of page legends; in pictures each SVG brings its own overrides, markers inside swatches
  // included.
  css += ".legend .halo{stroke:#0f1318}.legend .paper{fill:#0f1318}\n";
  for (int i = 0; i < theme_colour_count(); ++i)
    fmt::format_to(std::back_inserter(css), ".c{}{{color:{}}}", i, theme_colour(i).dark);
  return css + "}\n";
}

std::string_view page_script() { return script; }

}  // namespace odemark
