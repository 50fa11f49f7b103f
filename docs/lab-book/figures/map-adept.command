docs/lab-book/tools/plane-of svg adeptone published
