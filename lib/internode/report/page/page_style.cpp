// SPDX-License-Identifier: MIT

#include "internode/report/page/page_style.h"

#include "internode/report/picture/palette.h"

namespace internode {

namespace {

constexpr std::string_view light = R"(
:root{--ground:#fbfaf7;--card:#ffffff;--ink:#23262b;--soft:#626873;--line:#e3e0d8;--accent:#0b5f97;--error:#cc3311;--envelope:#0077bb;--bisection:#8a7500}
)";

constexpr std::string_view dark = R"(
@media screen and (prefers-color-scheme:dark){
:root{--ground:#15171b;--card:#1d2026;--ink:#e8e6e1;--soft:#a0a5ae;--line:#343942;--accent:#7cc4f5;--error:#ff7a5c;--envelope:#5cb8ff;--bisection:#d6bf4a}
)";

constexpr std::string_view rules = R"(
*{box-sizing:border-box}
html{color-scheme:light dark}
body{margin:0;background:var(--ground);color:var(--ink);font:17px/1.6 Charter,"Bitstream Charter","Iowan Old Style",Georgia,"DejaVu Serif",serif}
main{max-width:58rem;margin:0 auto;padding:3.5rem 1.4rem 2rem}
header p.kicker,h2,figcaption,table,.key,footer,svg{font-family:system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,"DejaVu Sans",sans-serif}
header p.kicker{margin:0;color:var(--soft);font-size:.85rem;letter-spacing:.06em;text-transform:uppercase}
h1{margin:.2rem 0 .6rem;font-size:clamp(1.9rem,5vw,2.9rem);line-height:1.12;font-weight:600;letter-spacing:-.015em;overflow-wrap:anywhere}
header p.lead{max-width:40rem;margin:0 0 2rem;font-size:1.16rem;color:var(--soft)}
h2{margin:3rem 0 .6rem;font-size:1.15rem;font-weight:650}
p{max-width:42rem}
.keys{display:grid;grid-template-columns:repeat(auto-fit,minmax(12.5rem,1fr));gap:1px;margin:0 0 2rem;background:var(--line);border:1px solid var(--line);border-radius:10px;overflow:hidden}
.key{padding:1rem 1.15rem;background:var(--card)}
.key dt{color:var(--soft);font-size:.8rem}
.key dd{margin:.1rem 0 0;font-size:1.42rem;font-weight:600;font-variant-numeric:tabular-nums;overflow-wrap:anywhere}
.key dd small{display:block;font-size:.83rem;font-weight:400;color:var(--soft)}
figure{margin:1.4rem 0;padding:1rem 1rem .8rem;background:var(--card);border:1px solid var(--line);border-radius:10px}
figure svg{display:block;width:100%;height:auto}
figcaption{margin:.5rem .3rem 0;color:var(--soft);font-size:.88rem;line-height:1.5}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,25rem),1fr));gap:1.2rem}
.pair figure{margin:0}
.scroll{overflow-x:auto}
table{width:100%;border-collapse:collapse;font-size:.92rem;font-variant-numeric:tabular-nums}
th,td{padding:.42rem .8rem;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--soft);font-weight:500;border-bottom-color:var(--soft)}
td.symbol,th.symbol{text-align:left}
code{font:.9em ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace;overflow-wrap:anywhere}
.whole{white-space:nowrap}
footer{margin-top:3.5rem;padding-top:1rem;border-top:1px solid var(--line);color:var(--soft);font-size:.82rem}
svg .grid path{stroke:var(--line);stroke-width:1;fill:none}
svg .grid text{fill:var(--soft)}
svg .line{fill:none;stroke-width:2}
svg .error{fill:var(--error);stroke:none}svg .error .line{fill:none;stroke:var(--error)}
svg .envelope{fill:var(--envelope);stroke:none}svg .envelope .line{fill:none;stroke:var(--envelope);stroke-dasharray:6 4}
svg .bisection{fill:var(--bisection);stroke:none}svg .bisection .line{fill:none;stroke:var(--bisection);stroke-dasharray:2 3}
svg .guide .line{stroke:var(--soft);stroke-width:1.2;stroke-dasharray:9 4}
@media print{
:root{--ground:#fff;--card:#fff;--ink:#000;--soft:#444;--line:#ccc;--error:#cc3311;--envelope:#0077bb;--bisection:#8a7500}
body{font-size:11pt}main{max-width:none;padding:0}figure,.keys,table{break-inside:avoid}h2{break-after:avoid}
}
)";

} // namespace

std::string page_style() {
    std::string text(light);
    text += dark;
    for (std::size_t i = 0; i < palette_colours; ++i)
        text += "svg .s" + std::to_string(i) + "{stroke:" + std::string(symbol_style(to_symbol(i)).dark_colour) + "}\n";
    text += "svg #knots path:last-child{stroke:var(--card)}svg #knots path:first-child{stroke:var(--ink)}\n}\n";
    return text + std::string(rules);
}

} // namespace internode
