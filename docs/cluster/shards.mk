# A verification, or a map, in shards on one machine: make -j PROCESSES -f shards.mk QUESTION='puma560 ... --verify 1000000'
# What is there already is not drawn again.

ARMTOL   = armtol
SHARDS   = 8
QUESTION = $(error QUESTION is missing; expected the arguments of armtol)
tallies  = $(addprefix tallies/,$(shell seq $(SHARDS)))

answer: $(tallies)
	$(ARMTOL) merge $^ >$@.part && mv $@.part $@

tallies/%: | tallies
	$(ARMTOL) $(QUESTION) --threads 1 --shard $*/$(SHARDS) --tally $@

tallies:
	mkdir $@
