armtol map scara --plane xy --offset 200 --range -630..630,-630..630 --step 30 --joints 30,-70,187,15 --degrees --accuracy .02,.02,.02,.01,.01,.01 --of dx --svg -
