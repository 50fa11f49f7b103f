docs/lab-book/tools/plane-of svg intelledex605t corrected
