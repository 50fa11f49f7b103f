cd golden/armtol && armtol map level.csv --plane xz --range -.7..0.7,-.3..0.9 --step .05 --what droop --payload 5 --svg -
