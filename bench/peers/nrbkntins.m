% SPDX-License-Identifier: MIT
% octave-nurbs' nrbkntins on the case that internode_bench --case wrote; prints what scipy_insert.py prints.
% usage: octave-cli -q nrbkntins.m FOLDER
pkg load nurbs
function values = read(name)
  file = fopen(fullfile(argv(){1}, [name '.f64']));
  values = fread(file, Inf, 'double')';
  fclose(file);
end
curve = nrbmak(reshape(read('points'), 3, []), read('coarse'));
inserted = read('inserted');
fine = reshape(read('fine'), 3, []);
start = cputime();
curve = nrbkntins(curve, inserted);
seconds = cputime() - start;
printf('%.9g %.3g\n', seconds, max(abs(curve.coefs(1:3, :) - fine)(:)) / max(abs(fine(:))));
