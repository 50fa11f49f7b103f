cd golden/armtol && armtol level.csv --joints 10,30,-60 --accuracy .002,.002,.002,.2,.2,.2 --payload 5 --budget --svg -
